// Blend maps as written: values of a pattern (0..1) with what holds there, in the order given.
// A list without values (`checker pigment {A} pigment {B}`) is a map with values 0, 1, 2 ...
// Source: reference manual 3.7, "Color Maps", "Pigment Maps", "Normal Maps", "Slope Maps",
// "Texture Maps", "Density Maps".
#pragma once

#include <vector>

#include "core/base/color.h"
#include "parser/source/source.h"
#include "parser/values/value.h"

namespace lentray::parser {

template <typename Item>
struct BlendEntry {
  double value = 0.0;  ///< pattern value; in `average` maps the weight
  Item item{};
};

struct SlopePoint {
  double height = 0.0, slope = 0.0;
};

struct ColourMapDesc {
  Location where;
  std::vector<BlendEntry<core::Colour>> entries;
};
struct PigmentMapDesc {
  Location where;
  std::vector<BlendEntry<Ref<PigmentDesc>>> entries;
};
struct NormalMapDesc {
  Location where;
  std::vector<BlendEntry<Ref<NormalDesc>>> entries;
};
struct SlopeMapDesc {
  Location where;
  std::vector<BlendEntry<SlopePoint>> entries;
};
struct TextureMapDesc {
  Location where;
  std::vector<BlendEntry<Ref<TextureDesc>>> entries;
};
struct DensityMapDesc {
  Location where;
  std::vector<BlendEntry<Ref<DensityDesc>>> entries;
};

}  // namespace lentray::parser
