#include "core/render/sampler.h"

#include <algorithm>

#include "core/render/random_key.h"

namespace lentray::core {

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
    sum.rgb += one.rgb;
    sum.transmit += one.transmit;
  }
  const float share = 1.0f / static_cast<float>(m_options.angles);
  out = {sum.rgb * share, sum.transmit * share};
  return any;
}

bool Sampler::direction(const PixelPlace& place, std::uint64_t key, Radiance& out) {
  return single(place, key, out);
}

bool Sampler::single(const PixelPlace& place, std::uint64_t key, Radiance& out) {
  Ray ray;
  if (!m_camera.ray_at(place, ray)) {
    out = {Rgb(), 1.0f};
    return false;
  }
  // Caches of shadows know the picture's pixels only.
  const Pixel pixel{static_cast<std::uint32_t>(std::max(place.column, 0)),
                    static_cast<std::uint32_t>(std::max(place.row, 0))};
  out = m_tracer.trace(ray, pixel, key);
  if (m_options.alpha) {
    out.rgb -= m_background * out.transmit;
  } else {
    out.transmit = 0.0f;
  }
  return true;
}

}  // namespace lentray::core
