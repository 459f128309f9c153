// Real roots of polynomials. Coefficients from the highest power down; a leading
// coefficient 0 lowers the order. Roots come ascending, a double root once or twice.
// Order 2 in closed form without cancellation; above, the interval is halved until the signs of the
// Bernstein coefficients show of each piece that it has no root or one (Descartes' rule). Pieces that
// stay unclear, and orders above 12, are split at the derivative's roots into monotonic ones. Each
// root is bracketed then, and found by Newton steps that never leave the bracket. That finds every
// simple root, as a Sturm chain would, for less.
#pragma once

namespace lentray::core {

/// a x2 + b x + c. Returns the number of roots, 0 also where a = b = 0.
int solve_quadratic(double a, double b, double c, double roots[2]);
/// The roots in [lo, hi], both finite, of c[0] x^order + ... + c[order], order 1 to 36; at most
/// `order` of them. Who needs the first alone may say so: more of them may come all the same.
int solve_between(const double* c, int order, double lo, double hi, double* roots,
                  bool first_alone = false);
/// The same where lo and hi may be infinite.
int solve_between_bounds(const double* c, int order, double lo, double hi, double* roots,
                         bool first_alone = false);

}  // namespace lentray::core
