// The shadow volume of an object and a point light: up to four planes through the light along the object's outline, and
// one plane between light and object, in floats. A point outside by more than all rounding is certainly not in the
// object's shadow, and the object is not tested. A point inside may be in shadow.
// Relative to the light, in world units. Immutable, any number of threads.
// Test: tests/unit/accel/accel_light_volume_test.cpp.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "core/base/simd.h"
#include "core/base/vec3.h"

namespace lentray::core {

/// All zero: nothing is outside.
struct alignas(64) LightVolume {
  float x[4] = {}, y[4] = {}, z[4] = {};  ///< of the planes' normals, which point inwards; lengths
                                          ///< at most 1, not much less
  float plane[4] = {};                    ///< normal, away from the light; less its distance
};

/// A point, prepared for tests against many volumes.
class LightProbe {
 public:
  /// `w`: the largest component of `point`. `t_min`: the least distance of a hit along a shadow ray.
  /// `reach`: of the volumes; beyond it no point is outside.
  LightProbe(const Vec3& point, double w, double t_min, double reach)
      : m_x(simd::float4(static_cast<float>(point.x))),
        m_y(simd::float4(static_cast<float>(point.y))),
        m_z(simd::float4(static_cast<float>(point.z))),
        m_least(simd::float4(least_of(static_cast<float>(w), w < reach))),
        m_share(share_of(static_cast<float>(w), static_cast<float>(t_min))) {}
  /// The same of a point in floats, with its limits().
  LightProbe(const float* x, const float* y, const float* z, const float* least, float share)
      : m_x(simd::float4(*x)), m_y(simd::float4(*y)), m_z(simd::float4(*z)),
        m_least(simd::float4(*least)), m_share(share) {}
  /// Of four points: `in_reach` has the bits of those whose w is less than the reach.
  static void limits(Float4 w, double t_min, unsigned in_reach, float (&least)[4],
                     float (&share)[4]) {
    simd::store(least, -kSlack * w);
    for (unsigned out = ~in_reach & 15u; out != 0; out &= out - 1) {
      least[__builtin_ctz(out)] = -std::numeric_limits<float>::infinity();
    }
    simd::store(share, share_of(w, static_cast<float>(t_min)));
  }

  bool is_outside(const LightVolume& volume) const {
    const Float4 x = m_x * simd::float4_at(volume.x), y = m_y * simd::float4_at(volume.y);
    const Float4 inside = (x + y) + m_z * simd::float4_at(volume.z);
    return simd::signs(inside < m_least) != 0 || is_before(volume.plane);
  }

 private:
  /// A share of w: rounding in floats is less than half of it, rounding in doubles less than a quarter.
  static constexpr float kSlack = 0x1p-19f;

  static float least_of(float w, bool in_reach) {
    return in_reach ? -kSlack * w : -std::numeric_limits<float>::infinity();
  }
  /// A hit that is farther than t_min along the ray is farther behind the point than the share
  /// t_min / length of the plane's distance.
  template <class Floats>
  [[gnu::always_inline]] static Floats share_of(Floats w, float t_min) {
    constexpr float kLongest = 1.7320509f;  // of w
    return 1.0f + t_min / (kLongest * w);
  }
  bool is_before(const float (&plane)[4]) const {
    const float behind =
        m_x[0] * plane[0] + m_y[0] * plane[1] + m_z[0] * plane[2] + m_share * plane[3];
    return behind < m_least[0];
  }

  Float4 m_x, m_y, m_z, m_least;
  float m_share;
};

/// Makes the volumes of one light, for points within `reach` of it. `distance`: from the light to the object's box.
class LightVolumes {
 public:
  explicit LightVolumes(double reach);
  double reach() const { return m_reach; }

  LightVolume triangle(const Vec3& a, const Vec3& b, const Vec3& c, double distance) const;
  /// Adds a polygon: the ends of its edges in pairs, and its plane dot(normal, x) = offset, normal of length 1. Only
  /// convex polygons of at most four edges have planes along their outline.
  void polygon(std::span<const Vec3> edge_ends, const Vec3& normal, double offset, double distance,
               LightVolume& volume) const;
  LightVolume sphere(const Vec3& centre, double radius, double distance) const;
  /// A cone or a cylinder: centres and radii of its ends.
  LightVolume cone(const Vec3& a, double radius_a, const Vec3& b, double radius_b,
                   double distance) const;
  /// Adds a box, rotated or not, with corners in the order of add_corners(): the face that appears largest, and planes
  /// along four edges where they leave a cross-section less than `area` at distance 1.
  void box(std::span<const Vec3> corners, double distance, double area, LightVolume& volume) const;

 private:
  void set_side(LightVolume& volume, int lane, const Vec3& inwards, double far, double least) const;
  void set_plane(LightVolume& volume, const Vec3& normal, double offset, double far) const;

  double m_reach;
  double m_least;  ///< least size times distance that rounding permits
};

}  // namespace lentray::core
