// The real roots of a polynomial with the very coefficients that the solvers are given, to 100
// digits, and how well double precision can know them at all. Any thread.
#pragma once

#include "tests/stability/polynomials/polynomial.h"

namespace lentray::stability {

/// Product of (x - root), of (x^2 - 2 re x + re^2 + im^2) and of `leading`, multiplied out in 100
/// digits and then rounded.
struct Factors {
  double leading = 1.0;
  Roots roots;
  std::vector<std::array<double, 2>> pairs;  ///< re, im of complex pairs
};
Polynomial expanded(const Factors& factors);

struct TrueRoot {
  double x = 0.0;
  /// Relative change of the root, at most, that relative changes of the coefficients make, a unit
  /// for a unit; infinite for a double root.
  double condition = 0.0;
  /// Between it and the next root the polynomial stays within the rounding of its own evaluation:
  /// whether there are two roots or none is chance.
  bool is_hidden = false;
};

class Truth {
 public:
  explicit Truth(const Polynomial& p);
  const std::vector<TrueRoot>& roots() const { return m_roots; }
  /// |p(x)| is below the rounding of its own evaluation.
  bool is_zero_within_rounding(double x) const;

 private:
  Polynomial m_polynomial;
  std::vector<TrueRoot> m_roots;
};

}  // namespace lentray::stability
