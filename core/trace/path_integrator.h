// The integrator behind Integrator::make: finds what a ray meets, has the surface shaded, follows the rays
// that go on from there, and passes all of it through the air between. World space.
// One a thread; no allocation per ray once its buffers have grown.
// Source: where adc_bailout and max_trace_level cut is stock's (tests/image/shading_depth_test.cpp).
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/base/deep_threads.h"
#include "core/trace/integrator.h"
#include "core/trace/media_light.h"
#include "core/trace/path_features.h"
#include "core/trace/ray_state.h"
#include "core/trace/start_interiors.h"
#include "core/trace/surface_shading.h"
#include "core/trace/thread_context.h"

namespace lentray::core {

class Hierarchy;

template <unsigned kFeatures>
class PathIntegrator final : public Integrator {
 public:
  PathIntegrator(ThreadContext& context, ShadowTester& shadows, const PathRules& rules);

  using Integrator::trace;
  Radiance trace(const Ray& ray, Pixel pixel, std::uint64_t key) override;
  GatheredRay gather(const GatherRay& ray) override;
  Radiance along(const RayState& state, float weight, int level) override {
    return follow(state, weight, level);
  }

 private:
  static constexpr bool kTransparency = (kFeatures & kPathTransparency) != 0;
  static constexpr bool kReflection = (kFeatures & kPathReflection) != 0;
  static constexpr bool kLayers = (kFeatures & kPathLayers) != 0;

  /// `level` counts the levels above this ray; one that goes straight on takes none itself.
  Radiance follow(const RayState& state, float weight, int level, bool straight_on = false);
  /// What the ray brings from what it has met; `hit`: null: the sky.
  Radiance seen_at(const RayState& state, const Hit* hit, float weight, int level,
                   bool straight_on);
  Radiance shade(const RayState& state, const Hit& hit, float weight, int level);
  Radiance shade_textures(Surface& at, ShadingBuffers& buffers);
  Radiance shade_texture(const LayeredTexture& texture, Surface& at, ShadingBuffers& buffers);
  void add_mirror_images(const LayerSum& sum, bool total_reflection, const Surface& at,
                         ShadingBuffers& buffers, Radiance& result);
  /// `film`: the finish whose thin film tints the image.
  Rgb mirror_image(const Vec3& normal, float weight, const Surface& at, const Finish& film);
  /// Adds what is seen through the surface; true on total internal reflection.
  bool add_transmitted(const LayerSum& sum, const Surface& at, Radiance& result);
  /// The ray that goes on behind the surface.
  struct Onward {
    Ray ray;
    RayState state;
    float weight;
    Onward(const Surface& at, float share)
        : ray{at.point(), at.ray().direction},
          state(ray, at.state.inside, 2 * at.state.place + 1, transmitted(at.state.kind)),
          weight(share) {
      state.wavelength = at.state.wavelength;
    }
    Onward(const Onward&) = delete;
  };
  /// Follows it with that ior before the surface over behind it. True on total internal reflection:
  /// then `seen` is the mirror image.
  bool refract(const LayerSum& sum, const Surface& at, double ior, Onward& onward, Radiance& seen);
  /// The same for bands of light, each with its ior; the mean.
  Rgb disperse(const LayerSum& sum, const Surface& at, const Bend& bend, Onward& onward);
  /// Fog, rainbows and media of the air on a piece of the ray, if it is in the open. `looks`: of the
  /// surface at its end; null: the sky.
  void pass_open_air(const RayState& state, double length, int level, const Attributes* looks,
                     Radiance& light);
  ShadingBuffers& enter_surface();

  ThreadContext& m_context;
  const Scene& m_scene;
  const Hierarchy& m_hierarchy;
  SurfaceShading<kFeatures> m_shading;
  int m_max_level;
  const double m_bailout;
  const double m_min_distance;  ///< kMinHitDistance in this scene
  const double m_atmosphere_ior;
  const bool m_mirror_images;
  const Atmosphere* m_air;                                 ///< null: clear
  std::unique_ptr<MediaLight> m_media;                     ///< null: the scene has no media
  std::unique_ptr<StartInteriors> m_start_interiors;       ///< null: the scene has no interiors
  std::vector<std::unique_ptr<ShadingBuffers>> m_buffers;  ///< one a surface on the way
  std::size_t m_depth = 0;                                 ///< surfaces on the way
  std::size_t m_deepest = std::numeric_limits<std::size_t>::max();  ///< known when the stack ends
  const std::uintptr_t m_stack_end = own_stack().middle();
};

/// The path of exactly these features (a superset of what the scene needs); for Integrator::make and
/// for the test that paths agree.
std::unique_ptr<Integrator> make_path_integrator(unsigned features, ThreadContext& context,
                                                 ShadowTester& shadows, const PathRules& rules);

}  // namespace lentray::core
