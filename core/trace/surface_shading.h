// What a layer of a surface sends along a ray of the light that comes from elsewhere: from lights, other surfaces,
// photons, and out of the solid below. World space; colours linear. One a thread.
// Source: reference manual 3.7, "Finish"; the order of the steps and the weights measured on stock
// (tests/image/shading_depth_test.cpp).
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/photon/photon_tree.h"
#include "core/trace/indirect_light.h"
#include "core/trace/layer.h"
#include "core/trace/light_loop.h"
#include "core/trace/path_rules.h"
#include "core/trace/ray_state.h"
#include "core/trace/subsurface_light.h"

namespace lentray::core {

/// Buffers of the surface that is shaded, used again from ray to ray.
struct ShadingBuffers {
  explicit ShadingBuffers(std::size_t light_count) : lights(light_count) {}
  /// Before each texture of the surface: its layers share the rest.
  void begin_texture() {
    is_indirect_known = {};
    has_photons = is_scattered = false;
  }
  LayerBuffer layers;
  LightsAtPoint lights;
  std::vector<Rgb> lit;                    ///< by lights: of each layer of the surface
  std::array<IndirectAnswer, 2> indirect;  ///< of the front and the back
  std::array<bool, 2> is_indirect_known{};
  FoundPhotons photons, more_photons;
  bool has_photons = false;                 ///< they are gathered
  bool is_scattered = false;                ///< indirect light is part of the subsurface light
  std::vector<UnscatteredRay> unscattered;  ///< of the texture
};

class PhotonMap;

class SurfaceShading {
 public:
  SurfaceShading(ThreadContext& context, ShadowTester& shadows, const PathRules& rules);

  std::size_t lights() const { return m_lights.lights(); }
  /// To be called before anything else of a surface. `block`: has asked for its lights, at `place`; null: nobody has.
  void begin(const Surface& at, const BlockLights* block, std::size_t place,
             ShadingBuffers& buffers) const {
    if (block) return buffers.lights.begin_in_block(*block, place);
    buffers.lights.block = nullptr;
    m_lights.look_ahead(m_lights.lights_of(at.attributes), at.normal, at.hit(), at.from_behind,
                        at.point(), buffers.lights);
  }
  /// Finds what the lights make of all layers of a surface, for light().
  void find_lit(Layers layers, const Surface& at, ShadingBuffers& buffers);
  /// Adds to a layer's own light what comes from elsewhere, in a certain order. `above`: what the layers above let
  /// through.
  void light(const Layer& layer, const Rgb& above, const Surface& at, ShadingBuffers& buffers,
             Rgb& own);
  /// What filters leave of a light at a surface, as LightLoop::filters().
  Rgb filters(const RayState& state, const Vec3& point, int level, std::uint32_t light,
              const BlockLights& block, std::size_t place) const {
    return m_lights.filters(
        {point, level, state.tree_place, state.inside, state.key, false, false, m_rules.volumes},
        light, block, place);
  }
  /// How the thin film of a finish tints light that leaves along `from_light`.
  Rgb film(const Finish& finish, const Vec3& normal, const Vec3& from_light,
           const Surface& at) const;

 private:
  template <bool kOne>
  struct LitLayers;
  template <bool kOne>
  void find_lit(Layers layers, const Surface& at, ShadingBuffers& buffers);
  /// The light of other surfaces.
  Rgb indirectly_lit(const Layer& layer, const Rgb& above, const Surface& at,
                     ShadingBuffers& buffers);
  /// In place of the diffuse light of lights.
  Rgb scattered(const Layer& layer, const Rgb& above, const Surface& at, ShadingBuffers& buffers);
  /// Of the photons that came to rest nearby.
  Rgb lit_by_photons(const Layer& layer, const Surface& at, ShadingBuffers& buffers);
  bool collects_photons(const Surface& at) const;

  ThreadContext& m_context;
  const PhotonMap* const m_photons;  ///< null: there are none
  const SceneSettings& m_settings;
  const PathRules m_rules;
  LightLoop m_lights;
  std::unique_ptr<SubsurfaceLight> m_subsurface;  ///< null: there is none
};

}  // namespace lentray::core
