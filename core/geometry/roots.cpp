#include "core/geometry/roots.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lentray::core {
namespace {

constexpr int kMaxOrder = 36;

double value(const double* c, int order, double x) {
  double r = c[0];
  for (int i = 1; i <= order; ++i) r = r * x + c[i];
  return r;
}

/// The root in [lo, hi], where the values flo and fhi have opposite signs.
double bracketed(const double* c, int order, double lo, double hi, double flo) {
  constexpr double kClose = 2.3e-16;
  constexpr int kMaxSteps = 100;
  double x = 0.5 * (lo + hi);
  for (int step = 0; step < kMaxSteps; ++step) {
    double f = c[0], slope = 0.0;
    for (int i = 1; i <= order; ++i) {
      slope = slope * x + f;
      f = f * x + c[i];
    }
    if (f == 0.0) return x;
    ((f < 0.0) == (flo < 0.0) ? lo : hi) = x;
    double next = x - f / slope;
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    const double change = std::fabs(next - x);
    x = next;
    if (change <= kClose * std::fabs(x) || hi - lo <= kClose * std::max(std::fabs(lo), std::fabs(hi)))
      break;
  }
  return x;
}

int solve_low_order(const double* c, int order, double lo, double hi, double* roots) {
  double found[2];
  int n = 0;
  if (order == 2) {
    n = solve_quadratic(c[0], c[1], c[2], found);
  } else if (c[0] != 0.0) {
    found[n++] = -c[1] / c[0];
  }
  int kept = 0;
  for (int i = 0; i < n; ++i) {
    if (found[i] >= lo && found[i] <= hi) roots[kept++] = found[i];
  }
  return kept;
}

/// A bound of the size of all roots (Fujiwara 1916).
double roots_bound(const double* c, int order) {
  double bound = 0.0;
  for (int k = 1; k <= order; ++k) {
    const double share = k == order ? 0.5 : 1.0;
    bound = std::max(bound, std::pow(std::fabs(c[k] / c[0]) * share, 1.0 / k));
  }
  return 2.0 * bound;
}

int solve_unbounded(const double* c, int order, double roots[4]) {
  while (order > 2 && c[0] == 0.0) {
    ++c;
    --order;
  }
  if (order == 2) return solve_quadratic(c[0], c[1], c[2], roots);
  const double bound = roots_bound(c, order);
  if (!std::isfinite(bound)) return solve_unbounded(c + 1, order - 1, roots);
  return solve_between(c, order, -bound, bound, roots);
}

}  // namespace

int solve_quadratic(double a, double b, double c, double roots[2]) {
  if (a == 0.0) {
    if (b == 0.0) return 0;
    roots[0] = -c / b;
    return 1;
  }
  const double d = b * b - 4.0 * a * c;
  if (!(d >= 0.0)) return 0;
  const double q = -0.5 * (b + std::copysign(std::sqrt(d), b));
  if (q == 0.0) {
    roots[0] = 0.0;
    return 1;
  }
  roots[0] = c / q;
  roots[1] = q / a;
  if (!std::isfinite(roots[1])) return 1;
  if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  return 2;
}

int solve_cubic(double a, double b, double c, double d, double roots[3]) {
  const double coefficients[4] = {a, b, c, d};
  double found[4];
  const int n = solve_unbounded(coefficients, 3, found);
  std::copy(found, found + n, roots);
  return n;
}

int solve_quartic(const double c[5], double roots[4]) { return solve_unbounded(c, 4, roots); }

int solve_between(const double* c, int order, double lo, double hi, double* roots) {
  while (order > 1 && c[0] == 0.0) {
    ++c;
    --order;
  }
  if (!(lo <= hi)) return 0;
  if (order <= 2) return solve_low_order(c, order, lo, hi, roots);
  double derivative[kMaxOrder];
  for (int i = 0; i < order; ++i) derivative[i] = c[i] * (order - i);
  double turns[kMaxOrder + 1];
  int pieces = solve_between(derivative, order - 1, lo, hi, turns);
  turns[pieces++] = hi;
  double a = lo, fa = value(c, order, a);
  int n = 0;
  if (fa == 0.0) roots[n++] = a;
  for (int i = 0; i < pieces; ++i) {
    const double b = turns[i], fb = value(c, order, b);
    if (fb == 0.0) {
      if (n < order && (n == 0 || roots[n - 1] != b)) roots[n++] = b;
    } else if (fa != 0.0 && (fa < 0.0) != (fb < 0.0) && n < order) {
      roots[n++] = bracketed(c, order, a, b, fa);
    }
    a = b;
    fa = fb;
  }
  return n;
}

int solve_between_bounds(const double* c, int order, double lo, double hi, double* roots) {
  while (order > 1 && c[0] == 0.0) {
    ++c;
    --order;
  }
  const double bound = order > 1 ? roots_bound(c, order) : std::numeric_limits<double>::infinity();
  if (!std::isfinite(bound) && order > 1) return solve_between_bounds(c + 1, order - 1, lo, hi, roots);
  return solve_between(c, order, std::max(lo, -bound), std::min(hi, bound), roots);
}

}  // namespace lentray::core
