#include "core/shape/surface_of_revolution.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/about_axis.h"
#include "core/numeric/bounds_help.h"
#include "core/numeric/box_ray.h"
#include "core/numeric/roots.h"
#include "core/shape/crossings.h"

namespace lentray::core {
namespace {

constexpr double kNoCap = 1e-4;  ///< flat ends of a smaller r^2 are left out

/// Of r^2 with the height, from the neighbours of a point.
double steepness(const Vec2& before, const Vec2& at, const Vec2& after) {
  return 2.0 * at.u * (after.u - before.u) / (after.v - before.v);
}

}  // namespace

SurfaceOfRevolution::SurfaceOfRevolution(const std::vector<Vec2>& points, bool open)
    : m_open(open) {
  for (std::size_t i = 1; i + 2 < points.size(); ++i) {
    const Vec2 &a = points[i], &b = points[i + 1];
    const double h = b.v - a.v;
    const double from = a.u * a.u, to = b.u * b.u;
    const double s0 = steepness(points[i - 1], a, b), s1 = steepness(a, b, points[i + 2]);
    Piece p{a.v, b.v, from, s0, 0.0, 0.0, 0.0};
    p.c2 = (3.0 * (to - from) / h - 2.0 * s0 - s1) / h;
    p.c3 = (2.0 * (from - to) / h + s0 + s1) / (h * h);
    p.widest2 = std::max(from, to);
    double turn[2];
    const int n = solve_quadratic(3.0 * p.c3, 2.0 * p.c2, p.c1, turn);
    for (int k = 0; k < n; ++k) {
      if (turn[k] > 0.0 && turn[k] < h) p.widest2 = std::max(p.widest2, p.at(turn[k]));
    }
    m_pieces.push_back(p);
  }
  const auto end = [](double r) { return r * r > kNoCap ? r * r : 0.0; };
  m_base2 = end(points[1].u);
  m_cap2 = end(points[points.size() - 2].u);
  m_reach = widened(own_box());
}

Bounds SurfaceOfRevolution::own_box() const {
  Bounds box;
  for (const Piece& p : m_pieces) {
    const double r = std::sqrt(p.widest2);
    box.include(Vec3{-r, p.low, -r});
    box.include(Vec3{r, p.high, r});
  }
  return padded(box);
}

/// By slices, each as wide as its widest place.
Bounds SurfaceOfRevolution::box_in(const Transform& t) const {
  if (keeps_axes(t)) return transformed(own_box(), t);
  constexpr int kSlices = 16;
  return support_bounds(t, [&](const Vec3& d) {
    const double across = std::sqrt(d.x * d.x + d.z * d.z);
    double far = -Bounds::kInf;
    for (const Piece& p : m_pieces) {
      const double h = (p.high - p.low) / kSlices;
      for (int i = 0; i < kSlices; ++i) {
        const double from = i * h;
        // r^2 over the slice, as a cubic of 0..1.
        const double wide2 = most_of_cubic(p.c3 * h * h * h, (3.0 * p.c3 * from + p.c2) * h * h,
                                           p.slope(from) * h, p.at(from));
        const double y = p.low + from, up = std::max(d.y * y, d.y * (y + h));
        if (wide2 >= 0.0) far = std::max(far, across * std::sqrt(wide2) + up);
      }
    }
    return far;
  });
}

/// Pieces as the ray comes to them; those that it comes to beyond t_max, which visit may lower, are left out.
template <class Visit>
void SurfaceOfRevolution::crossings(const Ray& ray, double t_min, const double& t_max,
                                    Visit&& visit) const {
  constexpr double kSlack = 1e-9, kLevel = 1e-10;
  if (!BoxRay(ray).meets(m_reach, t_min, t_max)) return;
  const AboutAxis about(ray);
  const bool level = std::fabs(about.climb) <= kLevel * about.across;
  // Counted from the point nearest to the middle: rays along the axis are near it nowhere or far away.
  const Vec3 middle{0.0, 0.5 * (m_pieces.front().low + m_pieces.back().high), 0.0};
  const double shift = dot(middle - ray.origin, ray.direction) / dot(ray.direction, ray.direction);
  const Vec3 o = ray.at(shift), &d = ray.direction;
  const double a2 = d.x * d.x + d.z * d.z, b = o.x * d.x + o.z * d.z, c = o.x * o.x + o.z * o.z;
  if (!m_open && !level) {
    const auto flat = [&](double height, double r2, std::uint32_t element) {
      const double t = (height - o.y) / d.y;
      if ((a2 * t + 2.0 * b) * t + c <= r2) visit(shift + t, element, 0.0);
    };
    if (m_base2 > 0.0) flat(m_pieces.front().low, m_base2, base());
    if (m_cap2 > 0.0) flat(m_pieces.back().high, m_cap2, cap());
  }
  const double climb = d.y;
  const auto pieces = static_cast<std::uint32_t>(m_pieces.size());
  for (std::uint32_t k = 0; k < pieces; ++k) {
    const std::uint32_t i = climb < 0.0 ? pieces - 1 - k : k;
    const Piece& p = m_pieces[i];
    if (about.near2 > p.widest2 * (1.0 + kSlack)) continue;
    // t_max does not cut: the roots' last bits would depend on what else the ray has hit.
    double lo = t_min - shift, hi = Bounds::kInf;
    const double g = o.y - p.low, margin = kSlack * (p.high - p.low);
    if (level) {
      if (g < 0.0 || g > p.high - p.low) continue;
    } else {
      const double t0 = (-g - margin) / climb, t1 = (p.high - p.low - g + margin) / climb;
      lo = std::max(lo, std::min(t0, t1));
      hi = std::min(hi, std::max(t0, t1));
    }
    // Within the cylinder as wide as the piece.
    if (a2 > 0.0) {
      const double chord = b * b - a2 * (c - p.widest2 * (1.0 + kSlack));
      if (!(chord > 0.0)) continue;
      const double half = std::sqrt(chord);
      lo = std::max(lo, (-b - half) / a2);
      hi = std::min(hi, (half - b) / a2);
    }
    if (!(lo <= hi) || t_max - shift <= lo) continue;
    const double cubic[4] = {p.c3 * climb * climb * climb,
                             (p.c2 + 3.0 * p.c3 * g) * climb * climb - a2,
                             p.slope(g) * climb - 2.0 * b, p.at(g) - c};
    double root[3];
    const int n = std::isfinite(hi) ? solve_between(cubic, 3, lo, hi, root)
                                    : solve_between_bounds(cubic, 3, lo, hi, root);
    for (int j = 0; j < n; ++j) {
      const double s = g + climb * root[j];
      if (s >= -margin && s <= p.high - p.low + margin) visit(shift + root[j], i, 0.0);
    }
  }
}

bool SurfaceOfRevolution::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  bool found = false;
  crossings(ray, t_min, t_max, [&](double t, std::uint32_t element, double) {
    // Where two pieces meet the lower one counts.
    const bool wins_tie = found && hit.element < base() && element < hit.element;
    if (!(t > t_min && (t < t_max || (wins_tie && t == t_max)))) return;
    hit = {t, element, 0.0, 0.0};
    t_max = t;
    found = true;
  });
  return found;
}

