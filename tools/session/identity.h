// What a picture depends on: the program, the options that decide its pixels, its frame's clock,
// and what its scene saw outside. A picture is continued (+C) only if all of it is as it was. One
// thread.
#pragma once

#include <string>

#include "parser/options/animation.h"
#include "parser/options/options.h"
#include "tools/session/seen.h"

namespace lentray::tool {

struct Identity {
  std::string program;  ///< changes whenever the program does
  std::string options;  ///< lines
  Seen seen{};          ///< with checksums alone; the scene's path is ""

  /// JSON.
  std::string text() const;
  /// Of the text, as a word.
  std::string sum() const;
  /// Of text(); throws std::invalid_argument.
  static Identity of_text(const std::string& text);
};

/// A line for the clock and one for the frame, with all figures.
std::string clock_line(const parser::FrameClock& clock);
std::string frame_number_line(const parser::FrameClock& clock);

/// Without what was seen.
Identity identity_of(const parser::RenderOptions& options, const parser::FrameClock& clock);

/// What is different now, ready to follow "the picture cannot be continued: "; empty: nothing.
std::string difference(const Identity& then, const Identity& now);

}  // namespace lentray::tool
