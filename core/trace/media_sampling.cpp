#include "core/trace/media_sampling.h"

#include <algorithm>

namespace lentray::core {
namespace {

/// A sample as if all of the interval were like it: extinction is the optical depth.
MediaPoint sample(MediaProbe& probe, const MediaInterval& interval, double place) {
  const double distance = interval.from + place * interval.length;
  return probe.at(distance, interval.lit) * static_cast<float>(interval.length);
}

/// The light of a sample is dimmed by the part of the interval before it.
void add_sample(MediaProbe& probe, MediaInterval& interval, double place) {
  const MediaPoint point = sample(probe, interval, place);
  const Rgb source = point.source * transmittance(point.extinction * static_cast<float>(place));
  interval.source += source;
  interval.squares += source * source;
  interval.depth += point.extinction;
  ++interval.samples;
}

bool is_settled(const MediaInterval& interval, double limit) {
  const float n = 1.0f / static_cast<float>(interval.samples);
  const Rgb mean = interval.source * n;
  const Rgb variance = (interval.squares * n - mean * mean) * n;
  return variance.r < limit && variance.g < limit && variance.b < limit;
}

void add_more(const SamplingPlan& plan, MediaProbe& probe, MediaInterval& interval) {
  const auto most = static_cast<int>(plan.variance_limits.size());
  while (interval.samples <= most &&
         !is_settled(interval, plan.variance_limits[interval.samples - 1])) {
    add_sample(probe, interval, probe.random());
  }
}

/// Means over a part of an interval, from samples at its ends and between.
class Adaptive {
 public:
  Adaptive(const SamplingPlan& plan, MediaProbe& probe, const MediaInterval& interval)
      : m_jitter(plan.sampling.jitter), m_threshold(plan.aa_threshold), m_probe(probe),
        m_interval(interval) {}

  MediaPoint at(double place, double spacing) {
    if (m_jitter != 0.0) place += spacing * m_jitter * (m_probe.random() - 0.5);
    return sample(m_probe, m_interval, place);
  }

  /// From the samples at the part's ends. Where they differ from that in its middle, each half has a
  /// mean of its own; else an end counts twice as much as the middle, which both halves share.
  MediaPoint mean(double from, double to, const MediaPoint& first, const MediaPoint& last,
                  int depth) {
    constexpr float kThird = 1.0f / 3.0f, kSixth = 1.0f / 6.0f;
    const double middle = 0.5 * (from + to);
    const MediaPoint centre = at(middle, to - from);
    MediaPoint sum;
    if (depth > 0 && difference(first.source, centre.source) > m_threshold) {
      sum += mean(from, middle, first, centre, depth - 1) * 0.5f;
    } else {
      sum += first * kThird;
      sum += centre * kSixth;
    }
    if (depth > 0 && difference(centre.source, last.source) > m_threshold) {
      sum += mean(middle, to, centre, last, depth - 1) * 0.5f;
    } else {
      sum += centre * kSixth;
      sum += last * kThird;
    }
    return sum;
  }

 private:
  const double m_jitter, m_threshold;
  MediaProbe& m_probe;
  const MediaInterval& m_interval;
};

/// Methods 1 and 2.
void sample_at_random(const SamplingPlan& plan, MediaProbe& probe,
                      std::span<MediaInterval> intervals) {
  const MediumSampling& sampling = plan.sampling;
  for (MediaInterval& interval : intervals) {
    for (int i = 0; i < sampling.min_samples; ++i) {
      const double place = sampling.method == SamplingMethod::kEven
                               ? (i + 0.5 + probe.random() * sampling.jitter) / sampling.min_samples
                               : probe.random();
      add_sample(probe, interval, place);
    }
  }
  if (sampling.max_samples <= sampling.min_samples) return;
  if (plan.variance_limits.empty()) return;
  for (MediaInterval& interval : intervals) add_more(plan, probe, interval);
}

/// Method 3.
void sample_adaptively(const SamplingPlan& plan, MediaProbe& probe,
                       std::span<MediaInterval> intervals) {
  const int parts = std::max(plan.sampling.min_samples / 2 + 1, 2);
  // The last sample lies a step before the interval's end.
  const double step = 1.0 / (parts + 1);
  for (MediaInterval& interval : intervals) {
    Adaptive adaptive(plan, probe, interval);
    MediaPoint before = adaptive.at(0.0, step);
    for (int i = 1; i <= parts; ++i) {
      const double place = i * step;
      const MediaPoint after = adaptive.at(place, step);
      const MediaPoint mean =
          adaptive.mean(place - step, place, before, after, plan.sampling.aa_level - 1);
      interval.source +=
          mean.source * transmittance(interval.depth * (1.0f / static_cast<float>(parts)));
      interval.depth += mean.extinction;
      before = after;
    }
    interval.samples = parts;
  }
}

}  // namespace

void sample_media(const SamplingPlan& plan, MediaProbe& probe, std::span<MediaInterval> intervals) {
  const bool is_adaptive = plan.sampling.method == SamplingMethod::kAdaptive;
  (is_adaptive ? sample_adaptively : sample_at_random)(plan, probe, intervals);
}

}  // namespace lentray::core
