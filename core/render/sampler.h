// Samples of a picture: each is the mean light of the rays that belong to a place of a pixel's area, over
// the directions within a pixel of a lens sheet, and over the camera's aperture for each of them.
// World space, colours linear in the scene's working space. One a thread.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/render/focal_blur.h"
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
  /// together; null: each is followed alone. `cancel`: ends samples() soon; it outlives the sampler.
  Sampler(const RaySource& camera, const SamplerOptions& options, Integrator& integrator,
          FirstHits* hits, RayWaves* waves, const std::atomic<bool>& cancel);

  /// How the samples of a list lie.
  enum class Layout {
    kNeighbours,  ///< most have the next one beside them: worth a common search
    kScattered,
  };
  /// Samples 0 to `count` - 1, in this order: `place_of(i)` -> SamplePlace is asked for some of them ahead, then
  /// `keep(i, sample)` -> bool is called for each. False as soon as keep() said so, or when it
  /// was cancelled.
  template <class PlaceOf, class Keep>
  bool samples(std::size_t count, Layout layout, const PlaceOf& place_of, const Keep& keep) {
    for (std::size_t first = 0; first < count; first += m_block) {
      const std::size_t end = std::min(count, first + m_block);
      begin_block();
      for (std::size_t i = first; i < end; ++i) add(place_of(i));
      if (!trace_block(layout)) return false;
      for (std::size_t i = first; i < end; ++i) {
        if (!keep(i, sample(i - first))) return false;
      }
    }
    return true;
  }

 private:
  static constexpr std::size_t kTogether = FirstHits::kMost;  ///< rays

  /// One of the directions of a sample: the mean of its rays.
  struct Direction {
    PixelPlace place;
    std::uint64_t key;
    EyePlace seen_at;  ///< of its pixel
    Radiance sum{};
    int rays = 0;
    int black = 0;  ///< rays that are none, but count
  };
  /// A ray of a direction, and its place among the block's; or that there is none.
  struct Asked {
    static constexpr std::uint32_t kNone = ~0u;
    std::uint32_t direction;
    std::uint32_t ray;
  };

  void begin_block() {
    m_directions.clear();
    m_estimates.clear();
    begin_rays();
  }
  void begin_rays() {
    m_asked.clear();
    m_rays.clear();
    m_of.clear();
  }
  /// The next sample of the block.
  void add(const SamplePlace& wanted);
  void add_direction(const PixelPlace& place, std::uint64_t key);
  /// False: cancelled, as trace_rays().
  bool trace_block(Layout layout);
  /// How many more rays the directions of m_open want that have had `before`; takes those away that have enough.
  std::uint32_t more_rays(std::uint32_t before);
  /// Asks for ray `number` of a direction.
  void ask(std::uint32_t direction, std::uint32_t number);
  void add_asked(std::uint32_t direction, bool has_ray, const Ray& ray, const SampleOfPixel& of);
  bool find_ray(std::uint32_t direction, std::uint32_t number, SampleOfPixel& of, Ray& ray) const;
  /// All that were asked for.
  bool trace_rays(Layout layout);
  void trace(std::span<const Ray> rays, std::span<const SampleOfPixel> of, const FirstHits* hits,
             std::span<Radiance> seen);
  void take(const Asked& asked);
  /// Of the block, once it is traced.
  Sample sample(std::size_t number) const;
  Sample mean(std::size_t direction) const;
  Sample seen(const Asked& asked) const;

  const RaySource& m_camera;
  const FocalBlur* const m_blur;
  const SamplerOptions m_options;
  const std::size_t m_angles;  ///< directions a sample
  const std::uint32_t m_rays_a_place;
  const bool m_is_mean;  ///< whether a sample is more than one ray
  Integrator& m_integrator;
  FirstHits* const m_hits;  ///< null: each ray is searched for alone
  RayWaves* const m_waves;  ///< null: each ray is followed alone
  const std::atomic<bool>& m_cancel;
  const std::size_t m_block;  ///< samples in a block
  std::vector<Direction> m_directions;
  std::vector<BlurEstimate> m_estimates;  ///< one a direction, if rays start at an aperture
  std::vector<std::uint32_t> m_open;      ///< directions that have not all of their rays
  std::vector<Asked> m_asked;
  // Of those that have a ray.
  std::vector<Ray> m_rays;
  std::vector<SampleOfPixel> m_of;
  std::vector<Radiance> m_seen;
};

}  // namespace lentray::core
