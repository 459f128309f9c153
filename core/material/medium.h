// A participating medium: what it does to light at a point, and how rays through it are sampled.
// World space; amounts are those of one scene unit. Immutable.
// Source: reference manual 3.7, "Media"; what the manual leaves open is in docs/media.md.
#pragma once

#include <cmath>
#include <vector>

#include "core/base/color.h"
#include "core/base/vec3.h"
#include "core/material/phase_function.h"
#include "core/material/pigments.h"

namespace lentray::core {

/// What an optical depth lets through.
inline Rgb transmittance(const Rgb& depth) {
  if (depth.r == depth.g && depth.g == depth.b) {
    return depth.r == 0.0f ? Rgb(1.0f) : Rgb(std::exp(-depth.r));
  }
  return {std::exp(-depth.r), std::exp(-depth.g), std::exp(-depth.b)};
}

/// Numbers are those of `method`.
enum class SamplingMethod { kRandom = 1, kEven = 2, kAdaptive = 3 };

struct MediumSampling {
  SamplingMethod method = SamplingMethod::kAdaptive;
  int intervals = 1;                       ///< at least so many pieces of a ray's way are sampled
  int min_samples = 10, max_samples = 10;  ///< of an interval; the most are for methods 1 and 2
  double confidence = 0.9, variance = 1.0 / 128.0;  ///< when methods 1 and 2 have enough samples
  double ratio = 0.9;         ///< share of the intervals for lit parts of the way
  double jitter = 0.0;        ///< of a sample, in distances of samples
  double aa_threshold = 0.1;  ///< colours that differ by more have another sample between them
  int aa_level = 3;           ///< how often at most a part is halved

  bool is_random() const {
    return method == SamplingMethod::kRandom || jitter != 0.0 ||
           (method == SamplingMethod::kEven && max_samples > min_samples);
  }
};

struct Medium {
  Rgb absorption, emission, scattering;
  double extinction_of_scattering = 1.0;  ///< how much of what is scattered the ray loses
  PhaseFunction phase;
  bool collects_photons = true;
  MediumSampling sampling;
  std::vector<double> variance_limits;  ///< find_variance_limits(sampling)
  /// Multiplied; amounts are multiplied by the product. Those that take little time come first: what is
  /// black asks no more.
  std::vector<PigmentPtr> densities;

  Rgb density(const Vec3& point) const {
    Rgb product(1.0f);
    for (const PigmentPtr& density : densities) {
      product *= density->colour(point).rgb;
      if (product.is_black()) break;
    }
    return product;
  }
  /// What a ray loses, of both causes.
  Rgb extinction() const {
    return absorption + scattering * static_cast<float>(extinction_of_scattering);
  }
  bool dims() const { return !absorption.is_black() || !scattering.is_black(); }
  bool scatters() const { return !scattering.is_black(); }
  /// The same amounts everywhere.
  bool is_even() const {
    for (const PigmentPtr& density : densities) {
      if (!density->constant()) return false;
    }
    return true;
  }
};

/// For each number of samples from 1 to max_samples: the variance of their mean that is small enough,
/// by the chi-square test of `confidence`.
std::vector<double> find_variance_limits(const MediumSampling& sampling);

}  // namespace lentray::core
