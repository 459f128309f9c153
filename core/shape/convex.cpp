#include "core/shape/convex.h"

#include <algorithm>
#include <typeinfo>

#include "core/shape/box.h"
#include "core/shape/cone.h"
#include "core/shape/cylinder.h"
#include "core/shape/plane.h"
#include "core/shape/sphere.h"

namespace lentray::core {
namespace {

int sphere_crossings(const Sphere& sphere, const Ray& ray, Crossing* out) {
  double t0, t1;
  const double inverse_dd = 1.0 / dot(ray.direction, ray.direction);
  if (!sphere_roots(ray, inverse_dd, sphere.centre(), sphere.radius2(), t0, t1)) return 0;
  out[0] = {t0, 0};
  out[1] = {t1, 0};
  return t1 != t0 ? 2 : 1;
}

}  // namespace

Convex::Kind Convex::kind_of(const Shape& shape) {
  if (typeid(shape) == typeid(Plane)) return Kind::kPlane;
  if (shape.traits().convexity != Convexity::kConvex) return Kind::kNone;
  if (typeid(shape) == typeid(Box)) return Kind::kBox;
  if (typeid(shape) == typeid(Sphere)) return Kind::kSphere;
  if (typeid(shape) == typeid(Cone)) return Kind::kCone;
  if (typeid(shape) == typeid(Cylinder)) return Kind::kCylinder;
  return Kind::kNone;
}

bool Convex::holds(const Shape& shape) { return kind_of(shape) != Kind::kNone; }

Convex::Convex(const Shape& shape, double margin)
    : m_shape(&shape), m_kind(kind_of(shape)), m_margin(margin) {
  constexpr double kOfPlanes = 1e-9;  // above that within which a point lies on a plane
  if (m_kind == Kind::kPlane) m_margin += kOfPlanes;
  if (m_kind != Kind::kBox) return;
  const auto& box = static_cast<const Box&>(shape);
  m_surely = {box.lo() + Vec3(margin), box.hi() - Vec3(margin)};
  m_perhaps = {box.lo() - Vec3(margin), box.hi() + Vec3(margin)};
}

int Convex::crossings(const Ray& ray, double t_min, Crossing* out) const {
  switch (m_kind) {
    case Kind::kBox:
      return static_cast<const Box&>(*m_shape).crossings(ray, t_min, Bounds::kInf, false, out);
    case Kind::kSphere: return sphere_crossings(static_cast<const Sphere&>(*m_shape), ray, out);
    case Kind::kCone:
      return static_cast<const Cone&>(*m_shape).crossings(ray, t_min, Bounds::kInf, false, out);
    case Kind::kCylinder:
      return static_cast<const Cylinder&>(*m_shape).crossings(ray, t_min, Bounds::kInf, false, out);
    case Kind::kPlane: {
      const auto& plane = static_cast<const Plane&>(*m_shape);
      out[0] = {plane_crossing(plane.unit_normal(), plane.distance(), ray), 0};
      return 1;
    }
    case Kind::kNone: break;
  }
  return 0;
}

Side Convex::side(const Vec3& p) const {
  switch (m_kind) {
    case Kind::kBox:
      return m_surely.contains(p)    ? Side::kInside
             : m_perhaps.contains(p) ? Side::kNear
                                     : Side::kOutside;
    case Kind::kSphere: {
      const auto& sphere = static_cast<const Sphere&>(*m_shape);
      const double r = sphere.radius();
      // Also of spheres smaller than the margin: it is counted twice.
      return side_by(length_squared(p - sphere.centre()) - sphere.radius2(),
                     (2.0 * r + m_margin) * m_margin);
    }
    case Kind::kPlane: {
      const auto& plane = static_cast<const Plane&>(*m_shape);
      return side_by(dot(plane.unit_normal(), p) - plane.distance(), m_margin);
    }
    case Kind::kCone:
    case Kind::kCylinder: return static_cast<const Frustum&>(*m_shape).side(p, m_margin);
    case Kind::kNone: break;
  }
  return Side::kNear;
}

bool Convex::is_entered_along(const Vec3& direction) const {
  return dot(static_cast<const Plane&>(*m_shape).unit_normal(), direction) < 0.0;
}

}  // namespace lentray::core
