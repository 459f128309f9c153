// What the tilings of golden ratio and fivefold symmetry share. Space: the x-z plane. Pure functions.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lentray::core {

struct GoldenPoint {
  double x = 0.0, z = 0.0;
};

constexpr double kGolden = std::numbers::phi;
constexpr double kGoldenPart = 1.0 / kGolden;
/// Of a right angle's fifth, 18 degrees, times n.
inline double sine_of_fifths(int n) { return std::sin(n * std::numbers::pi / 10.0); }
inline double cosine_of_fifths(int n) { return std::cos(n * std::numbers::pi / 10.0); }
/// The values of neighbouring levels do not touch.
constexpr double kGoldenTrace = 1e-6;

/// The point of its mirror images and turns by 72 degrees that is at most 36 degrees above the x axis.
inline GoldenPoint folded_in_five(GoldenPoint p) {
  static const double cosine = cosine_of_fifths(4), sine = sine_of_fifths(4);
  static const double slope = sine_of_fifths(2) / cosine_of_fifths(2);
  p.z = std::fabs(p.z);
  for (int i = 0; i < 2 && !(p.z <= p.x * slope); ++i) {
    p = {p.x * cosine + p.z * sine, std::fabs(p.z * cosine - p.x * sine)};
  }
  return p;
}

/// The value of a tile of that level at that depth, 1 where the bevel ends.
inline double golden_value(int level, int levels, double depth) {
  const double low = static_cast<double>(level) / levels + (level > 0 ? kGoldenTrace : 0.0);
  const double high = static_cast<double>(level + 1) / levels - kGoldenTrace;
  return std::clamp((level + 1 - depth) / levels, low, high);
}

}  // namespace lentray::core
