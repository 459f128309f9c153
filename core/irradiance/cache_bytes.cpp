#include "core/irradiance/cache_bytes.h"

#include <cmath>
#include <cstdint>

#include "core/base/byte_text.h"

namespace lentray::core {
namespace {

// A member more must be kept too.
static_assert(sizeof(IrradianceSample) == 9 * sizeof(double) + 6 * sizeof(float));
static_assert(std::is_trivially_copyable_v<IrradianceSample>);

/// A pixel's sight that is more than a number of samples.
struct Gathered {
  std::uint32_t column, row, count;
};
/// GatheredLight without gaps.
struct Light {
  Rgb light;
  std::uint32_t is_kept;
  double quality;
};

void append_sights(const IrradianceCache& cache, std::string& out) {
  const std::uint32_t width = cache.seen_width(), height = cache.seen_height();
  append_bytes(width, out);
  append_bytes(height, out);
  std::string gathered;
  std::uint64_t count = 0;
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      const PixelSight sight = cache.sight({column, row});
      append_bytes(static_cast<std::uint32_t>(sight.samples), out);
      if (!sight.gathered) continue;
      ++count;
      append_bytes(Gathered{column, row, static_cast<std::uint32_t>(sight.gathered->size())},
                   gathered);
      for (const GatheredLight& one : *sight.gathered)
        append_bytes(Light{one.light, one.is_kept ? 1u : 0u, one.quality}, gathered);
    }
  }
  append_bytes(count, out);
  out += gathered;
}

bool take_gathered(std::string_view& bytes, const std::vector<std::uint32_t>& seen,
                   std::uint32_t width, IrradianceCache& cache) {
  Gathered head;
  if (!take_bytes(bytes, head) || head.column >= width) return false;
  const std::size_t place = std::size_t{head.row} * width + head.column;
  if (place >= seen.size() || head.count > bytes.size() / sizeof(Light)) return false;
  std::vector<GatheredLight> all(head.count);
  for (GatheredLight& one : all) {
    Light light;
    if (!take_bytes(bytes, light)) return false;
    one = {light.light, light.quality, light.is_kept != 0};
  }
  cache.see({head.column, head.row}, seen[place], std::move(all));
  return true;
}

bool take_sights(std::string_view& bytes, IrradianceCache& cache) {
  std::uint32_t width = 0, height = 0;
  if (!take_bytes(bytes, width) || !take_bytes(bytes, height)) return false;
  if (std::uint64_t{width} * height > bytes.size() / sizeof(std::uint32_t)) return false;
  cache.begin_sights(width, height);
  std::vector<std::uint32_t> seen(std::size_t{width} * height);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!take_bytes(bytes, seen[i])) return false;
    cache.see({static_cast<std::uint32_t>(i % width), static_cast<std::uint32_t>(i / width)},
              seen[i], {});
  }
  std::uint64_t count = 0;
  if (!take_bytes(bytes, count)) return false;
  for (; count > 0; --count) {
    if (!take_gathered(bytes, seen, width, cache)) return false;
  }
  return true;
}

}  // namespace

void append_samples(const std::vector<IrradianceSample>& samples, std::size_t first,
                    std::string& bytes) {
  for (std::size_t i = first; i < samples.size(); ++i) append_bytes(samples[i], bytes);
}

bool take_samples(std::string_view& bytes, std::size_t count, SampleStore& store) {
  for (IrradianceSample sample; count > 0; --count) {
    if (!take_bytes(bytes, sample)) return false;
    if (!is_finite(sample.point) || !(sample.radius > 0.0f) || !std::isfinite(sample.radius))
      return false;
    store.add(sample);
  }
  return true;
}

std::string bytes_of(const IrradianceCache& cache) {
  std::string out;
  for (int depth = 0; depth < cache.depths(); ++depth) {
    const auto& samples = cache.store(depth).samples();
    append_bytes(static_cast<std::uint64_t>(samples.size()), out);
    append_samples(samples, 0, out);
  }
  append_sights(cache, out);
  return out;
}

std::shared_ptr<IrradianceCache> cache_of(std::string_view bytes, const RadiositySettings& settings,
                                          const Vec3& eye) {
  auto cache = std::make_shared<IrradianceCache>(settings, eye);
  for (int depth = 0; depth < cache->depths(); ++depth) {
    std::uint64_t count = 0;
    if (!take_bytes(bytes, count) || !take_samples(bytes, count, cache->store(depth)))
      return nullptr;
  }
  return take_sights(bytes, *cache) && bytes.empty() ? cache : nullptr;
}

}  // namespace lentray::core
