// What antialiasing a picture is asked for, and the options that make both renderers do so.
// Source: reference manual 3.7, "Antialiasing Options". Pure.
#pragma once

#include <string>
#include <vector>

namespace lentray::parser {
struct RenderOptions;
}

namespace lentray::diff {

struct Antialiasing {
  bool on = false;
  int method = 1;          ///< 1: adaptive, 2: recursive
  double threshold = 0.3;  ///< 0..1
  int depth = 3;           ///< 1..9
  double jitter = 1.0;     ///< 0..1; 0: none
  double gamma = 2.5;      ///< in which colours are compared
  int angles = 1;          ///< Antialias_Angle, which only lentray knows; also without the rest
};

/// As lentray understands its options. Throws parser::OptionError where POV-Ray has nothing like it.
Antialiasing antialiasing_of(const parser::RenderOptions& options);

/// Options of stock, to which lentray listens as well.
std::vector<std::string> words(const Antialiasing& antialiasing);

/// Whether both renderers throw dice: then no two pictures are equal.
bool is_random(const Antialiasing& antialiasing);

}  // namespace lentray::diff
