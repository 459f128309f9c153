// Real roots of polynomials up to order 4. Coefficients from the highest power down.
// Closed forms, then polished by Newton steps on the polynomial itself; a leading coefficient 0
// lowers the order. Roots come ascending; a double root comes once or twice.
#pragma once

namespace lentray::core {

/// a x2 + b x + c. Returns the number of roots, 0 also where a = b = 0.
int solve_quadratic(double a, double b, double c, double roots[2]);
/// a x3 + b x2 + c x + d.
int solve_cubic(double a, double b, double c, double d, double roots[3]);
/// c[0] x4 + ... + c[4].
int solve_quartic(const double c[5], double roots[4]);
/// All roots in [lo, hi] of c[0] x^order + ... + c[order], order <= 4, by a Sturm chain and
/// bracketing: slower, and safe where roots nearly coincide. A double root comes once.
int solve_sturm(const double* c, int order, double lo, double hi, double roots[4]);

}  // namespace lentray::core
