#include "core/irradiance/sample.h"

#include <cmath>

namespace lentray::core {
namespace {

constexpr double kSamePlace = 1e-6;     ///< scene units: there is no direction between such points
constexpr double kBehindLimit = -0.05;  ///< cosine: samples farther in front may be in shadow
constexpr double kLeastWeight = 1e-3;

double weight_of(double share, bool smooth) {
  if (!smooth) return 1.0 - share;
  if (share < 0.5) return 1.0 - 2.0 * share * share;
  return 2.0 * (1.0 - share) * (1.0 - share);
}

}  // namespace

double reuse_weight(const IrradianceSample& sample, const ReuseQuery& query) {
  const Vec3 delta = query.point - sample.point;
  const double squared = length_squared(delta);
  const double reach = sample.radius * query.error_bound;
  if (!(squared < reach * reach)) return 0.0;
  const double distance = std::sqrt(squared);
  const bool apart = distance > kSamePlace;
  const Vec3 along = apart ? delta / distance : Vec3();
  double radius = sample.radius;
  // Towards the nearest thing light changes sooner.
  const double towards = dot(sample.to_nearest, along);
  if (towards > 0.0) radius = towards * sample.nearest + (1.0 - towards) * radius;
  if (!(distance < radius * query.error_bound)) return 0.0;
  const double turn = 2.0 * std::sqrt(std::fabs(1.0 - dot(query.normal, sample.normal)));
  const double error = distance / radius + turn;
  if (!(error < query.error_bound)) return 0.0;
  double behind = 1.0;
  if (apart) {
    const Vec3 half = query.normal + sample.normal;
    behind = dot(along, half) / length(half);
  }
  if (!(behind > kBehindLimit)) return 0.0;
  double weight = weight_of(error / query.error_bound, query.smooth);
  if (behind <= 0.0) weight *= 1.0 - behind / kBehindLimit;
  return weight > kLeastWeight ? weight : 0.0;
}

}  // namespace lentray::core
