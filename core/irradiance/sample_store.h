// The samples of a scene, found by place. World space, colours linear. Samples are added in order and
// keep it. Reading is thread-safe while nobody adds.
//
// Samples lie in the cells of an octree that reach half a side beyond themselves. A sample is seen from
// within its cell alone, also where it would reach farther: pictures depend on it.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/irradiance/sample.h"
#include "core/irradiance/sample_grid.h"
#include "core/irradiance/settings.h"

namespace lentray::core {

/// Light put together from samples.
struct Reuse {
  double weight = 0.0;  ///< sum of the samples' weights; 0: none was found
  Rgb light;            ///< their weighted mean
};

/// The samples of one depth.
class SampleStore {
 public:
  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

  /// `depth`: bounces before what the samples light.
  SampleStore(const RadiositySettings& settings, int depth);
  void add(const IrradianceSample& sample);
  /// Of the first `limit` samples.
  Reuse find(const ReuseQuery& query, std::size_t limit = kAll) const;
  /// Whether one of those from `first` on is of use.
  bool serves(const ReuseQuery& query, std::size_t first) const;

  const std::vector<IrradianceSample>& samples() const { return m_samples; }
  std::size_t bytes() const;

 private:
  /// From where a sample is seen: less than `half` beside the middle on each axis, which is told beyond
  /// SampleGrid::kOrigin.
  struct Region {
    Vec3 middle;
    double half;
    bool holds(const Vec3& beyond) const {
      return std::fabs(beyond.x - middle.x) < half && std::fabs(beyond.y - middle.y) < half &&
             std::fabs(beyond.z - middle.z) < half;
    }
  };

  Region region_of(const IrradianceSample& sample) const;

  const double m_octree_factor;  ///< a sample's radius to the half side of its box
  std::vector<IrradianceSample> m_samples;
  std::vector<Region> m_regions;  ///< of each sample
  SampleGrid m_grid;
};

}  // namespace lentray::core
