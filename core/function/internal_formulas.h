// The formulas behind function { internal(n) }, by the names functions.inc gives them.
// Arguments: x, y, z, then the parameters P0, P1 ... of functions.inc. Pure; any number of threads.
// Source: reference manual 3.7, "functions.inc"; signs, limits and special cases are those of stock,
// compared by tests/compat/language/internals.cases.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

#include "core/base/pair_math.h"

namespace lentray::core {

struct InternalFormula {
  std::string_view name;
  int number;  ///< of function { internal(number) }
  int extra;   ///< parameters beside x, y, z
  double (*evaluate)(const double* arguments);
  /// The same at two points, in less time than one after the other; null where there is nothing to gain.
  Pair (*evaluate_pair)(const Pair* arguments) = nullptr;
};

std::span<const InternalFormula> algebraic_formulas();  ///< polynomials in x, y, z
std::span<const InternalFormula> curve_formulas();      ///< plane curves, turned about y on demand
std::span<const InternalFormula> solid_formulas();      ///< distances of round things
std::span<const InternalFormula> noise_formulas();      ///< made of noise

/// The arguments with their squares at hand.
struct FormulaPoint {
  double x, y, z, x2, y2, z2;
  const double* p;
  explicit FormulaPoint(const double* a)
      : x(a[0]), y(a[1]), z(a[2]), x2(x * x), y2(y * y), z2(z * z), p(a + 3) {}
  double square() const { return x2 + y2 + z2; }
  double ring2() const { return x2 + z2; }  ///< squared distance from the y axis
  double ring() const { return std::sqrt(ring2()); }
};

template <class Number>
Number squared(Number v) {
  return v * v;
}
inline double cubed(double v) { return v * v * v; }

/// What a formula says of the point that the arguments name.
using PointFormula = double (*)(const FormulaPoint& q);
template <PointFormula kValue>
double at_point(const double* a) {
  return kValue(FormulaPoint(a));
}

/// A field of strength P0, held within +-10.
template <PointFormula kValue>
double limited(const FormulaPoint& q) {
  return std::clamp(q.p[0] * kValue(q), -10.0, 10.0);
}

}  // namespace lentray::core
