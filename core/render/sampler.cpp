#include "core/render/sampler.h"

#include <span>

#include "core/render/focal_blur.h"
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

}  // namespace

Sampler::Sampler(const RaySource& camera, const SamplerOptions& options, Integrator& integrator,
                 FirstHits* hits, RayWaves* waves)
    : m_camera(camera), m_blur(camera.blur()), m_options(options),
      m_is_mean(options.angles > 1 || m_blur || camera.rays_a_place() > 1),
      m_integrator(integrator), m_hits(hits && hits->works() ? hits : nullptr),
      m_waves(waves && waves->works() ? waves : nullptr) {}

void Sampler::add(const SamplePlace& wanted) {
  Ray ray;
  const bool has_ray = m_camera.ray_at(wanted.place, ray);
  m_block[m_count++] = {kNothing, has_ray};
  if (!has_ray) return;
  m_rays.push_back(ray);
  m_of.push_back({nearest_pixel(wanted.place), key_of(wanted)});
}

std::size_t Sampler::trace_block(Layout layout) {
  if (m_rays.empty()) return m_count;
  const FirstHits* hits = nullptr;
  std::size_t rays = m_rays.size();
  if (m_hits && layout == Layout::kNeighbours) {
    rays = m_hits->find(m_rays);
    hits = m_hits;
  }
  trace_rays(rays, hits);
  std::size_t ray = 0;
  for (std::size_t i = 0; i < m_count; ++i) {
    Sample& sample = m_block[i];
    if (!sample.has_ray) continue;
    if (ray == rays) return i;
    sample.seen = m_seen[ray++];
    if (!m_options.alpha) sample.seen.transmit = 0.0f;
  }
  return m_count;
}

void Sampler::trace_rays(std::size_t rays, const FirstHits* hits) {
  if (m_waves) {
    m_waves->trace(std::span(m_rays).first(rays), std::span(m_of).first(rays), hits, m_seen);
    return;
  }
  for (std::size_t i = 0; i < rays; ++i) {
    const SampleOfPixel& of = m_of[i];
    m_seen[i] = hits && hits->is_known(i)
                    ? m_integrator.trace_met(m_rays[i], of.pixel, of.key, hits->hit(i))
                    : m_integrator.trace(m_rays[i], of.pixel, of.key);
  }
}

Sample Sampler::sample(const SamplePlace& wanted) {
  const std::uint64_t key = key_of(wanted);
  if (m_options.angles <= 1) return direction(wanted.place, key);
  Sample sum{{}, false};
  for (int i = 0; i < m_options.angles; ++i) {
    PixelPlace turned = wanted.place;
    turned.turn = (i + 0.5) / m_options.angles - 0.5;
    const Sample one = direction(turned, part_key(key, static_cast<std::uint32_t>(i)));
    sum.has_ray = sum.has_ray || one.has_ray;
    sum.seen += one.seen;
  }
  sum.seen = sum.seen * (1.0f / static_cast<float>(m_options.angles));
  return sum;
}

Sample Sampler::direction(const PixelPlace& place, std::uint64_t key) {
  if (m_blur) return blurred(place, key);
  if (m_camera.rays_a_place() > 1) return of_several_rays(place, key);
  Ray ray;
  if (!m_camera.ray_at(place, ray)) return {kNothing, false};
  return {trace(ray, place, key), true};
}

Sample Sampler::of_several_rays(const PixelPlace& place, std::uint64_t key) {
  const Pixel pixel = nearest_pixel(place);
  const EyePlace at = m_camera.eye_place(pixel.column, pixel.row);
  Radiance sum;
  int count = 0, black = 0;
  for (std::uint32_t i = 0; i < m_camera.rays_a_place(); ++i) {
    Ray ray;
    if (!m_camera.one_ray_at(place, m_camera.ray_of(at, i), ray)) {
      if (m_camera.missing_rays_are_black()) ++black;
      continue;
    }
    sum += trace(ray, place, part_key(key, i));
    ++count;
  }
  if (count == 0) return {kNothing, false};
  return {sum * (1.0f / static_cast<float>(count + black)), true};
}

Sample Sampler::blurred(const PixelPlace& place, std::uint64_t key) {
  BlurEstimate estimate(*m_blur, key);
  bool any = false;
  while (estimate.wants_more()) {
    // Numbers that are no direction's part of the sample, but for 0.
    const auto part = estimate.rays() * static_cast<std::uint32_t>(std::max(1, m_options.angles));
    const std::uint64_t ray_key = part_key(key, part);
    const BlurRay way = estimate.next(ray_key);
    PixelPlace through = place;
    through.across += way.across;
    through.down += way.down;
    Ray ray;
    Radiance one = kNothing;
    if (m_camera.lens_ray_at(through, way.x, way.y, ray)) {
      one = trace(ray, place, ray_key);
      any = true;
    }
    estimate.add(one);
  }
  return {estimate.mean(), any};
}

Radiance Sampler::trace(const Ray& ray, const PixelPlace& place, std::uint64_t key) {
  Radiance seen = m_integrator.trace(ray, nearest_pixel(place), key);
  if (!m_options.alpha) seen.transmit = 0.0f;
  return seen;
}

}  // namespace lentray::core
