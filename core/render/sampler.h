// One sample of a picture: the mean light of the rays that belong to a place of a pixel's area.
// World space, colours linear in the scene's working space. One a thread.
#pragma once

#include <cstdint>

#include "core/render/ray_source.h"
#include "core/render/tracer.h"

namespace lentray::core {

struct SamplerOptions {
  int angles = 1;           ///< Antialias_Angle: directions within a pixel of a lens sheet
  bool alpha = false;       ///< +UA: the background is taken out; without, it is opaque
};

class Sampler {
 public:
  Sampler(const Scene& scene, const RaySource& camera, const SamplerOptions& options,
          Tracer& tracer)
      : m_background(scene.settings().background.rgb), m_camera(camera), m_options(options),
        m_tracer(tracer) {}

  /// Sample 0 of a pixel of the image at its centre.
  bool centre(const Pixel& pixel, Radiance& out) {
    if (is_mean()) {
      return sample({.column = static_cast<std::int32_t>(pixel.column),
                     .row = static_cast<std::int32_t>(pixel.row)}, 0, out);
    }
    Ray ray;
    if (!m_camera.ray(pixel.column + 0.5, pixel.row + 0.5, ray)) return false;
    out = m_tracer.trace(ray, pixel);
    if (m_options.alpha) out.rgb -= m_background * out.transmit;
    return true;
  }
  /// `index`: of the samples of a pixel, for its random numbers. Without a ray black and, as in
  /// stock, clear; false if no ray at all belongs to the place. Premultiplied.
  bool sample(const PixelPlace& place, std::uint32_t index, Radiance& out);

 private:
  /// Whether a sample is more than one ray.
  bool is_mean() const { return m_options.angles > 1; }
  bool direction(const PixelPlace& place, std::uint64_t key, Radiance& out);
  bool single(const PixelPlace& place, std::uint64_t key, Radiance& out);

  const Rgb m_background;
  const RaySource& m_camera;
  const SamplerOptions m_options;
  Tracer& m_tracer;
};

}  // namespace lentray::core
