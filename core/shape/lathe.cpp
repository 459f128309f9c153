#include "core/shape/lathe.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/about_axis.h"
#include "core/numeric/bounds_help.h"
#include "core/numeric/box_ray.h"
#include "core/numeric/roots.h"
#include "core/shape/crossings.h"

namespace lentray::core {
namespace {

/// Adds `by` times the square of the polynomial p to c, highest power first.
template <int kOrder>
inline void add_square(const double* p, double by, double* c) {
#pragma GCC unroll 4
  for (int i = 0; i <= kOrder; ++i) {
    const double share = by * p[i];
#pragma GCC unroll 4
    for (int j = 0; j <= kOrder; ++j) c[i + j] += share * p[j];
  }
}

/// Where on the curve, a polynomial of kOrder (1 or 3), the ray's hyperboloid meets it.
template <int kOrder>
inline int meeting_places(const double* u, const double* v, const AboutAxis& ray, double s[6]) {
  double c[2 * kOrder + 1] = {};
  add_square<kOrder>(v, ray.across * ray.across, c);
  add_square<kOrder>(u, -ray.climb * ray.climb, c);
  c[2 * kOrder] += ray.climb * ray.climb * ray.near2;
  // A little beyond the ends, so that no ray passes between two pieces; both may be met there.
  constexpr double kEnd = 1e-9;
  return solve_between(c, 2 * kOrder, -kEnd, 1.0 + kEnd, s);
}

/// Places on the curve where the ray's hyperboloid meets it.
int places(const CurvePiece& curve, const AboutAxis& ray, double s[6]) {
  const double u[4] = {curve.a.u, curve.b.u, curve.c.u, curve.d.u};
  const double v[4] = {curve.a.v, curve.b.v, curve.c.v, curve.d.v - ray.height};
  const bool straight = u[0] == 0.0 && u[1] == 0.0 && v[0] == 0.0 && v[1] == 0.0;
  const int n =
      straight ? meeting_places<1>(u + 2, v + 2, ray, s) : meeting_places<3>(u, v, ray, s);
  for (int i = 0; i < n; ++i) s[i] = std::clamp(s[i], 0.0, 1.0);
  return n;
}

}  // namespace

Lathe::Lathe(std::vector<CurvePiece> pieces, double hole)
    : m_hole2(hole > 0.0 ? hole * hole : 0.0) {
  for (const CurvePiece& curve : pieces) {
    const Outline alone({curve});
    const double widest = std::max(std::fabs(alone.lo().u), std::fabs(alone.hi().u));
    m_pieces.push_back({curve, alone.lo().v, alone.hi().v, widest});
  }
  m_reach = widened(own_box());
}

Bounds Lathe::own_box() const {
  Bounds box;
  for (const Piece& p : m_pieces) {
    box.include(Vec3{-p.widest, p.low, -p.widest});
    box.include(Vec3{p.widest, p.high, p.widest});
  }
  return padded(box);
}

Bounds Lathe::box_in(const Transform& t) const {
  if (keeps_axes(t)) return transformed(own_box(), t);
  return support_bounds(t, [&](const Vec3& d) {
    const double across = std::sqrt(d.x * d.x + d.z * d.z);
    double far = -Bounds::kInf;
    for (const Piece& p : m_pieces) {
      far = std::max({far, p.curve.farthest({across, d.y}), p.curve.farthest({-across, d.y})});
    }
    return far;
  });
}

template <class Visit>
void Lathe::crossings(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
  constexpr double kSlack = 1e-9;
  // Below this slope heights say little of t: distances from the axis do.
  constexpr double kLevel = 0.02, kHorizontal = 1e-9;
  if (!BoxRay(ray).meets(m_reach, t_min, t_max)) return;
  const AboutAxis about(ray);
  const double from = ray.origin.y + t_min * about.climb, to = ray.origin.y + t_max * about.climb;
  const double least = std::min(from, to), most = std::max(from, to);
  const bool horizontal = std::fabs(about.climb) <= kHorizontal * about.across;
  const double inverse_climb = 1.0 / about.climb;
  for (std::uint32_t i = 0; i < m_pieces.size(); ++i) {
    const Piece& piece = m_pieces[i];
    if (about.near2 > piece.widest * piece.widest * (1.0 + kSlack)) continue;
    const double margin = kSlack * (1.0 + piece.high - piece.low);
    if (most < piece.low - margin || least > piece.high + margin) continue;
    if (!horizontal) {
      // At the piece's height the ray may be farther from the axis than the piece.
      constexpr double kSure = 1e-6;
      const double off = kSure * (1.0 + piece.high - piece.low);
      const double a = (std::max(piece.low, least) - off - about.height) * inverse_climb;
      const double b = (std::min(piece.high, most) + off - about.height) * inverse_climb;
      const double away = std::max({0.0, std::min(a, b), -std::max(a, b)}) * about.across;
      if (about.near2 + away * away > piece.widest * piece.widest * (1.0 + kSure)) continue;
    }
    double s[6];
    const int n = horizontal ? line_crossings(piece.curve, 0.0, 1.0, -about.height, s)
                             : places(piece.curve, about, s);
    for (int k = 0; k < n; ++k) {
      const Vec2 p = piece.curve.at(s[k]);
      const double climbed = p.v - about.height;
      if (std::fabs(about.climb) > kLevel * about.across) {
        visit(about.t_near + climbed / about.climb, i, s[k]);
        continue;
      }
      const double beyond2 = p.u * p.u - about.near2;
      if (horizontal && beyond2 < 0.0) continue;  // it passes by
      const double t = std::sqrt(std::max(0.0, beyond2)) / about.across;
      const bool after = climbed * about.climb > 0.0;
      if (horizontal || after) visit(about.t_near + t, i, s[k]);
      if (horizontal || !after) visit(about.t_near - t, i, s[k]);
    }
  }
}

bool Lathe::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  return nearest_of_all(*this, ray, t_min, t_max, hit);
}

void Lathe::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  append_all(*this, ray, t_min, t_max, hits);
}

bool Lathe::within(const Vec3& p) const {
  const double r2 = p.x * p.x + p.z * p.z;
  if (r2 < m_hole2) return false;
  const double r = std::sqrt(r2);
  bool in = false;
  for (const Piece& piece : m_pieces) {
    if (p.y < piece.low || p.y > piece.high) continue;
    double s[3];
    const int n = line_crossings(piece.curve, 0.0, 1.0, -p.y, s);
    for (int k = 0; k < n; ++k) {
      if (piece.curve.at(s[k]).u >= r) in = !in;
    }
  }
  return in;
}

Vec3 Lathe::normal(const Vec3& p, const ShapeHit& hit) const {
  constexpr double kOnAxis = 1e-10;
  const double r2 = p.x * p.x + p.z * p.z;
  if (!(r2 > kOnAxis)) return {0.0, 1.0, 0.0};
  const Vec2 slope = m_pieces[hit.element].curve.slope(hit.u);
  return {slope.v * p.x, -slope.u * std::sqrt(r2), slope.v * p.z};
}

Vec2 Lathe::uv(const Vec3& p, const ShapeHit& hit) const {
  const double along = (hit.u + hit.element) / static_cast<double>(m_pieces.size());
  return {turn_about_axis(p), std::min(along, 1.0)};
}

}  // namespace lentray::core
