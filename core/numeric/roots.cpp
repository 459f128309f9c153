#include "core/numeric/roots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lentray::core {
namespace {

constexpr int kMaxOrder = 36;

// Functions of kOrder know the order when they are compiled, so that their loops unroll; that of
// kAnyOrder takes it as it comes. The operations and so the roots' bits are the same.
constexpr int kAnyOrder = 0;

template <int kOrder>
double value(const double* c, int any_order, double x) {
  const int order = kOrder != kAnyOrder ? kOrder : any_order;
  double r = c[0];
#pragma GCC unroll 8
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
template <int kOrder>
double bracketed(const double* c, int any_order, double lo, double hi, double flo, double fhi) {
  const int order = kOrder != kAnyOrder ? kOrder : any_order;
  constexpr double kClose = 2.3e-16, kLarge = 1e-3;
  constexpr int kMaxSteps = 200;
  if (lo < 0.0 && hi > 0.0 && c[order] != 0.0) {
    const bool is_above = (c[order] < 0.0) == (flo < 0.0);
    (is_above ? lo : hi) = 0.0;
    (is_above ? flo : fhi) = c[order];
  }
  // Where the line between the ends is 0.
  double x = lo + (hi - lo) * (flo / (flo - fhi)), last = hi - lo;
  if (!(x > lo && x < hi)) x = 0.5 * (lo + hi);
  for (int step = 0; step < kMaxSteps; ++step) {
    double f = c[0], slope = 0.0;
#pragma GCC unroll 8
    for (int i = 1; i <= order; ++i) {
      slope = slope * x + f;
      f = f * x + c[i];
    }
    if (f == 0.0) return x;
    ((f < 0.0) == (flo < 0.0) ? lo : hi) = x;
    double next = x - f / slope;
    const double step_size = std::fabs(next - x);
    // One end of the bracket is x by now: its middle would begin again from afar.
    if (step_size <= kClose * std::fabs(x)) return x;
    const bool crawls = step_size > 0.5 * last && step_size > kLarge * std::fabs(x);
    if (crawls || !(next > lo && next < hi)) next = middle_of(lo, hi);
    const double change = std::fabs(next - x);
    last = change;
    x = next;
    if (change <= kClose * std::fabs(x) ||
        hi - lo <= kClose * std::max(std::fabs(lo), std::fabs(hi)))
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
  double derivative[kMaxOrder] = {};
  for (int i = 0; i < order; ++i) derivative[i] = c[i] * (order - i);
  double turns[kMaxOrder + 1];
  int pieces = solve_pieces(derivative, order - 1, lo, hi, rootless - 1, turns);
  turns[pieces++] = hi;
  double a = lo, fa = value<kAnyOrder>(c, order, a);
  int n = 0;
  if (fa == 0.0) roots[n++] = a;
  for (int i = 0; i < pieces; ++i) {
    const double b = turns[i], fb = value<kAnyOrder>(c, order, b);
    if (fb == 0.0) {
      if (n < order && (n == 0 || roots[n - 1] != b)) roots[n++] = b;
    } else if (fa != 0.0 && (fa < 0.0) != (fb < 0.0) && n < order) {
      roots[n++] = bracketed<kAnyOrder>(c, order, a, b, fa, fb);
    }
    a = b;
    fa = fb;
  }
  return n;
}

/// Highest order whose roots are first parted by Bernstein coefficients.
constexpr int kMostParted = 12;

using Binomials = std::array<std::array<double, kMostParted + 1>, kMostParted + 1>;
constexpr Binomials kInverseBinomials = [] {
  Binomials all{};
  for (int n = 0; n <= kMostParted; ++n) {
    double ways = 1.0;
    for (int k = 0; k <= n; ++k) {
      all[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)] = 1.0 / ways;
      ways = ways * (n - k) / (k + 1);
    }
  }
  return all;
}();

/// Parts an interval until the signs of the Bernstein coefficients show that a piece has no root or
/// one (Descartes' rule); pieces that stay unclear go to solve_pieces.
template <int kOrder>
class RootParting {
 public:
  RootParting(const double* c, double* roots, bool first_alone)
      : m_c(c), m_roots(roots), m_first_alone(first_alone) {}

  int solve(double lo, double hi) {
    double b[kOrder + 1];
    expand(lo, hi - lo, b);
    part(b, lo, hi, 0);
    return m_count;
  }

 private:
  static constexpr int kMostDepth = 5;
  enum class Signs { kNone, kOne, kUnclear };

  /// Coefficients over lo .. lo + h, and how far off rounding can have them, generously.
  void expand(double lo, double h, double* b) {
    constexpr double kRounding = 1e-12;
    const double reach = std::fabs(lo) + h;
    double size = 0.0;
#pragma GCC unroll 8
    for (int i = 0; i <= kOrder; ++i) {
      b[kOrder - i] = m_c[i];  // of rising powers
      size = size * reach + std::fabs(m_c[i]);
    }
    m_rounding = kRounding * size;
#pragma GCC unroll 8
    for (int k = 0; k < kOrder; ++k) {
#pragma GCC unroll 8
      for (int i = kOrder - 1; i >= k; --i) b[i] += b[i + 1] * lo;
    }
    const auto& inverse = kInverseBinomials[static_cast<std::size_t>(kOrder)];
    double power = 1.0;
#pragma GCC unroll 8
    for (int k = 0; k <= kOrder; ++k) {
      b[k] *= power * inverse[static_cast<std::size_t>(k)];
      power *= h;
    }
#pragma GCC unroll 8
    for (int r = 1; r <= kOrder; ++r) {
#pragma GCC unroll 8
      for (int j = kOrder; j >= r; --j) b[j] += b[j - 1];
    }
  }

  Signs signs(const double* b) const {
    double least = b[0], most = b[0];
#pragma GCC unroll 8
    for (int i = 1; i <= kOrder; ++i) {
      least = b[i] < least ? b[i] : least;
      most = b[i] > most ? b[i] : most;
    }
    if (least > m_rounding || most < -m_rounding) return Signs::kNone;  // what most ask for
    int changes = 0, last = 0;
    int doubtful = 0;  // coefficients of any sign since the last clear one
    for (int i = 0; i <= kOrder; ++i) {
      const int sign = b[i] > m_rounding ? 1 : b[i] < -m_rounding ? -1 : 0;
      if (sign == 0) {
        if (i == 0 || i == kOrder) return Signs::kUnclear;
        ++doubtful;
        continue;
      }
      // One between different signs changes nothing; two may make one change three.
      if (doubtful > (sign == last ? 0 : 1)) return Signs::kUnclear;
      doubtful = 0;
      if (last != 0 && sign != last && ++changes > 1) return Signs::kUnclear;
      last = sign;
    }
    return changes == 0 ? Signs::kNone : Signs::kOne;
  }

  void part(const double* b, double lo, double hi, int depth) {
    const Signs found = signs(b);
    if (found == Signs::kNone) return;
    if (found == Signs::kOne) {
      const double flo = value<kOrder>(m_c, kOrder, lo), fhi = value<kOrder>(m_c, kOrder, hi);
      if ((flo < 0.0 && fhi > 0.0) || (flo > 0.0 && fhi < 0.0)) {
        add(bracketed<kOrder>(m_c, kOrder, lo, hi, flo, fhi));
        return;
      }
    }
    const double middle = 0.5 * (lo + hi);
    if (found == Signs::kOne || depth == kMostDepth || !(middle > lo && middle < hi)) {
      double roots[kOrder];
      const int n =
          solve_pieces(m_c, kOrder, lo, hi, rootless_derivative(m_c, kOrder, lo, hi), roots);
      for (int i = 0; i < n; ++i) add(roots[i]);
      return;
    }
    double left[kOrder + 1], right[kOrder + 1];
    std::copy_n(b, kOrder + 1, right);
#pragma GCC unroll 8
    for (int i = 0; i <= kOrder; ++i) {
      left[i] = right[0];
#pragma GCC unroll 8
      for (int j = 0; j < kOrder - i; ++j) right[j] = 0.5 * (right[j] + right[j + 1]);
    }
    part(left, lo, middle, depth + 1);
    if (m_first_alone && m_count > 0) return;
    part(right, middle, hi, depth + 1);
  }

  void add(double root) {
    if (m_count < kOrder && (m_count == 0 || m_roots[m_count - 1] != root))
      m_roots[m_count++] = root;
  }

  const double* m_c;
  double* m_roots;
  bool m_first_alone;
  int m_count = 0;
  double m_rounding = 0.0;
};

/// The same where the order is known only now.
int solve_parted(const double* c, int order, double lo, double hi, double* roots, bool first) {
  switch (order) {
    case 3: return RootParting<3>(c, roots, first).solve(lo, hi);
    case 4: return RootParting<4>(c, roots, first).solve(lo, hi);
    case 5: return RootParting<5>(c, roots, first).solve(lo, hi);
    case 6: return RootParting<6>(c, roots, first).solve(lo, hi);
    case 7: return RootParting<7>(c, roots, first).solve(lo, hi);
    case 8: return RootParting<8>(c, roots, first).solve(lo, hi);
    case 9: return RootParting<9>(c, roots, first).solve(lo, hi);
    case 10: return RootParting<10>(c, roots, first).solve(lo, hi);
    case 11: return RootParting<11>(c, roots, first).solve(lo, hi);
    default: return RootParting<kMostParted>(c, roots, first).solve(lo, hi);
  }
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

int solve_between(const double* c, int order, double lo, double hi, double* roots,
                  bool first_alone) {
  while (order > 1 && c[0] == 0.0) {
    ++c;
    --order;
  }
  if (!(lo <= hi)) return 0;
  if (order <= 2) return solve_low_order(c, order, lo, hi, roots);
  if (order <= kMostParted && lo < hi) return solve_parted(c, order, lo, hi, roots, first_alone);
  return solve_pieces(c, order, lo, hi, rootless_derivative(c, order, lo, hi), roots);
}

int solve_between_bounds(const double* c, int order, double lo, double hi, double* roots,
                         bool first_alone) {
  while (order > 1 && c[0] == 0.0) {
    ++c;
    --order;
  }
  const double bound = order > 1 ? roots_bound(c, order) : std::numeric_limits<double>::infinity();
  if (!std::isfinite(bound) && order > 1)
    return solve_between_bounds(c + 1, order - 1, lo, hi, roots, first_alone);
  const double from = std::max(lo, -bound), to = std::min(hi, bound);
  // Of a cubic over all that a ray has before it the derivative's roots are found at once: cheaper.
  if (order == 3 && from <= to && !std::isfinite(hi)) {
    return solve_pieces(c, order, from, to, rootless_derivative(c, order, from, to), roots);
  }
  return solve_between(c, order, from, to, roots, first_alone);
}

}  // namespace lentray::core
