#include "core/irradiance/sample_store.h"

#include <algorithm>
#include <cmath>

namespace lentray::core {
namespace {

constexpr double kDeepOverfill = 8.0;  ///< boxes of deeper samples are smaller: fewer are found
constexpr double kMostCells = 1e9;     ///< along an axis: cells are not smaller

/// Of the cells near a box that begins at `least`.
double least_side(const Vec3& least) {
  const double farthest = std::max({std::fabs(least.x), std::fabs(least.y), std::fabs(least.z)});
  const double beyond = farthest - SampleGrid::kOrigin;
  return std::exp2(std::ceil(std::log2(beyond / kMostCells)));
}

}  // namespace

SampleStore::SampleStore(const RadiositySettings& settings, int depth)
    : m_octree_factor(settings.error_bound * std::ldexp(1.0, depth) /
                      (depth == 0 ? 1.0 : kDeepOverfill)) {}

/// The smallest cell of the octree that holds the sample's box.
SampleStore::Region SampleStore::region_of(const IrradianceSample& sample) const {
  const double radius = sample.radius * m_octree_factor;
  const Vec3 beyond = SampleGrid::beyond_origin(sample.point);
  Region region{
      {},
      std::max(std::ldexp(1.0, std::ilogb(2.0 * radius)), least_side(sample.point - Vec3(radius)))};
  const auto place = [&](double at) { return (std::floor(at / region.half) + 0.5) * region.half; };
  const Vec3 low = SampleGrid::beyond_origin(sample.point - Vec3(radius));
  const Vec3 high = SampleGrid::beyond_origin(sample.point + Vec3(radius));
  for (;; region.half *= 2.0) {
    region.middle = {place(beyond.x), place(beyond.y), place(beyond.z)};
    if (region.holds(low) && region.holds(high)) return region;
  }
}

void SampleStore::add(const IrradianceSample& sample) {
  const Region region = region_of(sample);
  m_grid.add(static_cast<std::uint32_t>(m_samples.size()), sample, region.middle, region.half);
  m_samples.push_back(sample);
  m_regions.push_back(region);
}

namespace {

/// The weighted mean of samples.
class ReuseSum {
 public:
  void add(const IrradianceSample& sample, double weight) {
    m_weight += weight;
    m_red += weight * sample.light.r;
    m_green += weight * sample.light.g;
    m_blue += weight * sample.light.b;
  }
  Reuse mean() const {
    if (!(m_weight > 0.0)) return {};
    return {m_weight,
            Rgb(static_cast<float>(m_red / m_weight), static_cast<float>(m_green / m_weight),
                static_cast<float>(m_blue / m_weight))};
  }

 private:
  double m_weight = 0.0, m_red = 0.0, m_green = 0.0, m_blue = 0.0;
};

}  // namespace

Reuse SampleStore::find(const ReuseQuery& query, std::size_t limit) const {
  const Vec3 beyond = SampleGrid::beyond_origin(query.point);
  const ReuseRule rule(query);
  ReuseSum sum;
  const auto add = [&](std::uint32_t index, double weight) {
    const IrradianceSample& sample = m_samples[index];
    if (weight > 0.0 && m_regions[index].holds(beyond)) sum.add(sample, weight * sample.quality);
  };
  const auto add_two = [&](std::uint32_t first, std::uint32_t second) {
    const Double2 weights = rule.weights(m_samples[first], m_samples[second]);
    add(first, weights[0]);
    add(second, weights[1]);
  };
  constexpr std::uint32_t kNone = 0xffffffff;
  std::uint32_t waits = kNone;  // until there are two
  m_grid.near(query, limit, [&](std::uint32_t index) {
    if (waits == kNone) {
      waits = index;
      return;
    }
    add_two(waits, index);
    waits = kNone;
  });
  if (waits != kNone) add(waits, rule.weights(m_samples[waits], m_samples[waits])[0]);
  return sum.mean();
}

bool SampleStore::serves(const ReuseQuery& query, std::size_t first) const {
  const Vec3 beyond = SampleGrid::beyond_origin(query.point);
  for (std::size_t i = first; i < m_samples.size(); ++i) {
    if (m_regions[i].holds(beyond) && reuse_weight(m_samples[i], query) > 0.0) return true;
  }
  return false;
}

std::size_t SampleStore::bytes() const {
  return m_samples.capacity() * (sizeof(IrradianceSample) + sizeof(Region)) + m_grid.bytes();
}

}  // namespace lentray::core
