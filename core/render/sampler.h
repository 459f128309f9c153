// Samples of a picture: each is the mean light of the rays that belong to a place of a pixel's area, over
// the directions within a pixel of a lens sheet, and over the camera's aperture for each of them.
// World space, colours linear in the scene's working space. One a thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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

/// A sample that is wanted.
struct SamplePlace {
  PixelPlace place;
  std::uint32_t index = 0;  ///< of the samples of its pixel, for its random numbers
};

/// Premultiplied. Black and clear if no ray at all belongs to the place.
struct Sample {
  Radiance seen;
  bool has_ray;
};

class Sampler {
 public:
  /// `hits`: finds what neighbouring rays meet; null: each ray is searched for alone. `waves`: follows rays
  /// together; null: each is followed alone.
  Sampler(const RaySource& camera, const SamplerOptions& options, Integrator& integrator,
          FirstHits* hits, RayWaves* waves);

  /// How the samples of a list lie.
  enum class Layout {
    kNeighbours,  ///< most have the next one beside them: worth a common search
    kScattered,
  };
  /// Samples 0 to `count` - 1, in this order: `place_of(i)` -> SamplePlace is asked for some 64 of them ahead,
  /// perhaps more than once, then `keep(i, sample)` -> bool is called for each. False as soon as keep() said so.
  template <class PlaceOf, class Keep>
  bool samples(std::size_t count, Layout layout, const PlaceOf& place_of, const Keep& keep) {
    if (m_is_mean || !(m_hits || m_waves)) {
      for (std::size_t i = 0; i < count; ++i) {
        if (!keep(i, sample(place_of(i)))) return false;
      }
      return true;
    }
    for (std::size_t first = 0; first < count;) {
      clear_block();
      const std::size_t end = std::min(count, first + kMost);
      for (std::size_t i = first; i < end; ++i) add(place_of(i));
      const std::size_t done = trace_block(layout);
      for (std::size_t i = 0; i < done; ++i) {
        if (!keep(first + i, m_block[i])) return false;
      }
      first += done;
    }
    return true;
  }

 private:
  static constexpr std::size_t kMost = FirstHits::kMost;

  Sample sample(const SamplePlace& wanted);
  /// One of the directions within a pixel.
  Sample direction(const PixelPlace& place, std::uint64_t key);
  Sample of_several_rays(const PixelPlace& place, std::uint64_t key);
  Sample blurred(const PixelPlace& place, std::uint64_t key);
  Radiance trace(const Ray& ray, const PixelPlace& place, std::uint64_t key);

  void clear_block() {
    m_count = 0;
    m_rays.clear();
    m_of.clear();
  }
  /// The next sample of the block, at most kMost.
  void add(const SamplePlace& wanted);
  /// Traces the first samples of the block: of how many.
  std::size_t trace_block(Layout layout);
  /// What is seen along so many rays of the block. Null: nothing is known of them.
  void trace_rays(std::size_t rays, const FirstHits* hits);

  const RaySource& m_camera;
  const FocalBlur* const m_blur;
  const SamplerOptions m_options;
  const bool m_is_mean;  ///< whether a sample is more than one ray
  Integrator& m_integrator;
  FirstHits* const m_hits;  ///< null: each ray is searched for alone
  RayWaves* const m_waves;  ///< null: each ray is followed alone
  std::array<Sample, kMost> m_block;
  std::size_t m_count = 0;  ///< of the block
  // Of those samples of the block that have one.
  std::vector<Ray> m_rays;
  std::vector<SampleOfPixel> m_of;
  std::array<Radiance, kMost> m_seen;
};

}  // namespace lentray::core
