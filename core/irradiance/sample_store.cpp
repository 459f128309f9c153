#include "core/irradiance/sample_store.h"

namespace lentray::core {
namespace {

constexpr double kDeepOverfill = 8.0;  ///< boxes of deeper samples are smaller: fewer are found

}  // namespace

SampleStore::SampleStore(const RadiositySettings& settings, int depth)
    : m_octree_factor(settings.error_bound * std::ldexp(1.0, depth) /
                      (depth == 0 ? 1.0 : kDeepOverfill)) {}

/// The smallest cell of the octree that holds the sample's box.
SampleStore::Region SampleStore::region_of(const IrradianceSample& sample) const {
  const double radius = sample.radius * m_octree_factor;
  const Vec3 beyond = SampleGrid::beyond_origin(sample.point);
  Region region{{}, std::ldexp(1.0, std::ilogb(2.0 * radius))};
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

Reuse SampleStore::find(const ReuseQuery& query, std::size_t limit) const {
  Reuse found;
  double red = 0.0, green = 0.0, blue = 0.0;
  const Vec3 beyond = SampleGrid::beyond_origin(query.point);
  m_grid.near(query, limit, [&](std::uint32_t index) {
    const IrradianceSample& sample = m_samples[index];
    const double weight = reuse_weight(sample, query) * sample.quality;
    if (!(weight > 0.0) || !m_regions[index].holds(beyond)) return;
    found.weight += weight;
    red += weight * sample.light.r;
    green += weight * sample.light.g;
    blue += weight * sample.light.b;
  });
  if (found.weight > 0.0) {
    found.light =
        Rgb(static_cast<float>(red / found.weight), static_cast<float>(green / found.weight),
            static_cast<float>(blue / found.weight));
  }
  return found;
}

std::size_t SampleStore::bytes() const {
  return m_samples.capacity() * (sizeof(IrradianceSample) + sizeof(Region)) + m_grid.bytes();
}

}  // namespace lentray::core
