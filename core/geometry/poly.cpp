#include "core/geometry/poly.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/roots.h"

namespace lentray::core {
namespace {

constexpr int kMost = Poly::kMaxOrder + 1;

/// powers[n][m]: coefficient of t^m in (p + d t)^n, for n up to `order`.
template <int kSize>
void powers_of(double p, double d, int order, double (&powers)[kSize][kSize]) {
  powers[0][0] = 1.0;
  for (int n = 1; n <= order; ++n) {
    powers[n][0] = powers[n - 1][0] * p;
    for (int m = 1; m < n; ++m) powers[n][m] = powers[n - 1][m] * p + powers[n - 1][m - 1] * d;
    powers[n][n] = powers[n - 1][n - 1] * d;
  }
}

double power(double x, int n) {
  double r = 1.0;
  for (; n > 0; --n) r *= x;
  return r;
}

}  // namespace

Poly::Poly(std::string_view name, int order, const std::vector<double>& coefficients)
    : m_name(name), m_order(order) {
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

/// The polynomial of t at p + d t, highest power first. Terms of the same power of x, and of x and
/// y, come one after the other and are multiplied by it once.
template <int kSize>
void Poly::along(const Vec3& p, const Vec3& d, double* c) const {
  double x[kSize][kSize], y[kSize][kSize], z[kSize][kSize];
  powers_of(p.x, d.x, m_order, x);
  powers_of(p.y, d.y, m_order, y);
  powers_of(p.z, d.z, m_order, z);
  const auto add_product = [](const double* by, int by_order, const double* from, int order, double* to) {
    for (int a = 0; a <= by_order; ++a) {
      for (int b = 0; b <= order; ++b) to[a + b] += by[a] * from[b];
    }
  };
  double line[kSize] = {};  // of rising powers
  for (auto t = m_terms.begin(); t != m_terms.end();) {
    const int i = t->i, rest = m_order - i;
    double plane[kSize] = {};
    while (t != m_terms.end() && t->i == i) {
      const int j = t->j, most = t->k;
      double row[kSize] = {};
      for (; t != m_terms.end() && t->i == i && t->j == j; ++t) {
        for (int b = 0; b <= t->k; ++b) row[b] += t->c * z[t->k][b];
      }
      add_product(y[j], j, row, most, plane);
    }
    add_product(x[i], i, plane, rest, line);
  }
  for (int m = 0; m <= m_order; ++m) c[m] = line[m_order - m];
}

int Poly::crossings(const Ray& ray, double t_min, double t_max, double* roots) const {
  // Counted from the ray's nearest point to the origin and in unit lengths, so that coefficients
  // stay small.
  const double length_of_unit = length(ray.direction);
  const Vec3 d = ray.direction / length_of_unit;
  const double shift = -dot(ray.origin, d);
  const Vec3 p = ray.origin + d * shift;
  std::array<double, kMost> c;
  if (m_order <= 4) {
    along<5>(p, d, c.data());
  } else if (m_order <= 8) {
    along<9>(p, d, c.data());
  } else {
    along<kMost>(p, d, c.data());
  }
  // t_max does not cut: the roots' last bits would tell what else the ray has met.
  const double from = t_min * length_of_unit - shift;
  if (t_max * length_of_unit - shift <= from) return 0;
  const int n = solve_between_bounds(c.data(), m_order, from, std::numeric_limits<double>::infinity(), roots);
  for (int i = 0; i < n; ++i) roots[i] = (roots[i] + shift) / length_of_unit;
  return n;
}

bool Poly::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  double roots[kMost];
  const int n = crossings(ray, t_min, t_max, roots);
  for (int i = 0; i < n; ++i) {
    if (!(roots[i] > t_min && roots[i] < t_max)) continue;
    hit = {roots[i], 0, 0.0, 0.0};
    return true;
  }
  return false;
}

void Poly::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  double roots[kMost];
  const int n = crossings(ray, t_min, t_max, roots);
  for (int i = 0; i < n; ++i) {
    if (roots[i] > t_min && roots[i] < t_max) hits.push_back({roots[i], 0, 0.0, 0.0});
  }
}

bool Poly::inside(const Vec3& p) const {
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
