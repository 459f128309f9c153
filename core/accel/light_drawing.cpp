#include "core/accel/light_drawing.h"

#include <algorithm>
#include <array>
#include <typeinfo>

#include "core/object/leaf.h"
#include "core/shape/box.h"
#include "core/shape/cone.h"
#include "core/shape/cylinder.h"
#include "core/shape/double_cone.h"
#include "core/shape/polygon.h"
#include "core/shape/smooth_triangle.h"
#include "core/shape/sphere.h"
#include "core/shape/triangle.h"

namespace lentray::core {
namespace {

void add_face(const std::array<Vec3, 4>& corners, LightOutline& outline,
              std::vector<LightCell>& out) {
  const Vec3 normal = normalized(cross(corners[1] - corners[0], corners[3] - corners[0]));
  std::array<Vec3, 8> ends;
  for (std::size_t i = 0; i < 4; ++i) {
    ends[2 * i] = corners[i];
    ends[2 * i + 1] = corners[(i + 1) % 4];
  }
  outline.flat(ends, normal, dot(normal, corners[0]), out);
}

/// Each side's cells overlap those of its neighbours: one entry a cell, the darkest.
void add_box(const Bounds& box, LightOutline& outline, std::vector<LightCell>& out) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool high : {false, true}) {
      // Only sides that face the light: the others are behind them.
      const double at = high ? box.hi[axis] : box.lo[axis];
      if (high ? at >= 0.0 : at <= 0.0) continue;
      std::array<Vec3, 4> corners;
      for (std::size_t c = 0; c < 4; ++c) {
        corners[c][axis] = at;
        corners[c][u] = (c == 1 || c == 2) ? box.hi[u] : box.lo[u];
        corners[c][v] = c >= 2 ? box.hi[v] : box.lo[v];
      }
      add_face(corners, outline, out);
    }
  }
  std::sort(out.begin(), out.end(),
            [](const LightCell& a, const LightCell& b) { return a.cell < b.cell; });
  std::size_t kept = 0;
  for (const LightCell& next : out) {
    if (kept > 0 && out[kept - 1].cell == next.cell) {
      out[kept - 1].near_w = std::min(out[kept - 1].near_w, next.near_w);
      out[kept - 1].full_w = std::min(out[kept - 1].full_w, next.full_w);
    } else {
      out[kept++] = next;
    }
  }
  out.resize(kept);
}

Vec3 triangle_normal(const Shape& shape) {
  const auto& p = static_cast<const TriangleShape&>(shape).vertices();
  return normalized(cross(p[1] - p[0], p[2] - p[0]));
}

/// Appends points with the whole surface in their convex hull, but for rounding; none where it is infinite.
void add_hull(const Shape& shape, std::vector<Vec3>& points) {
  if (const auto* frustum = dynamic_cast<const Frustum*>(&shape)) return frustum->hull(points);
  if (const auto* two = dynamic_cast<const DoubleCone*>(&shape)) return two->hull(points);
  add_corners(shape.bounds(), points);
}

}  // namespace

CasterKind caster_kind(const Shape* shape) {
  if (!shape) return CasterKind::kAny;
  const std::type_info& type = typeid(*shape);
  if (type == typeid(Sphere)) return CasterKind::kSphere;
  if (type == typeid(Polygon)) return CasterKind::kPolygon;
  if (type == typeid(Triangle) || type == typeid(SmoothTriangle)) return CasterKind::kTriangle;
  return type == typeid(Box) ? CasterKind::kBox : CasterKind::kAny;
}

/// Into m_points: the ends of its edges in pairs, relative to the light.
void LightDrawing::triangle_ends(const Shape& shape) {
  const auto& p = static_cast<const TriangleShape&>(shape).vertices();
  m_points.clear();
  for (std::size_t i = 0; i < 3; ++i) {
    m_points.push_back(p[i] - m_light);
    m_points.push_back(p[(i + 1) % 3] - m_light);
  }
}

/// The same, of all contours.
void LightDrawing::polygon_ends(const Shape& shape) {
  const std::vector<Vec3>& points = static_cast<const Polygon&>(shape).points();
  m_points.clear();
  std::size_t start = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    m_points.push_back(points[i - 1] - m_light);
    m_points.push_back(points[i] - m_light);
    if (points[i] == points[start]) start = ++i;
  }
}

