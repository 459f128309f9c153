#include "core/render/sampler.h"

#include <algorithm>
#include <numeric>

#include "core/trace/random_key.h"

namespace lentray::core {
namespace {

constexpr Radiance kNothing{Rgb(), 1.0f};

std::uint64_t key_of(const SamplePlace& wanted) {
  return sample_key(wanted.place.column, wanted.place.row, wanted.index);
}

/// Caches of shadows know the picture's pixels only.
Pixel nearest_pixel(const PixelPlace& place) {
  return {static_cast<std::uint32_t>(std::max(place.column, 0)),
          static_cast<std::uint32_t>(std::max(place.row, 0))};
}

/// Rays that are followed one by one are those of one sample, so that caches of shadows see the picture's order.
std::size_t samples_a_block(bool together, bool is_mean) {
  if (!together) return 1;
  return is_mean ? 32 : 128;
}

}  // namespace

Sampler::Sampler(const RaySource& camera, const SamplerOptions& options, Integrator& integrator,
                 FirstHits* hits, RayWaves* waves, const std::atomic<bool>& cancel)
    : m_camera(camera), m_blur(camera.blur()), m_options(options),
      m_angles(static_cast<std::size_t>(std::max(1, options.angles))),
      m_rays_a_place(camera.rays_a_place()),
      m_is_mean(m_angles > 1 || m_blur || m_rays_a_place > 1), m_integrator(integrator),
      m_hits(hits && hits->works() ? hits : nullptr),
      m_waves(waves && waves->works() ? waves : nullptr), m_cancel(cancel),
      m_block(samples_a_block(m_hits || m_waves, m_is_mean)) {}

void Sampler::add(const SamplePlace& wanted) {
  const std::uint64_t key = key_of(wanted);
  if (!m_is_mean) {
    Ray ray;
    const bool has_ray = m_camera.ray_at(wanted.place, ray);
    return add_asked(0, has_ray, ray, {nearest_pixel(wanted.place), key});
  }
  if (m_angles == 1) return add_direction(wanted.place, key);
  for (std::size_t i = 0; i < m_angles; ++i) {
    PixelPlace turned = wanted.place;
    turned.turn = (static_cast<double>(i) + 0.5) / static_cast<double>(m_angles) - 0.5;
    add_direction(turned, part_key(key, static_cast<std::uint32_t>(i)));
  }
}

void Sampler::add_direction(const PixelPlace& place, std::uint64_t key) {
  const Pixel pixel = nearest_pixel(place);
  m_directions.push_back({place, key, m_camera.eye_place(pixel.column, pixel.row)});
  if (m_blur) m_estimates.emplace_back(*m_blur, key);
}

/// Rays of one number run side by side.
bool Sampler::trace_block(Layout layout) {
  if (!m_is_mean) return trace_rays(layout);
  m_open.resize(m_directions.size());
  std::iota(m_open.begin(), m_open.end(), 0u);
  std::uint32_t number = 0;
  while (const std::uint32_t more = more_rays(number)) {
    begin_rays();
    for (const std::uint32_t end = number + more; number < end; ++number) {
      for (const std::uint32_t direction : m_open) ask(direction, number);
    }
    if (!trace_rays(layout)) return false;
    for (const Asked& asked : m_asked) take(asked);
  }
  return true;
}

std::uint32_t Sampler::more_rays(std::uint32_t before) {
  if (!m_blur) return before == 0 ? m_rays_a_place : 0;
  std::uint32_t more = 0;
  std::erase_if(m_open, [&](std::uint32_t direction) {
    const std::uint32_t wanted = m_estimates[direction].more();
    more = std::max(more, wanted);
    return wanted == 0;
  });
  return more;
}

void Sampler::ask(std::uint32_t direction, std::uint32_t number) {
  Ray ray;
  SampleOfPixel of;
  const bool has_ray = find_ray(direction, number, of, ray);
  add_asked(direction, has_ray, ray, of);
}

void Sampler::add_asked(std::uint32_t direction, bool has_ray, const Ray& ray,
                        const SampleOfPixel& of) {
  m_asked.push_back(
      {direction, has_ray ? static_cast<std::uint32_t>(m_rays.size()) : Asked::kNone});
  if (!has_ray) return;
  m_rays.push_back(ray);
  m_of.push_back(of);
}

bool Sampler::find_ray(std::uint32_t number_of_direction, std::uint32_t number, SampleOfPixel& of,
                       Ray& ray) const {
  const Direction& direction = m_directions[number_of_direction];
  const PixelPlace& place = direction.place;
  of = {nearest_pixel(place), direction.key};
  if (m_blur) {
    // Numbers that are no direction's part of the sample, but for 0.
    of.key = part_key(direction.key, number * static_cast<std::uint32_t>(m_angles));
    const BlurRay way = m_estimates[number_of_direction].ray(number, of.key);
    PixelPlace through = place;
    through.across += way.across;
    through.down += way.down;
    return m_camera.lens_ray_at(through, way.x, way.y, ray);
  }
  if (m_rays_a_place == 1) return m_camera.ray_at(place, ray);
  of.key = part_key(direction.key, number);
  return m_camera.one_ray_at(place, m_camera.ray_of(direction.seen_at, number), ray);
}

bool Sampler::trace_rays(Layout layout) {
  m_seen.resize(m_rays.size());
  const std::span<const Ray> all = m_rays;
  for (std::size_t first = 0; first < all.size();) {
    std::size_t count = std::min(kTogether, all.size() - first);
    const FirstHits* hits = nullptr;
    if (m_hits && layout == Layout::kNeighbours) {
      count = m_hits->find(all.subspan(first, count));
      hits = m_hits;
    }
    trace(all.subspan(first, count), std::span(m_of).subspan(first, count), hits,
          std::span(m_seen).subspan(first, count));
    if (m_cancel.load(std::memory_order_relaxed)) return false;
    first += count;
  }
  return true;
}

void Sampler::trace(std::span<const Ray> rays, std::span<const SampleOfPixel> of,
                    const FirstHits* hits, std::span<Radiance> seen) {
  if (m_waves) return m_waves->trace(rays, of, hits, seen);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    seen[i] = hits && hits->is_known(i)
                  ? m_integrator.trace_met(rays[i], of[i].pixel, of[i].key, hits->hit(i))
                  : m_integrator.trace(rays[i], of[i].pixel, of[i].key);
  }
}

