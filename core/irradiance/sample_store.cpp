#include "core/irradiance/sample_store.h"

#include <algorithm>
#include <cmath>

namespace lentray::core {
namespace {

constexpr double kOctreeOrigin = -1e7;  ///< of each axis
constexpr double kMostCells = 1e9;      ///< along an axis: cells are not smaller
constexpr double kDeepOverfill = 8.0;   ///< boxes of deeper samples are smaller: fewer are found
constexpr double kLightLowWeight =
    0.25;  ///< what the error bound grows by at most, see error_bound_at

std::array<std::int64_t, 3> cell_of(const Vec3& p, double side) {
  return {static_cast<std::int64_t>(std::floor(p.x / side)),
          static_cast<std::int64_t>(std::floor(p.y / side)),
          static_cast<std::int64_t>(std::floor(p.z / side))};
}

}  // namespace

std::size_t SampleStore::CellHash::operator()(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int64_t place : cell) {
    hash = (hash ^ static_cast<std::uint64_t>(place)) * 0x9e3779b97f4a7c15ull;
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

SampleStore::SampleStore(const RadiositySettings& settings, int depth)
    : m_octree_factor(settings.error_bound * std::ldexp(1.0, depth) /
                      (depth == 0 ? 1.0 : kDeepOverfill)),
      m_reach_factor(
          (settings.error_bound * std::max(1.0, settings.low_error_factor) + kLightLowWeight) *
          std::ldexp(1.0, depth)) {}

/// The smallest cell of the octree that holds the sample's box.
SampleStore::Region SampleStore::region_of(const IrradianceSample& sample) const {
  const double radius = sample.radius * m_octree_factor;
  const Vec3 least = sample.point - Vec3(radius);
  const double farthest =
      std::max({std::fabs(least.x), std::fabs(least.y), std::fabs(least.z)}) - kOctreeOrigin;
  double side = std::exp2(
      std::max(std::floor(std::log2(2.0 * radius)), std::ceil(std::log2(farthest / kMostCells))));
  const Vec3 place = sample.point - Vec3(kOctreeOrigin);
  for (;; side *= 2.0) {
    Vec3 middle;
    bool holds = true;
    for (int axis = 0; axis < 3; ++axis) {
      middle[axis] = (std::floor(place[axis] / side) + 0.5) * side;
      holds = holds && std::fabs(place[axis] - middle[axis]) + radius < side;
    }
    if (holds) return {middle + Vec3(kOctreeOrigin), side};
  }
}

void SampleStore::add(const IrradianceSample& sample) {
  const auto index = static_cast<std::uint32_t>(m_samples.size());
  m_samples.push_back(sample);
  m_regions.push_back(region_of(sample));
  const double reach = sample.radius * m_reach_factor;
  const int size = static_cast<int>(std::ceil(std::log2(2.0 * reach)));
  Grid& grid = m_grids[size];
  grid.side = std::exp2(size);
  const Cell first = cell_of(sample.point - Vec3(reach), grid.side);
  const Cell last = cell_of(sample.point + Vec3(reach), grid.side);
  for (std::int64_t x = first[0]; x <= last[0]; ++x) {
    for (std::int64_t y = first[1]; y <= last[1]; ++y) {
      for (std::int64_t z = first[2]; z <= last[2]; ++z) grid.cells[{x, y, z}].push_back(index);
    }
  }
}

Reuse SampleStore::find(const ReuseQuery& query, std::size_t limit) const {
  Reuse found;
  double red = 0.0, green = 0.0, blue = 0.0;
  for (const auto& [size, grid] : m_grids) {
    const auto cell = grid.cells.find(cell_of(query.point, grid.side));
    if (cell == grid.cells.end()) continue;
    for (const std::uint32_t index : cell->second) {
      if (index >= limit) break;
      const Region& region = m_regions[index];
      const Vec3 aside = query.point - region.middle;
      if (!(std::fabs(aside.x) < region.half && std::fabs(aside.y) < region.half &&
            std::fabs(aside.z) < region.half)) {
        continue;
      }
      const IrradianceSample& sample = m_samples[index];
      const double weight = reuse_weight(sample, query) * sample.quality;
      if (!(weight > 0.0)) continue;
      found.weight += weight;
      red += weight * sample.light.r;
      green += weight * sample.light.g;
      blue += weight * sample.light.b;
    }
  }
  if (found.weight > 0.0) {
    found.light =
        Rgb(static_cast<float>(red / found.weight), static_cast<float>(green / found.weight),
            static_cast<float>(blue / found.weight));
  }
  return found;
}

std::size_t SampleStore::bytes() const {
  std::size_t bytes = m_samples.capacity() * (sizeof(IrradianceSample) + sizeof(Region));
  for (const auto& [size, grid] : m_grids) {
    for (const auto& [cell, entries] : grid.cells) {
      bytes += sizeof(cell) + sizeof(entries) + 2 * sizeof(void*) +
               entries.capacity() * sizeof(std::uint32_t);
    }
  }
  return bytes;
}

}  // namespace lentray::core
