// The three methods by which media are sampled along a ray. Knows nothing of what is sampled: it asks
// a probe. One call a ray.
// Source: reference manual 3.7, "Sampling Parameters & Methods"; places and weights of the samples
// are stock's, measured in tests/image/media_test.cpp.
#pragma once

#include <span>

#include "core/base/color.h"
#include "core/trace/media_intervals.h"

namespace lentray::core {

/// What media do at a point, a scene unit of them.
struct MediaPoint {
  Rgb source;      ///< light that they send towards the ray's origin
  Rgb extinction;  ///< share of what passes that they take away
  MediaPoint& operator+=(const MediaPoint& o) {
    source += o.source;
    extinction += o.extinction;
    return *this;
  }
  friend MediaPoint operator*(const MediaPoint& p, float s) {
    return {p.source * s, p.extinction * s};
  }
};

class MediaProbe {
 public:
  virtual ~MediaProbe() = default;
  /// `lit`: whether any light may reach it.
  virtual MediaPoint at(double distance, bool lit) = 0;
  /// In [0, 1).
  virtual double random() = 0;
};

struct SamplingPlan {
  const MediumSampling& sampling;
  double aa_threshold;                      ///< the least of all media
  std::span<const double> variance_limits;  ///< empty: no more samples than the least
};

/// By the method of the plan's settings.
void sample_media(const SamplingPlan& plan, MediaProbe& probe, std::span<MediaInterval> intervals);

}  // namespace lentray::core
