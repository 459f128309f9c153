#include "core/shape/sphere_sweep.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/numeric/bounds_help.h"
#include "core/numeric/box_ray.h"
#include "core/numeric/roots.h"

namespace lentray::core {
namespace {

/// Of an order that is known when it is compiled, so that loops unroll. Coefficients of rising powers.
template <std::size_t kOrder>
struct Polynomial {
  std::array<double, kOrder + 1> c{};

  double at(double u) const {
    double sum = c[kOrder];
    for (std::size_t i = kOrder; i-- > 0;) sum = sum * u + c[i];
    return sum;
  }
  /// Largest coefficient: what rounding errors are measured by.
  double size() const {
    double most = 0.0;
    for (const double one : c) most = std::max(most, std::fabs(one));
    return most;
  }
  int roots(double from, double to, double* out) const {
    if constexpr (kOrder == 0) return 0;
    double falling[kOrder + 1];
    for (std::size_t i = 0; i <= kOrder; ++i) falling[i] = c[kOrder - i];
    return solve_between(falling, static_cast<int>(kOrder), from, to, out);
  }
};

template <std::size_t kA, std::size_t kB>
Polynomial<kA + kB> operator*(const Polynomial<kA>& a, const Polynomial<kB>& b) {
  Polynomial<kA + kB> out;
#pragma GCC unroll 12
  for (std::size_t i = 0; i <= kA; ++i) {
#pragma GCC unroll 12
    for (std::size_t j = 0; j <= kB; ++j) out.c[i + j] += a.c[i] * b.c[j];
  }
  return out;
}

template <std::size_t kOrder>
void add(Polynomial<kOrder>& to, const Polynomial<kOrder>& p, double times) {
#pragma GCC unroll 12
  for (std::size_t i = 0; i <= kOrder; ++i) to.c[i] += times * p.c[i];
}

template <std::size_t kOrder>
Polynomial<kOrder - 1> slope_of(const Polynomial<kOrder>& p) {
  Polynomial<kOrder - 1> out;
#pragma GCC unroll 12
  for (std::size_t i = 1; i <= kOrder; ++i) out.c[i - 1] = static_cast<double>(i) * p.c[i];
  return out;
}

/// |p - C(u)|^2 - r(u)^2.
template <std::size_t kOrder>
Polynomial<2 * kOrder> squared_gap(const SweepPiece& piece, const Vec3& p) {
  Polynomial<2 * kOrder> gap;
  for (int axis = 0; axis < 3; ++axis) {
    Polynomial<kOrder> along;
    along.c[0] = p[axis] - piece.centre[0][axis];
    for (std::size_t i = 1; i <= kOrder; ++i) along.c[i] = -piece.centre[i][axis];
    add(gap, along * along, 1.0);
  }
  Polynomial<kOrder> radius;
  for (std::size_t i = 0; i <= kOrder; ++i) radius.c[i] = piece.radius[i];
  add(gap, radius * radius, -1.0);
  return gap;
}

/// How far a point is within any sphere of a piece, as r^2 less the squared distance.
template <std::size_t kOrder>
double depth_in(const SweepPiece& piece, const Vec3& p) {
  const Polynomial<2 * kOrder> gap = squared_gap<kOrder>(piece, p);
  double deepest = std::max(-gap.at(0.0), -gap.at(1.0));
  double root[2 * kOrder - 1];
  const int n = slope_of(gap).roots(0.0, 1.0, root);
  for (int i = 0; i < n; ++i) deepest = std::max(deepest, -gap.at(root[i]));
  return deepest;
}

/// Whether p(u) may be 0 or more between 0 and 1.
bool may_be_positive(const Polynomial<2>& p) {
  constexpr double kSlack = -1e-9;
  const double least = kSlack * p.size();
  if (p.c[0] >= least || p.at(1.0) >= least) return true;
  return p.c[2] < 0.0 && p.c[1] > 0.0 && p.c[1] < -2.0 * p.c[2] &&
         p.c[0] - 0.25 * p.c[1] * p.c[1] / p.c[2] >= least;
}

/// How far any of the spheres reaches; their radius may be below 0.
double support_of(const SweepPiece& piece, const Vec3& d) {
  const double size = length(d);
  const auto& c = piece.centre;
  const auto& r = piece.radius;
  const auto side = [&](double s) {
    return most_of_cubic(dot(d, c[3]) + s * r[3], dot(d, c[2]) + s * r[2], dot(d, c[1]) + s * r[1],
                         dot(d, c[0]) + s * r[0]);
  };
  return std::max(side(size), side(-size));
}

Bounds box_of(const SweepPiece& piece, const Transform& t) {
  return support_bounds(t, [&](const Vec3& d) { return support_of(piece, d); });
}

/// The piece over u = from..from + length, as one of its own.
SweepPiece part_of(const SweepPiece& piece, double from, double length) {
  const auto cut = [&](const auto& c) {
    auto out = c;
    out[0] = c[0] + (c[1] + (c[2] + c[3] * from) * from) * from;
    out[1] = (c[1] + (c[2] * 2.0 + c[3] * (3.0 * from)) * from) * length;
    out[2] = (c[2] + c[3] * (3.0 * from)) * (length * length);
    out[3] = c[3] * (length * length * length);
    return out;
  };
  return {cut(piece.centre), cut(piece.radius), piece.order};
}

}  // namespace

/// The ray with a unit direction, counted from the point nearest to the sweep's middle.
struct SphereSweep::Line {
  Vec3 point, direction;
  double shift = 0.0, speed = 1.0;
  double t_of(double along) const { return (along + shift) / speed; }
};

SphereSweep::SphereSweep(std::vector<SweepPiece> pieces, double tolerance)
    : m_pieces(std::move(pieces)), m_tolerance(tolerance) {
  for (const SweepPiece& piece : m_pieces) {
    m_boxes.push_back(box_of(piece, Transform()));
    m_bounds.include(m_boxes.back());
    for (std::uint32_t i = 0; i < kParts; ++i) {
      const double length = 1.0 / kParts;
      m_parts.push_back(box_of(part_of(piece, i * length, length), Transform()));
    }
  }
}

Bounds SphereSweep::box_in(const Transform& t) const {
  Bounds all;
  for (const SweepPiece& piece : m_pieces) all.include(box_of(piece, t));
  return all;
}

/// The parts decide where roots are looked for, and so what their last bits are: they stay.
void SphereSweep::sphere_crossings(std::uint32_t index, double u, const Line& line,
                                   ShapeHits& out) const {
  const Vec3 from = line.point - m_pieces[index].centre_at(u);
  const double r = m_pieces[index].radius_at(u), b = dot(from, line.direction);
  const double under = b * b - dot(from, from) + r * r;
  if (!(under > 0.0)) return;
  out.push_back({line.t_of(-b - std::sqrt(under)), index, u, 0.0});
  out.push_back({line.t_of(-b + std::sqrt(under)), index, u, 0.0});
}

template <std::size_t kOrder>
void SphereSweep::piece_crossings(std::uint32_t index, const Line& line, double from, double to,
                                  ShapeHits& out) const {
  // Where the ray is nearly square to the path, both extremes of t fall together: there t hardly
  // depends on u.
  constexpr double kSquare = 1e-6;
  const SweepPiece& piece = m_pieces[index];
  Polynomial<kOrder> b;
  b.c[0] = dot(line.direction, line.point - piece.centre[0]);
  for (std::size_t i = 1; i <= kOrder; ++i) b.c[i] = -dot(line.direction, piece.centre[i]);
  const auto c = squared_gap<kOrder>(piece, line.point);
  if constexpr (kOrder == 1) {
    Polynomial<2> under = b * b;
    add(under, c, -1.0);
    if (!may_be_positive(under)) return;
    sphere_crossings(index, 0.0, line, out);
    sphere_crossings(index, 1.0, line, out);
  }
  const auto db = slope_of(b);
  const auto dc = slope_of(c);

  const auto visit = [&](double u, int side) {
    const double bu = b.at(u), under = bu * bu - c.at(u);
    if (!(under >= 0.0)) return;
    out.push_back({line.t_of(-bu + side * std::sqrt(under)), index, u, 0.0});
  };
  double root[4 * kOrder];
  if (db.size() <= kSquare) {
    const int n = dc.roots(from, to, root);
    for (int i = 0; i < n; ++i) {
      visit(root[i], -1);
      visit(root[i], 1);
    }
    return;
  }
  auto extreme = dc * dc;
  add(extreme, (b * db) * dc, -4.0);
  add(extreme, (db * db) * c, 4.0);
  int n = extreme.roots(from, to, root);
  for (int i = 0; i < n; ++i) {
    const double u = root[i];
    visit(u, db.at(u) * (2.0 * b.at(u) * db.at(u) - dc.at(u)) < 0.0 ? -1 : 1);
  }
  n = db.roots(from, to, root);
  for (int i = 0; i < n; ++i) {
    if (std::fabs(dc.at(root[i])) > kSquare * dc.size()) continue;
    visit(root[i], -1);
    visit(root[i], 1);
  }
}

std::pair<std::uint32_t, std::uint32_t> SphereSweep::parts_met(const BoxRay& ray,
                                                               std::uint32_t piece,
                                                               double t_min) const {
  const Bounds* parts = &m_parts[static_cast<std::size_t>(piece) * kParts];
  std::uint32_t first = 0, last = kParts;
  while (first < kParts && !ray.meets(parts[first], t_min, Bounds::kInf)) ++first;
  if (first == kParts) return {0, 0};
  while (!ray.meets(parts[last - 1], t_min, Bounds::kInf)) --last;
  return {first, last};
}

/// All that may be on the surface, ascending; some are within other spheres.
void SphereSweep::crossings(const Ray& ray, double t_min, double t_max, ShapeHits& out) const {
  constexpr double kPart = 1.0 / kParts, kOver = 1e-9;
  Line line;
  line.speed = length(ray.direction);
  line.direction = ray.direction / line.speed;
  line.shift = dot(m_bounds.centre() - ray.origin, line.direction);
  line.point = ray.origin + line.direction * line.shift;
  const BoxRay box_ray(ray);
  for (std::uint32_t i = 0; i < m_pieces.size(); ++i) {
    if (!box_ray.meets(m_boxes[i], t_min, t_max)) continue;
    if (m_pieces[i].order == 1) {
      piece_crossings<1>(i, line, 0.0, 1.0, out);
      continue;
    }
    const auto [first, end] = parts_met(box_ray, i, t_min);
    if (first == end) continue;
    if (first == 0) sphere_crossings(i, 0.0, line, out);
    if (end == kParts) sphere_crossings(i, 1.0, line, out);
    const double from = std::max(0.0, first * kPart - kOver),
                 to = std::min(1.0, end * kPart + kOver);
    piece_crossings<3>(i, line, from, to, out);
  }
  std::sort(out.begin(), out.end(), [](const ShapeHit& a, const ShapeHit& b) {
    return std::tie(a.t, a.element, a.u) < std::tie(b.t, b.element, b.u);
  });
}

bool SphereSweep::within(const Vec3& p, double margin) const {
  for (std::size_t i = 0; i < m_pieces.size(); ++i) {
    if (!m_boxes[i].contains(p)) continue;
    if (m_pieces[i].order == 1) {
      if (depth_in<1>(m_pieces[i], p) > margin) return true;
      continue;
    }
    const auto first = m_parts.begin() + static_cast<std::ptrdiff_t>(i * kParts);
    const bool near =
        std::any_of(first, first + kParts, [&](const Bounds& b) { return b.contains(p); });
    if (near && depth_in<3>(m_pieces[i], p) > margin) return true;
  }
  return false;
}

template <class Visit>
void SphereSweep::on_surface(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
  // Points on the surface are this much off it by rounding, of the squared radius.
  constexpr double kSlack = 1e-7;
  // Grows to the most that a ray ever meets, then costs nothing.
  thread_local ShapeHits found;
  found.clear();
  t_min = std::max(t_min, m_tolerance);
  crossings(ray, t_min, t_max, found);
  for (const ShapeHit& hit : found) {
    if (!(hit.t > t_min && hit.t < t_max)) continue;
    const double r = m_pieces[hit.element].radius_at(hit.u);
    if (!within(ray.at(hit.t), kSlack * r * r) && !visit(hit)) return;
  }
}

void SphereSweep::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  on_surface(ray, t_min, t_max, [&](const ShapeHit& hit) {
    hits.push_back(hit);
    return true;
  });
}

bool SphereSweep::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  bool found = false;
  on_surface(ray, t_min, t_max, [&](const ShapeHit& first) {
    hit = first;
    found = true;
    return false;
  });
  return found;
}

Vec3 SphereSweep::normal(const Vec3& p, const ShapeHit& hit) const {
  return p - m_pieces[hit.element].centre_at(hit.u);
}

}  // namespace lentray::core
