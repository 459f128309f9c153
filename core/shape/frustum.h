// What cones and cylinders share: the surface between two circles about an axis. Space: object, or
// world once baked.
#pragma once

#include "core/shape/crossings.h"
#include "core/shape/shape.h"
#include "core/shape/side.h"

namespace lentray::core {

class Frustum : public Shape {
 public:
  bool is_degenerate() const {
    return !(m_length > 0.0) || (m_base_radius == 0.0 && m_slope == 0.0);
  }
  Vec3 cap() const { return m_base + m_axis * m_length; }

  Bounds box(const Transform* move) const final;
  Ball ball() const final;
  /// Appends points with the whole surface in their convex hull, but for rounding.
  void hull(std::vector<Vec3>& points) const;
  /// An open one is as solid as a closed one.
  bool holds(const Vec3& p, bool inverse) const final { return within(p) != inverse; }
  /// Of a closed one. The margin must be larger than a millionth of its size.
  Side side(const Vec3& p, double margin) const;
  /// ShapeHit::element: 0 side, 1 base, 2 cap.
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const final;

 protected:
  /// Ends must differ (is_degenerate otherwise: nothing hits it).
  Frustum(const Vec3& base, double base_radius, const Vec3& cap, double cap_radius, bool open);

  ShapeTraits traits_as(std::string_view name) const {
    return {.name = name,
            .convexity = m_open ? Convexity::kOpen : Convexity::kConvex,
            .is_seen_afar = true};
  }

  /// A ray about the axis, counted from the point nearest to the centre, so that far origins do not
  /// cost digits.
  struct AboutIt {
    AboutIt(const Frustum& f, const Ray& ray)
        : to_base(f.m_base - ray.origin),
          shift(dot(to_base + f.m_axis * (0.5 * f.m_length), ray.direction) /
                dot(ray.direction, ray.direction)) {
      const Vec3 o = ray.direction * shift - to_base;
      oz = dot(o, f.m_axis);
      dz = dot(ray.direction, f.m_axis);
      op = o - f.m_axis * oz;
      dp = ray.direction - f.m_axis * dz;
    }
    Vec3 to_base;   ///< from the ray's origin
    double shift;   ///< t of that point
    Vec3 op, dp;    ///< point and direction, across the axis
    double oz, dz;  ///< along it, from the base
  };
  /// Where the line is between the planes of the ends; false: nowhere. An end's crossing is that of its
  /// plane to the last bit, so that one that stands on a plane ties with it.
  bool between_ends(const AboutIt& at, Crossing& in, Crossing& leave) const {
    in = {-Bounds::kInf, kSide};
    leave = {Bounds::kInf, kSide};
    if (at.dz == 0.0) return at.oz >= 0.0 && at.oz <= m_length;
    const double above = dot(at.to_base, m_axis);
    const Crossing base{above / at.dz, kBase}, cap{(above + m_length) / at.dz, kCap};
    in = at.dz > 0.0 ? base : cap;
    leave = at.dz > 0.0 ? cap : base;
    return true;
  }

  Vec3 m_base, m_axis;  ///< axis unit, from base to cap
  double m_length;
  double m_base_radius, m_cap_radius, m_slope;  ///< radius at height z: base_radius + slope * z
  bool m_open;

 private:
  bool within(const Vec3& p) const;
};

}  // namespace lentray::core
