// Focal blur: a sample of a picture is the mean of rays that start at points of the camera's
// aperture and pass through places of the pixel. This file says which points and places, and when
// there are enough of them; the camera turns them into rays (RaySource::lens_ray_at).
//
// The aperture's plane has its own units: the disc is 1 wide about the origin, x and y are
// -1/2..1/2. A FocalBlur is immutable, any number of threads; a BlurEstimate is one sample's.
// Source: reference manual 3.7, "Focal Blur"; the points, the batches and the rule by which rays
// end early were measured on stock and are compared with it by tests/image/focal_blur_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/vec3.h"
#include "core/render/ray_source.h"
#include "core/trace/radiance.h"
#include "core/trace/random_key.h"

namespace lentray::core {

/// How far from the mean of infinitely many rays a sample may be.
struct FocalBlurOptions {
  int most = 0, least = 0;  ///< blur_samples: rays a sample; most > 0
  double confidence = 0.9;  ///< 0..1, both excluded
  double variance = 1.0 / 10000.0;
  /// Bokeh: how likely a ray starts at a point of the square (0..1)^2. Empty: the disc.
  std::function<double(double x, double y)> weight{};
};

class FocalBlur {
 public:
  /// More rays a sample than this are not taken.
  static constexpr int kMostRays = 1 << 16;

  /// After so many rays a sample is done if all its variances are below the threshold.
  struct Stop {
    int rays = 0;
    double threshold = 0.0;
  };

  explicit FocalBlur(const FocalBlurOptions& options);

  /// Where the rays of every sample start, but for jitter.
  const std::vector<Vec2>& points() const { return m_points; }
  /// A point moves by up to this along x and along y.
  double jitter() const { return m_jitter; }
  /// By rays, ascending; the last one's are all.
  const std::vector<Stop>& stops() const { return m_stops; }
  int least() const { return m_least; }

 private:
  int m_least;
  double m_jitter;
  std::vector<Vec2> m_points;
  std::vector<Stop> m_stops;
};

/// One ray of a sample.
struct BlurRay {
  double across = 0.0, down = 0.0;  ///< further in the pixel, -1/2..1/2 of its area
  double x = 0.0, y = 0.0;          ///< in the aperture's plane
};

/// The rays of one sample and their mean.
class BlurEstimate {
 public:
  BlurEstimate(const FocalBlur& blur, std::uint64_t key);
  /// How many more rays are wanted, until the next look at the variances; 0: no more.
  std::uint32_t more();
  /// One of the rays of the sample. `key`: its own; its random numbers follow from it.
  BlurRay ray(std::uint32_t number, std::uint64_t key) const;
  /// What the next ray sees.
  void add(const Radiance& light);
  Radiance mean() const;

 private:
  const FocalBlur* m_blur;
  double m_across, m_down;  ///< where the sequence of places in the pixel begins
  int m_rays = 0;
  std::size_t m_stop = 0;
  std::array<double, 4> m_sum{}, m_squares{};
};

}  // namespace lentray::core
