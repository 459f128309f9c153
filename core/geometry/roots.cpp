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

/// Between lo and hi; by their sizes' middle where these are decades apart, as the roots of such
/// polynomials are.
double middle_of(double lo, double hi) {
  constexpr double kApart = 64.0;
  if (lo < 0.0 && hi > 0.0) return 0.5 * (lo + hi);
  const double a = std::fabs(lo), b = std::fabs(hi);
  const double less = std::min(a, b), more = std::max(a, b);
  if (more <= kApart * less) return 0.5 * (lo + hi);
  const double size = less > 0.0 ? std::sqrt(less) * std::sqrt(more) : more / kApart;
  return std::copysign(size, a > b ? lo : hi);
}

/// The root in [lo, hi], where the values flo and fhi have opposite signs. Large Newton steps that
/// do not halve from one to the next only crawl, as they do far from all roots: none is taken.
double bracketed(const double* c, int order, double lo, double hi, double flo) {
  constexpr double kClose = 2.3e-16, kLarge = 1e-3;
  constexpr int kMaxSteps = 200;
  if (lo < 0.0 && hi > 0.0 && c[order] != 0.0) ((c[order] < 0.0) == (flo < 0.0) ? lo : hi) = 0.0;
  double x = 0.5 * (lo + hi), last = hi - lo;
  for (int step = 0; step < kMaxSteps; ++step) {
    double f = c[0], slope = 0.0;
    for (int i = 1; i <= order; ++i) {
      slope = slope * x + f;
      f = f * x + c[i];
    }
    if (f == 0.0) return x;
    ((f < 0.0) == (flo < 0.0) ? lo : hi) = x;
    double next = x - f / slope;
    const double step_size = std::fabs(next - x);
    const bool crawls = step_size > 0.5 * last && step_size > kLarge * std::fabs(x);
    if (crawls || !(next > lo && next < hi)) next = middle_of(lo, hi);
    const double change = std::fabs(next - x);
    last = change;
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

/// The lowest derivative (0: the polynomial itself) that the terms of its expansion about the middle
/// show to have no root in [lo, hi]; `order` if that is only known of the last.
int rootless_derivative(const double* c, int order, double lo, double hi) {
  constexpr double kRounding = 1e-6;  // far above that of the expansion
  const double middle = 0.5 * (lo + hi), half = 0.5 * (hi - lo), reach = std::fabs(middle) + half;
  double term[kMaxOrder + 1], size = 0.0, power = 1.0;
  for (int i = 0; i <= order; ++i) {
    term[i] = c[i];
    size = size * reach + std::fabs(c[i]);
  }
  for (int k = 0; k <= order; ++k) {
    for (int i = 1; i <= order - k; ++i) term[i] += term[i - 1] * middle;
  }
  for (int k = 0; k <= order; ++k) {
    term[order - k] = std::fabs(term[order - k]) * power;
    power *= half;
  }
  for (int j = 0; j + 2 < order; ++j) {
    double rest = kRounding * size, ways = 1.0;
    for (int k = j + 1; k <= order; ++k) {
      ways *= static_cast<double>(k) / (k - j);
      rest += ways * term[order - k];
    }
    if (term[order - j] > rest) return j;
  }
  return order;
}

/// Order 3 and above; `rootless` says which derivative has no root.
int solve_pieces(const double* c, int order, double lo, double hi, int rootless, double* roots) {
  if (rootless == 0) return 0;
  if (order <= 2) return solve_low_order(c, order, lo, hi, roots);
  double derivative[kMaxOrder];
  for (int i = 0; i < order; ++i) derivative[i] = c[i] * (order - i);
  double turns[kMaxOrder + 1];
  int pieces = solve_pieces(derivative, order - 1, lo, hi, rootless - 1, turns);
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

double root_of(double x, int degree) {
  switch (degree) {
    case 1: return x;
    case 2: return std::sqrt(x);
    case 3: return std::cbrt(x);
    case 4: return std::sqrt(std::sqrt(x));
    default: return std::pow(x, 1.0 / degree);
  }
}

/// A bound of the size of all roots (Fujiwara 1916).
double roots_bound(const double* c, int order) {
  double bound = 0.0;
  for (int k = 1; k <= order; ++k) {
    const double share = k == order ? 0.5 : 1.0;
    bound = std::max(bound, root_of(std::fabs(c[k] / c[0]) * share, k));
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
  return solve_pieces(c, order, lo, hi, rootless_derivative(c, order, lo, hi), roots);
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
