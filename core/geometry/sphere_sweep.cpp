#include "core/geometry/sphere_sweep.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/geometry/bounds_help.h"
#include "core/geometry/box_ray.h"
#include "core/geometry/roots.h"

namespace lentray::core {
namespace {

constexpr int kMostOrder = 10;

/// Coefficients of rising powers.
struct Polynomial {
  std::array<double, kMostOrder + 1> c{};
  int order = 0;

  double at(double u) const {
    double sum = c[static_cast<std::size_t>(order)];
    for (int i = order - 1; i >= 0; --i) sum = sum * u + c[static_cast<std::size_t>(i)];
    return sum;
  }
  /// Largest coefficient: what rounding errors are measured by.
  double size() const {
    double most = 0.0;
    for (int i = 0; i <= order; ++i) most = std::max(most, std::fabs(c[static_cast<std::size_t>(i)]));
    return most;
  }
  int roots(double* out) const {
    double falling[kMostOrder + 1];
    for (int i = 0; i <= order; ++i) falling[i] = c[static_cast<std::size_t>(order - i)];
    return order == 0 ? 0 : solve_between(falling, order, 0.0, 1.0, out);
  }
};

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial out;
  out.order = a.order + b.order;
  for (int i = 0; i <= a.order; ++i) {
    for (int j = 0; j <= b.order; ++j) {
      out.c[static_cast<std::size_t>(i + j)] +=
          a.c[static_cast<std::size_t>(i)] * b.c[static_cast<std::size_t>(j)];
    }
  }
  return out;
}

void add(Polynomial& to, const Polynomial& p, double times) {
  to.order = std::max(to.order, p.order);
  for (int i = 0; i <= p.order; ++i) {
    to.c[static_cast<std::size_t>(i)] += times * p.c[static_cast<std::size_t>(i)];
  }
}

Polynomial slope_of(const Polynomial& p) {
  Polynomial out;
  out.order = std::max(0, p.order - 1);
  for (int i = 1; i <= p.order; ++i) {
    out.c[static_cast<std::size_t>(i - 1)] = i * p.c[static_cast<std::size_t>(i)];
  }
  return out;
}

/// |p - C(u)|^2 - r(u)^2.
Polynomial squared_gap(const SweepPiece& piece, const Vec3& p) {
  Polynomial gap;
  for (int axis = 0; axis < 3; ++axis) {
    Polynomial along;
    along.order = piece.order;
    along.c[0] = p[axis] - piece.centre[0][axis];
    for (std::size_t i = 1; i < 4; ++i) along.c[i] = -piece.centre[i][axis];
    add(gap, product(along, along), 1.0);
  }
  Polynomial radius;
  radius.order = piece.order;
  for (std::size_t i = 0; i < 4; ++i) radius.c[i] = piece.radius[i];
  add(gap, product(radius, radius), -1.0);
  return gap;
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

SphereSweep::SphereSweep(std::vector<SweepPiece> pieces) : m_pieces(std::move(pieces)) {
  for (const SweepPiece& piece : m_pieces) {
    m_boxes.push_back(box_of(piece, Transform()));
    m_bounds.include(m_boxes.back());
    for (std::uint32_t i = 0; i < kParts; ++i) {
      const double length = 1.0 / kParts;
      m_parts.push_back(box_of(part_of(piece, i * length, length), Transform()));
    }
  }
}

Bounds SphereSweep::bounds_in(const Transform& t) const {
  Bounds all;
  for (const SweepPiece& piece : m_pieces) all.include(box_of(piece, t));
  return all;
}

void SphereSweep::drop_shortcuts() {
  m_boxes.assign(m_boxes.size(), Bounds::everything());
  m_parts.assign(m_parts.size(), Bounds::everything());
}

void SphereSweep::sphere_crossings(std::uint32_t index, double u, const Line& line,
                                   ShapeHits& out) const {
  const Vec3 from = line.point - m_pieces[index].centre_at(u);
  const double r = m_pieces[index].radius_at(u), b = dot(from, line.direction);
  const double under = b * b - dot(from, from) + r * r;
  if (!(under > 0.0)) return;
  out.push_back({line.t_of(-b - std::sqrt(under)), index, u, 0.0});
  out.push_back({line.t_of(-b + std::sqrt(under)), index, u, 0.0});
}

void SphereSweep::piece_crossings(std::uint32_t index, const Line& line, ShapeHits& out) const {
  // Where the ray is nearly square to the path, both extremes of t fall together: there t hardly
  // depends on u.
  constexpr double kSquare = 1e-6;
  const SweepPiece& piece = m_pieces[index];
  Polynomial b;
  b.order = piece.order;
  b.c[0] = dot(line.direction, line.point - piece.centre[0]);
  for (std::size_t i = 1; i < 4; ++i) b.c[i] = -dot(line.direction, piece.centre[i]);
  const Polynomial c = squared_gap(piece, line.point);
  const Polynomial db = slope_of(b), dc = slope_of(c);

  const auto visit = [&](double u, int side) {
    const double bu = b.at(u), under = bu * bu - c.at(u);
    if (!(under >= 0.0)) return;
    out.push_back({line.t_of(-bu + side * std::sqrt(under)), index, u, 0.0});
  };
  double root[kMostOrder];
  if (db.size() <= kSquare) {
    const int n = dc.roots(root);
    for (int i = 0; i < n; ++i) {
      visit(root[i], -1);
      visit(root[i], 1);
    }
    return;
  }
  Polynomial extreme = product(dc, dc);
  add(extreme, product(product(b, db), dc), -4.0);
  add(extreme, product(product(db, db), c), 4.0);
  int n = extreme.roots(root);
  for (int i = 0; i < n; ++i) {
    const double u = root[i];
    visit(u, db.at(u) * (2.0 * b.at(u) * db.at(u) - dc.at(u)) < 0.0 ? -1 : 1);
  }
  n = db.roots(root);
  for (int i = 0; i < n; ++i) {
    if (std::fabs(dc.at(root[i])) > kSquare * dc.size()) continue;
    visit(root[i], -1);
    visit(root[i], 1);
  }
}

bool SphereSweep::met(const BoxRay& ray, std::uint32_t piece, double t_min, double t_max) const {
  if (!ray.meets(m_boxes[piece], t_min, t_max)) return false;
  const auto first = m_parts.begin() + piece * kParts;
  return std::any_of(first, first + kParts, [&](const Bounds& b) { return ray.meets(b, t_min, t_max); });
}

/// All that may be on the surface, ascending; some are within other spheres.
void SphereSweep::crossings(const Ray& ray, double t_min, double t_max, ShapeHits& out) const {
  Line line;
  line.speed = length(ray.direction);
  line.direction = ray.direction / line.speed;
  line.shift = dot(m_bounds.centre() - ray.origin, line.direction);
  line.point = ray.origin + line.direction * line.shift;
  const BoxRay box_ray(ray);
  for (std::uint32_t i = 0; i < m_pieces.size(); ++i) {
    if (!met(box_ray, i, t_min, t_max)) continue;
    sphere_crossings(i, 0.0, line, out);
    sphere_crossings(i, 1.0, line, out);
    piece_crossings(i, line, out);
  }
  std::sort(out.begin(), out.end(), [](const ShapeHit& a, const ShapeHit& b) {
    return std::tie(a.t, a.element, a.u) < std::tie(b.t, b.element, b.u);
  });
}

double SphereSweep::depth_in(const SweepPiece& piece, const Vec3& p) const {
  const Polynomial gap = squared_gap(piece, p);
  double deepest = std::max(-gap.at(0.0), -gap.at(1.0));
  double root[kMostOrder];
  const int n = slope_of(gap).roots(root);
  for (int i = 0; i < n; ++i) deepest = std::max(deepest, -gap.at(root[i]));
  return deepest;
}

bool SphereSweep::within(const Vec3& p, double margin) const {
  for (std::size_t i = 0; i < m_pieces.size(); ++i) {
    if (!m_boxes[i].contains(p)) continue;
    const auto first = m_parts.begin() + static_cast<std::ptrdiff_t>(i * kParts);
    const bool near = std::any_of(first, first + kParts, [&](const Bounds& b) { return b.contains(p); });
    if (near && depth_in(m_pieces[i], p) > margin) return true;
  }
  return false;
}

bool SphereSweep::inside(const Vec3& p) const { return within(p, 0.0); }

template <class Visit>
void SphereSweep::on_surface(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
  // Points on the surface are this much off it by rounding, of the squared radius.
  constexpr double kSlack = 1e-7;
  // Grows to the most that a ray ever meets, then costs nothing.
  thread_local ShapeHits found;
  found.clear();
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
