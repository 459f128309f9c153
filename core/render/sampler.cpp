#include "core/render/sampler.h"

#include <algorithm>

#include "core/render/focal_blur.h"
#include "core/trace/random_key.h"

namespace lentray::core {

std::size_t Sampler::find_hits(std::span<const Pixel> pixels) {
  m_rays.clear();
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    Ray ray;
    m_has_ray[i] = m_camera.ray(pixels[i].column + 0.5, pixels[i].row + 0.5, ray);
    if (m_has_ray[i]) m_rays.push_back(ray);
  }
  if (m_rays.empty()) return pixels.size();
  std::size_t rays = m_hits->find(m_rays);
  if (rays == m_rays.size()) return pixels.size();
  std::size_t i = 0;
  for (; rays > 0; ++i) rays -= m_has_ray[i] ? 1 : 0;
  return i;
}

void Sampler::trace_waves(std::span<const Pixel> block) {
  m_ray_pixels.clear();
  for (std::size_t i = 0; i < block.size(); ++i) {
    if (m_has_ray[i]) m_ray_pixels.push_back(block[i]);
  }
  if (m_ray_pixels.empty()) return;
  m_waves->trace(std::span(m_rays).first(m_ray_pixels.size()), m_ray_pixels, *m_hits, m_seen);
}

bool Sampler::sample(const PixelPlace& place, std::uint32_t index, Radiance& out) {
  const std::uint64_t key = sample_key(place.column, place.row, index);
  if (m_options.angles <= 1) return direction(place, key, out);
  Radiance sum;
  bool any = false;
  for (int i = 0; i < m_options.angles; ++i) {
    PixelPlace turned = place;
    turned.turn = (i + 0.5) / m_options.angles - 0.5;
    Radiance one;
    if (direction(turned, part_key(key, static_cast<std::uint32_t>(i)), one)) any = true;
    sum += one;
  }
  const float share = 1.0f / static_cast<float>(m_options.angles);
  out = sum * share;
  return any;
}

bool Sampler::direction(const PixelPlace& place, std::uint64_t key, Radiance& out) {
  if (m_blur) return blurred(place, key, out);
  if (m_camera.rays_a_place() > 1) return of_several_rays(place, key, out);
  Ray ray;
  out = {Rgb(), 1.0f};
  if (!m_camera.ray_at(place, ray)) return false;
  trace(ray, place, key, out);
  return true;
}

bool Sampler::of_several_rays(const PixelPlace& place, std::uint64_t key, Radiance& out) {
  Radiance sum;
  int count = 0, black = 0;
  for (std::uint32_t i = 0; i < m_camera.rays_a_place(); ++i) {
    Ray ray;
    if (!m_camera.one_ray_at(place, i, ray)) {
      if (m_camera.missing_rays_are_black()) ++black;
      continue;
    }
    Radiance one;
    trace(ray, place, part_key(key, i), one);
    sum += one;
    ++count;
  }
  out = {Rgb(), 1.0f};
  if (count == 0) return false;
  const float share = 1.0f / static_cast<float>(count + black);
  out = sum * share;
  return true;
}

bool Sampler::blurred(const PixelPlace& place, std::uint64_t key, Radiance& out) {
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
    Radiance one{Rgb(), 1.0f};
    if (m_camera.lens_ray_at(through, way.x, way.y, ray)) {
      trace(ray, place, ray_key, one);
      any = true;
    }
    estimate.add(one);
  }
  out = estimate.mean();
  return any;
}

void Sampler::trace(const Ray& ray, const PixelPlace& place, std::uint64_t key, Radiance& out) {
  // Caches of shadows know the picture's pixels only.
  const Pixel pixel{static_cast<std::uint32_t>(std::max(place.column, 0)),
                    static_cast<std::uint32_t>(std::max(place.row, 0))};
  out = m_integrator.trace(ray, pixel, key);
  if (!m_options.alpha) out.transmit = 0.0f;
}

}  // namespace lentray::core
