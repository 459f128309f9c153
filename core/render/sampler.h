// One sample of a picture: the mean light of the rays that belong to a place of a pixel's area, over
// the directions within a pixel of a lens sheet, and over the camera's aperture for each of them.
// World space, colours linear in the scene's working space. One a thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/render/ray_source.h"
#include "core/trace/first_hits.h"
#include "core/trace/integrator.h"
#include "core/trace/ray_waves.h"

namespace lentray::core {

struct SamplerOptions {
  int angles = 1;      ///< Antialias_Angle: directions within a pixel of a lens sheet
  bool alpha = false;  ///< +UA; without, every sample is opaque
};

class Sampler {
 public:
  /// `hits`: finds what neighbouring rays meet; null: each ray is searched for alone. `waves`: follows such rays
  /// together; null: each is followed alone.
  Sampler(const RaySource& camera, const SamplerOptions& options, Integrator& integrator,
          FirstHits* hits, RayWaves* waves)
      : m_camera(camera), m_blur(camera.blur()), m_options(options),
        m_is_mean(options.angles > 1 || m_blur || camera.rays_a_place() > 1),
        m_integrator(integrator), m_hits(hits && hits->works() && !m_is_mean ? hits : nullptr),
        m_waves(waves && waves->works() ? waves : nullptr) {}

  /// Sample 0 of each of those pixels of the image, at their centres: `keep(pixel, radiance)`.
  /// Pixels without a ray are black and counted. False if `stop()` said so before one of them.
  template <class Keep, class Stop>
  bool centres(const std::vector<Pixel>& pixels, Counters& counters, const Keep& keep,
               const Stop& stop) {
    if (m_hits) return centres_together(pixels, counters, keep, stop);
    for (const Pixel& pixel : pixels) {
      if (stop()) return false;
      Radiance seen;
      if (!(m_is_mean ? mean(pixel, seen) : one_ray(pixel, seen))) {
        ++counters.dark_pixels;
        seen = {};  // not clear
      }
      keep(pixel, seen);
    }
    return true;
  }

  /// `index`: of the samples of a pixel, for its random numbers. Without a ray black and
  /// clear; false if no ray at all belongs to the place. Premultiplied.
  bool sample(const PixelPlace& place, std::uint32_t index, Radiance& out);

 private:
  /// Block after block of pixels: what their rays meet first, then each of them.
  template <class Keep, class Stop>
  bool centres_together(std::span<const Pixel> pixels, Counters& counters, const Keep& keep,
                        const Stop& stop) {
    while (!pixels.empty()) {
      const auto block =
          pixels.first(find_hits(pixels.first(std::min(pixels.size(), FirstHits::kMost))));
      if (m_waves) trace_waves(block);
      std::size_t ray = 0;
      for (std::size_t i = 0; i < block.size(); ++i) {
        if (stop()) return false;
        Radiance seen;
        if (m_has_ray[i]) {
          seen = m_waves ? m_seen[ray] : of_block(block[i], ray);
          ++ray;
        } else {
          ++counters.dark_pixels;
        }
        keep(block[i], seen);
      }
      pixels = pixels.subspan(block.size());
    }
    return true;
  }
  /// The rays of these pixels, and what those of the first of them meet: of how many.
  std::size_t find_hits(std::span<const Pixel> pixels);
  /// Fills m_seen for the rays of these.
  void trace_waves(std::span<const Pixel> block);
  Radiance of_block(const Pixel& pixel, std::size_t i) {
    const Ray& ray = m_rays[i];
    if (!m_hits->is_known(i)) return m_integrator.trace(ray, pixel);
    return m_integrator.trace_met(ray, pixel, m_hits->hit(i));
  }
  /// Of a pixel's centre; false if there is no ray.
  bool one_ray(const Pixel& pixel, Radiance& out) {
    Ray ray;
    if (!m_camera.ray(pixel.column + 0.5, pixel.row + 0.5, ray)) return false;
    out = m_integrator.trace(ray, pixel);
    return true;
  }
  bool mean(const Pixel& pixel, Radiance& out) {
    return sample({.column = static_cast<std::int32_t>(pixel.column),
                   .row = static_cast<std::int32_t>(pixel.row)},
                  0, out);
  }
  /// One of the directions within a pixel.
  bool direction(const PixelPlace& place, std::uint64_t key, Radiance& out);
  bool of_several_rays(const PixelPlace& place, std::uint64_t key, Radiance& out);
  bool blurred(const PixelPlace& place, std::uint64_t key, Radiance& out);
  void trace(const Ray& ray, const PixelPlace& place, std::uint64_t key, Radiance& out);

  const RaySource& m_camera;
  const FocalBlur* const m_blur;
  const SamplerOptions m_options;
  const bool m_is_mean;  ///< whether a sample is more than one ray
  Integrator& m_integrator;
  FirstHits* const m_hits;                         ///< null: each ray is searched for alone
  RayWaves* const m_waves;                         ///< null: each ray is followed alone
  std::vector<Ray> m_rays;                         ///< of a block of pixels
  std::vector<Pixel> m_ray_pixels;                 ///< of these rays, in waves
  std::array<Radiance, FirstHits::kMost> m_seen;   ///< of these rays, in waves
  std::array<bool, FirstHits::kMost> m_has_ray{};  ///< of its pixels
};

}  // namespace lentray::core
