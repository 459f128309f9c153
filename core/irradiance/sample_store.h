// The samples of a scene, found by place. World space, colours linear. Samples are added in order and
// keep it. Reading is thread-safe while nobody adds.
//
// Stock keeps samples in an octree whose cells reach half a side beyond themselves, and sees a sample from
// within its cell alone, also where it would reach farther: pictures depend on it, so it holds here. The
// search itself is by a grid for each order of size of what samples reach, so that one cell a grid is
// looked into.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <unordered_map>
#include <vector>

#include "core/irradiance/sample.h"
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

  const std::vector<IrradianceSample>& samples() const { return m_samples; }
  std::size_t bytes() const;

 private:
  /// From where a sample is seen: less than `half` beside the middle on each axis.
  struct Region {
    Vec3 middle;
    double half;
  };
  struct CellHash {
    std::size_t operator()(const std::array<std::int64_t, 3>& cell) const;
  };
  using Cell = std::array<std::int64_t, 3>;
  struct Grid {
    double side;
    std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells;
  };

  Region region_of(const IrradianceSample& sample) const;

  const double m_octree_factor;  ///< a sample's radius to the half side of its box
  const double m_reach_factor;   ///< a sample's radius to the farthest place that may use it
  std::vector<IrradianceSample> m_samples;
  std::vector<Region> m_regions;  ///< of each sample
  std::map<int, Grid> m_grids;    ///< by the binary logarithm of the side
};

}  // namespace lentray::core
