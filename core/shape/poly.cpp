#include "core/shape/poly.h"

#include <limits>

#include "core/numeric/roots.h"

namespace lentray::core {
namespace {

constexpr int kMost = kMaxPolyOrder + 1;
constexpr int kNested = 6;  ///< highest order whose rays' polynomials are worked out without loops

/// powers[n][m]: coefficient of t^m in (p + d t)^n, for n up to `order`.
void powers_of(double p, double d, int order, double (&powers)[kMost][kMost]) {
  powers[0][0] = 1.0;
  for (int n = 1; n <= order; ++n) {
    powers[n][0] = powers[n - 1][0] * p;
    for (int m = 1; m < n; ++m) powers[n][m] = powers[n - 1][m] * p + powers[n - 1][m - 1] * d;
    powers[n][n] = powers[n - 1][n - 1] * d;
  }
}

/// c = c (p + d t), of `kOrder` before.
template <int kOrder>
inline void times_line(double* c, double p, double d) {
  c[kOrder + 1] = c[kOrder] * d;
#pragma GCC unroll 8
  for (int m = kOrder; m > 0; --m) c[m] = c[m] * p + c[m - 1] * d;
  c[0] *= p;
}

/// The ray's start and direction along one axis.
struct Along {
  double p, d;
};

/// Horner's rule with a line for the variable, in z, then y, then x: the polynomial, of rising
/// powers of t, whose coefficients follow one another at `from`. `kVariables` is 1 for z alone.
template <int kVariables, int kOrder>
struct Nested {
  template <int kDone = 0>
  static inline const double* sum(const Along* axes, const double* from, double* out) {
    if constexpr (kDone > 0) times_line<kDone - 1>(out, axes[0].p, axes[0].d);
    if constexpr (kVariables == 1) {
      out[0] = kDone > 0 ? out[0] + *from : *from;
      ++from;
    } else {
      // What the power of this variable that is left, kOrder - kDone, is multiplied by.
      double inner[kDone + 1];
      from = Nested<kVariables - 1, kDone>::sum(axes + 1, from, inner);
      for (int m = 0; m < kDone; ++m) out[m] += inner[m];
      out[kDone] = kDone > 0 ? out[kDone] + inner[kDone] : inner[kDone];
    }
    if constexpr (kDone < kOrder) {
      return sum<kDone + 1>(axes, from, out);
    } else {
      return from;
    }
  }
};

double power(double x, int n) {
  double r = 1.0;
  for (; n > 0; --n) r *= x;
  return r;
}

}  // namespace

Poly::Poly(std::string_view name, int order, const std::vector<double>& coefficients)
    : m_name(name), m_order(order) {
  if (order <= kNested) m_all = coefficients;
  m_all.resize(static_cast<std::size_t>((order + 1) * (order + 2) * (order + 3) / 6));
  std::size_t next = 0;
  for (int i = order; i >= 0; --i) {
    for (int j = order - i; j >= 0; --j) {
      for (int k = order - i - j; k >= 0; --k) {
        const double c = next < coefficients.size() ? coefficients[next] : 0.0;
        ++next;
        if (c != 0.0) m_terms.push_back({c, i, j, k});
      }
    }
  }
}

double Poly::value(const Vec3& p) const {
  double sum = 0.0;
  for (const Term& t : m_terms) sum += t.c * power(p.x, t.i) * power(p.y, t.j) * power(p.z, t.k);
  return sum;
}

/// The polynomial of t at p + d t, highest power first.
template <int kOrder>
void Poly::along(const Vec3& p, const Vec3& d, double* c) const {
  const Along axes[3] = {{p.x, d.x}, {p.y, d.y}, {p.z, d.z}};
  double rising[kOrder + 1];
  Nested<3, kOrder>::sum(axes, m_all.data(), rising);
  for (int m = 0; m <= kOrder; ++m) c[m] = rising[kOrder - m];
}

/// The same of any order. Terms of the same power of x, and of x and y, come one after the other and
/// are multiplied by it once.
void Poly::along_any(const Vec3& p, const Vec3& d, double* c) const {
  double x[kMost][kMost], y[kMost][kMost], z[kMost][kMost];
  powers_of(p.x, d.x, m_order, x);
  powers_of(p.y, d.y, m_order, y);
  powers_of(p.z, d.z, m_order, z);
  const auto add_product = [](const double* by, int by_order, const double* from, int order,
                              double* to) {
    for (int a = 0; a <= by_order; ++a) {
      for (int b = 0; b <= order; ++b) to[a + b] += by[a] * from[b];
    }
  };
  double line[kMost] = {};  // of rising powers
  for (auto t = m_terms.begin(); t != m_terms.end();) {
    const int i = t->i, rest = m_order - i;
    double plane[kMost] = {};
    while (t != m_terms.end() && t->i == i) {
      const int j = t->j, most = t->k;
      double row[kMost] = {};
      for (; t != m_terms.end() && t->i == i && t->j == j; ++t) {
        for (int b = 0; b <= t->k; ++b) row[b] += t->c * z[t->k][b];
      }
      add_product(y[j], j, row, most, plane);
    }
    add_product(x[i], i, plane, rest, line);
  }
  for (int m = 0; m <= m_order; ++m) c[m] = line[m_order - m];
}

/// Those that lie between t_min and infinity, ascending; the first, and maybe others, if it is asked for alone.
int Poly::crossings(const Ray& ray, double t_min, double t_max, bool first_alone,
                    double* roots) const {
  // Counted from the ray's nearest point to the origin and in unit lengths, so that coefficients
  // stay small.
  const double length_of_unit = length(ray.direction);
  const Vec3 d = ray.direction / length_of_unit;
  const double shift = -dot(ray.origin, d);
  const Vec3 p = ray.origin + d * shift;
  // t_max does not cut: the roots' last bits would depend on what else the ray has hit.
  double from = t_min * length_of_unit - shift, to = std::numeric_limits<double>::infinity();
  if (t_max * length_of_unit - shift <= from || !m_kept.cut({p, d}, from, to)) return 0;
  std::array<double, kMost> c;
  switch (m_order) {
    case 2: along<2>(p, d, c.data()); break;
    case 3: along<3>(p, d, c.data()); break;
    case 4: along<4>(p, d, c.data()); break;
    case 5: along<5>(p, d, c.data()); break;
    case 6: along<6>(p, d, c.data()); break;
    default: along_any(p, d, c.data());
  }
  const auto solve = [&](bool first) {
    const int n = m_kept.is_finite()
                      ? solve_between(c.data(), m_order, from, to, roots, first)
                      : solve_between_bounds(c.data(), m_order, from, to, roots, first);
    for (int i = 0; i < n; ++i) roots[i] = (roots[i] + shift) / length_of_unit;
    return n;
  };
  const int n = solve(first_alone);
  // By rounding the first may lie before t_min.
  return first_alone && n > 0 && !(roots[n - 1] > t_min) ? solve(false) : n;
}

bool Poly::within(const Vec3& p) const {
  constexpr double kInside = 1e-4;
  return value(p) < kInside;
}

Vec3 Poly::normal(const Vec3& p, const ShapeHit&) const {
  Vec3 n;
  for (const Term& t : m_terms) {
    const double x = power(p.x, t.i), y = power(p.y, t.j), z = power(p.z, t.k);
    if (t.i > 0) n.x += t.c * t.i * power(p.x, t.i - 1) * y * z;
    if (t.j > 0) n.y += t.c * t.j * x * power(p.y, t.j - 1) * z;
    if (t.k > 0) n.z += t.c * t.k * x * y * power(p.z, t.k - 1);
  }
  return n == Vec3{} ? Vec3{1, 0, 0} : n;
}

}  // namespace lentray::core
