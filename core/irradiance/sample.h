// Light that was gathered at a point of a surface, and how far it may be used again. World space, colours
// linear. Plain values.
// Source: Ward, Rubinstein and Clear, SIGGRAPH 1988; the rule of reuse in detail is the one that replays
// stock's pictures.
#pragma once

#include "core/base/color.h"
#include "core/base/simd.h"
#include "core/base/vec3.h"

namespace lentray::core {

struct IrradianceSample {
  Vec3 point, normal;
  Vec3 to_nearest;       ///< unit, towards the nearest thing that was met; null: nothing was
  Rgb light;             ///< the mean of what the gather's rays brought
  float radius = 0.0f;   ///< harmonic mean of the distances, within the lengths of reuse
  float nearest = 0.0f;  ///< distance of the nearest thing
  float quality = 0.0f;  ///< 0..1: how good the samples were that the gather used itself
};

/// A place whose light is asked for.
struct ReuseQuery {
  Vec3 point, normal;
  double error_bound;  ///< the greatest error, factors of the depth included
  bool smooth;         ///< weights fall off without an edge: of the first depth, in the picture
};

/// The rule of reuse for two samples at once, whose data are read as they lie. Not fused: the bits are those of one
/// after the other.
class ReuseRule {
 public:
  explicit ReuseRule(const ReuseQuery& query)
      : m_point(all(query.point)), m_normal(all(query.normal)),
        m_bound(simd::double2(query.error_bound)), m_smooth(query.smooth) {}

  /// How much each counts, 0..1; 0: it is of no use. Their qualities are not in it.
  Double2 weights(const IrradianceSample& a, const IrradianceSample& b) const {
    constexpr double kSamePlace = 1e-6;  ///< scene units: there is no direction between such points
    constexpr double kLeastWeight = 1e-3;
    const Double2 radius{a.radius, b.radius}, reach = radius * m_bound;
    const Three away = m_point - both(a.point, b.point), normal = both(a.normal, b.normal);
    const Double2 squared = dot(away, away), distance = simd::sqrt(squared);
    const Long2 apart = distance > kSamePlace;
    const Three along = where(apart, away / distance);
    // Towards the nearest thing light changes sooner.
    const Double2 towards = dot(both(a.to_nearest, b.to_nearest), along);
    const Double2 nearest{a.nearest, b.nearest};
    const Double2 holds = towards > 0.0 ? towards * nearest + (1.0 - towards) * radius : radius;
    const Double2 turned = 2.0 * simd::sqrt(simd::abs(1.0 - dot(m_normal, normal)));
    const Double2 error = distance / holds + turned;
    const Three normals = m_normal + normal;
    const Double2 in_front = dot(along, normals) / simd::sqrt(dot(normals, normals));
    const Double2 seen = apart ? weights_in_front(in_front) : simd::double2(1.0);
    const Double2 weight = weights_of(error / m_bound) * seen;
    return where((squared < reach * reach) & (error < m_bound) & (weight > kLeastWeight), weight);
  }

 private:
  struct Three {
    Double2 x, y, z;
    Three operator-(const Three& o) const { return {x - o.x, y - o.y, z - o.z}; }
    Three operator+(const Three& o) const { return {x + o.x, y + o.y, z + o.z}; }
    Three operator/(Double2 d) const { return {x / d, y / d, z / d}; }
  };
  static Three all(const Vec3& v) {
    return {simd::double2(v.x), simd::double2(v.y), simd::double2(v.z)};
  }
  static Three both(const Vec3& a, const Vec3& b) {
    return {Double2{a.x, b.x}, Double2{a.y, b.y}, Double2{a.z, b.z}};
  }
  static Double2 dot(const Three& a, const Three& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  /// 0 elsewhere.
  static Double2 where(Long2 lanes, Double2 v) { return Double2(Long2(v) & lanes); }
  static Three where(Long2 lanes, const Three& v) {
    return {where(lanes, v.x), where(lanes, v.y), where(lanes, v.z)};
  }
  /// Of errors that are these shares of the greatest one.
  Double2 weights_of(Double2 share) const {
    const Double2 rest = 1.0 - share;
    if (!m_smooth) return rest;
    return share < 0.5 ? 1.0 - 2.0 * share * share : 2.0 * rest * rest;
  }
  /// Of samples that lie in front of the place, where they may be in shadow: by the cosine to both normals.
  static Double2 weights_in_front(Double2 cosine) {
    constexpr double kMost = -0.05;
    const Double2 fading = where(cosine > kMost, 1.0 - cosine / kMost);
    return cosine > 0.0 ? simd::double2(1.0) : fading;
  }

  const Three m_point, m_normal;
  const Double2 m_bound;
  const bool m_smooth;
};

/// Of one sample.
inline double reuse_weight(const IrradianceSample& sample, const ReuseQuery& query) {
  return ReuseRule(query).weights(sample, sample)[0];
}

}  // namespace lentray::core
