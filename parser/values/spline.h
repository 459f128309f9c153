// A spline of SDL: values of 2 to 5 components (or floats) over a parameter.
// Linear, natural: outside the knots the end values. Quadratic: the parabola through the knot
// before, and both ends of the interval. Cubic (Catmull-Rom): from the second to the last knot but
// one; outside, their values.
// Source: reference manual 3.7, "Splines"; ends measured on stock.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace lentray::parser {

enum class SplineKind : std::uint8_t { kLinear, kQuadratic, kCubic, kNatural };

struct SplineKnot {
  double at = 0.0;
  std::array<double, 5> value{};
  std::array<double, 5> curvature{};  ///< second derivatives, of natural splines
};

struct SplineDesc {
  SplineKind kind = SplineKind::kLinear;
  int size = 2;                   ///< components of its values
  std::vector<SplineKnot> knots;  ///< in order
  /// A point at the same `at` as another takes its place, but for the last one of several, which stays: measured on
  /// stock (tests/compat/language/splines.cases).
  void add(double at, const std::array<double, 5>& value);
  void prepare();  ///< once all knots are there
  std::array<double, 5> evaluate(double at) const;
};

}  // namespace lentray::parser
