// Patterns made of noise: stone, wood, water, skin.
// `generator` is 1..3, see noise.h. A null turbulence means none was written.
// Source: reference manual 3.7, "Bozo", "Granite", "Marble", "Wood", "Agate", "Crackle" ...
#pragma once

#include <optional>

#include "core/noise/noise.h"
#include "core/pattern/pattern.h"

namespace lentray::core {

PatternPtr make_bozo(int generator);
PatternPtr make_dents(int generator);
PatternPtr make_granite(int generator);
PatternPtr make_wrinkles(int generator);
/// These three use the turbulence written outside warps in their own way.
PatternPtr make_marble(const std::optional<Turbulence>& turbulence, int generator);
PatternPtr make_wood(const std::optional<Turbulence>& turbulence);
PatternPtr make_agate(const Turbulence& turbulence, double scale, int generator);
/// spiral1, or the second kind.
PatternPtr make_spiral(int arms, const std::optional<Turbulence>& turbulence, int generator,
                       bool second);
/// frequency and phase move the waves, besides what Wave does with the result.
PatternPtr make_ripples(int sources, double frequency, double phase);
PatternPtr make_waves(int sources, double frequency, double phase);
struct Crackle {
  Vec3 form{-1, 1, 0};
  double metric = 2.0, offset = 0.0;
  bool solid = false;
};
PatternPtr make_crackle(const Crackle& crackle, int generator);

}  // namespace lentray::core
