// Light that was gathered at a point of a surface, and how far it may be used again. World space, colours
// linear. Plain values.
// Source: Ward, Rubinstein and Clear, SIGGRAPH 1988; the rule of reuse in detail is the one that replays
// stock's pictures.
#pragma once

#include <cmath>

#include "core/base/color.h"
#include "core/base/vec3.h"

namespace lentray::core {

struct IrradianceSample {
  Vec3 point, normal;
  Vec3 to_nearest;       ///< unit, towards the nearest thing that was met; null: nothing was
  Rgb light;             ///< the mean of what the gather's rays brought
  float radius = 0.0f;   ///< harmonic mean of the distances, within the lengths of reuse
  float nearest = 0.0f;  ///< distance of the nearest thing
  float quality = 0.0f;  ///< 0..1: how good the samples were that the gather used itself
  /// How far it holds along a unit vector: less far towards the nearest thing, where light changes sooner.
  double radius_along(const Vec3& along) const {
    const double towards = dot(to_nearest, along);
    return towards > 0.0 ? towards * nearest + (1.0 - towards) * radius : double{radius};
  }
};

/// A place whose light is asked for.
struct ReuseQuery {
  Vec3 point, normal;
  double error_bound;  ///< the greatest error, factors of the depth included
  bool smooth;         ///< weights fall off without an edge: of the first depth, in the picture
};

/// Of an error that is this share of the greatest one.
inline double weight_of(double share, bool smooth) {
  const double rest = 1.0 - share;
  if (!smooth) return rest;
  return share < 0.5 ? 1.0 - 2.0 * share * share : 2.0 * rest * rest;
}

/// Of a sample that lies in front of the place, where it may be in shadow: by the cosine to both normals.
inline double weight_in_front(double cosine) {
  constexpr double kMost = -0.05;
  if (!(cosine > kMost)) return 0.0;
  return cosine > 0.0 ? 1.0 : 1.0 - cosine / kMost;
}

/// How much a sample counts there, 0..1; 0: it is of no use. The sample's quality is not in it.
inline double reuse_weight(const IrradianceSample& sample, const ReuseQuery& query) {
  constexpr double kSamePlace = 1e-6;  ///< scene units: there is no direction between such points
  constexpr double kLeastWeight = 1e-3;
  const Vec3 away = query.point - sample.point;
  const double reach = sample.radius * query.error_bound, squared = length_squared(away);
  if (!(squared < reach * reach)) return 0.0;
  const double distance = std::sqrt(squared);
  const bool is_apart = distance > kSamePlace;
  const Vec3 along = is_apart ? away / distance : Vec3();
  const double error = distance / sample.radius_along(along) +
                       2.0 * std::sqrt(std::fabs(1.0 - dot(query.normal, sample.normal)));
  if (!(error < query.error_bound)) return 0.0;
  double weight = weight_of(error / query.error_bound, query.smooth);
  if (is_apart) {
    const Vec3 normals = query.normal + sample.normal;
    weight *= weight_in_front(dot(along, normals) / length(normals));
  }
  return weight > kLeastWeight ? weight : 0.0;
}

}  // namespace lentray::core
