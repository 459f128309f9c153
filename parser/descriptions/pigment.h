// A pigment as written. Source: reference manual 3.7, "Pigment".
#pragma once

#include <optional>

#include "core/base/color.h"
#include "parser/descriptions/maps.h"
#include "parser/descriptions/pattern.h"

namespace lentray::parser {

struct PigmentDesc {
  Location where;
  PatternDesc pattern;
  core::Colour colour;  ///< of a plain pigment
  /// At most one of the two; none with a pattern means black to white.
  Ref<ColourMapDesc> colour_map;
  Ref<PigmentMapDesc> pigment_map;
  std::optional<core::Colour> quick_colour;  ///< used at quality 5 and below
};

/// The colour of numbers as SDL promotes them: rgb, rgbf, rgbft.
core::Colour to_colour(const Number& number);

}  // namespace lentray::parser