Sample Sampler::seen(const Asked& asked) const {
  if (asked.ray == Asked::kNone) return {kNothing, false};
  Sample one{m_seen[asked.ray], true};
  if (!m_options.alpha) one.seen.transmit = 0.0f;
  return one;
}

void Sampler::take(const Asked& asked) {
  Direction& direction = m_directions[asked.direction];
  const Sample one = seen(asked);
  if (m_blur) m_estimates[asked.direction].add(one.seen);
  if (!one.has_ray) {
    direction.black += m_camera.missing_rays_are_black() ? 1 : 0;
    return;
  }
  direction.sum += one.seen;
  ++direction.rays;
}

Sample Sampler::mean(std::size_t number) const {
  const Direction& direction = m_directions[number];
  if (m_blur) return {m_estimates[number].mean(), direction.rays > 0};
  if (direction.rays == 0) return {kNothing, false};
  if (m_rays_a_place == 1) return {direction.sum, true};
  return {direction.sum * (1.0f / static_cast<float>(direction.rays + direction.black)), true};
}

Sample Sampler::sample(std::size_t number) const {
  if (!m_is_mean) return seen(m_asked[number]);
  if (m_angles == 1) return mean(number);
  Sample sum{{}, false};
  for (std::size_t i = 0; i < m_angles; ++i) {
    const Sample one = mean(number * m_angles + i);
    sum.has_ray = sum.has_ray || one.has_ray;
    sum.seen += one.seen;
  }
  sum.seen = sum.seen * (1.0f / static_cast<float>(m_angles));
  return sum;
}

}  // namespace lentray::core