void LightDrawing::outline(const Subject& subject, const LightWindow& window, LightOutline& outline,
                           std::vector<LightCell>& out) {
  const Shape* shape = subject.shape;
  switch (subject.kind) {
    case CasterKind::kSphere: {
      const auto& sphere = static_cast<const Sphere&>(*shape);
      return outline.sphere(sphere.centre() - m_light, sphere.radius(), window, out);
    }
    case CasterKind::kPolygon: {
      polygon_ends(*shape);
      const Vec3 normal = shape->normal({}, {});
      return outline.flat(m_points, normal, dot(normal, m_points[0]), out);
    }
    case CasterKind::kTriangle: {
      triangle_ends(*shape);
      const Vec3 normal = triangle_normal(*shape);
      return outline.flat(m_points, normal, dot(normal, m_points[0]), out);
    }
    case CasterKind::kBox: {
      const auto& box = static_cast<const Box&>(*shape);
      const Bounds around = relative({box.lo(), box.hi()}, m_light);
      m_points.clear();
      add_corners(around, m_points);
      if (around.contains({})) return outline.box(around, window, out);
      return add_box(around, outline, out);
    }
    case CasterKind::kAny: break;
  }
  // Less than its box, where it is a shape that was turned.
  m_points.clear();
  if (typeid(subject.object) == typeid(Leaf)) {
    const auto& leaf = static_cast<const Leaf&>(subject.object);
    add_hull(leaf.shape(), m_points);
    for (Vec3& p : m_points) p = (leaf.transform() ? leaf.transform()->point(p) : p) - m_light;
  } else {
    add_corners(subject.box, m_points);
  }
  outline.is_small(window) ? outline.box(subject.box, window, out)
                           : outline.hull(m_points, subject.box, window, out);
}

/// Of the object's ball, or of what was drawn where that is narrower.
LightVolume LightDrawing::unknown_volume(const Subject& subject,
                                         const LightVolumes& volumes) const {
  const Ball& ball = subject.object.ball();
  LightVolume volume;
  double area = Bounds::kInf;
  if (ball.is_finite()) {
    const Vec3 centre = ball.centre() - m_light;
    const double radius2 = ball.radius() * ball.radius(), tangent2 = dot(centre, centre) - radius2;
    volume = volumes.sphere(centre, ball.radius(), subject.distance);
    if (tangent2 > 0.0) area = 4.0 * radius2 / tangent2;
  }
  constexpr std::size_t kOfBox = 8;
  if (m_points.size() == kOfBox) volumes.box(m_points, subject.distance, area, volume);
  return volume;
}

LightVolume LightDrawing::volume(const Subject& subject, const LightVolumes& volumes) const {
  switch (subject.kind) {
    case CasterKind::kSphere: {
      const auto& sphere = static_cast<const Sphere&>(*subject.shape);
      return volumes.sphere(sphere.centre() - m_light, sphere.radius(), subject.distance);
    }
    case CasterKind::kPolygon: {
      const Vec3 normal = subject.shape->normal({}, {});
      LightVolume volume;
      if (m_points.size() > 2 * 4) volume = unknown_volume(subject, volumes);
      volumes.polygon(m_points, normal, dot(normal, m_points[0]), subject.distance, volume);
      return volume;
    }
    case CasterKind::kTriangle:
      return volumes.triangle(m_points[0], m_points[2], m_points[4], subject.distance);
    case CasterKind::kBox:
    case CasterKind::kAny: break;
  }
  if (m_points.size() != 16 || !subject.shape) return unknown_volume(subject, volumes);
  const std::type_info& type = typeid(*subject.shape);
  if (type != typeid(Cone) && type != typeid(Cylinder)) return unknown_volume(subject, volumes);
  // Their hulls are octagons about the ends' circles.
  constexpr double kInner = 0.9238795325112868;  // cos(pi / 8)
  Vec3 a, b;
  for (std::size_t i = 0; i < 8; ++i) {
    a += m_points[i];
    b += m_points[i + 8];
  }
  a *= 0.125;
  b *= 0.125;
  return volumes.cone(a, kInner * length(m_points[0] - a), b, kInner * length(m_points[8] - b),
                      subject.distance);
}

}  // namespace lentray::core