bool SurfaceOfRevolution::any(const Ray& ray, double t_min, double t_max) const {
  bool found = false;
  crossings(ray, t_min, t_max, [&](double t, std::uint32_t, double) {
    if (!(t > t_min && t < t_max)) return;
    found = true;
    t_max = -Bounds::kInf;
  });
  return found;
}

void SurfaceOfRevolution::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  append_all(*this, ray, t_min, t_max, hits);
}

bool SurfaceOfRevolution::within(const Vec3& p) const {
  const double r2 = p.x * p.x + p.z * p.z;
  for (const Piece& piece : m_pieces) {
    if (p.y >= piece.low && p.y <= piece.high) return r2 <= piece.at(p.y - piece.low);
  }
  return false;
}

Vec3 SurfaceOfRevolution::normal(const Vec3& p, const ShapeHit& hit) const {
  if (hit.element == base()) return {0.0, -1.0, 0.0};
  if (hit.element == cap()) return {0.0, 1.0, 0.0};
  const Piece& piece = m_pieces[hit.element];
  return {p.x, -0.5 * piece.slope(p.y - piece.low), p.z};
}

Vec2 SurfaceOfRevolution::uv(const Vec3& p, const ShapeHit& hit) const {
  const double around = turn_about_axis(p), r = std::sqrt(p.x * p.x + p.z * p.z);
  if (hit.element == base()) return {around, r / std::sqrt(m_base2) - 1.0};
  if (hit.element == cap()) return {around, 2.0 - r / std::sqrt(m_cap2)};
  const Piece& piece = m_pieces[hit.element];
  const double along = (p.y - piece.low) / (piece.high - piece.low) + hit.element;
  return {around, along / static_cast<double>(m_pieces.size())};
}

}  // namespace lentray::core
