// What a surface itself sends along a ray: the layers of its texture, each with its pigment, normal and
// finish under the lights. Rays that go on from the surface (mirrors, transparency) are the integrator's:
// the shading leaves it what they are to be weighed by. World space; colours linear. One a thread.
// Source: reference manual 3.7, "Finish", "Layered Textures"; the order of the steps and the weights
// measured on stock (tests/image/shading_depth_test.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/material/texture.h"
#include "core/photon/photon_tree.h"
#include "core/trace/indirect_light.h"
#include "core/trace/light_loop.h"
#include "core/trace/path_features.h"
#include "core/trace/path_rules.h"
#include "core/trace/plain_texture.h"
#include "core/trace/ray_state.h"
#include "core/trace/subsurface_light.h"

namespace lentray::core {

/// A layer's mirror, whose image is traced after all layers.
struct Mirror {
  Vec3 normal;          ///< of the layer, facing the ray
  Rgb colour;           ///< black: none
  float weight = 0.0f;  ///< of the image's ray
  double exponent = 1.0;
  const Finish* finish = nullptr;
};

/// The sum over the layers of a texture, and what passes them all.
struct LayerSum {
  Rgb light;
  Rgb filter{1.0f, 1.0f, 1.0f};  ///< on what is seen behind
  double transparency = 1.0;     ///< 0..1: the filter's grey
  Vec3 top_normal;
  const Finish* top_finish = nullptr;
  std::size_t layers = 0;  ///< shaded so far
  /// Whether ShadingBuffers::indirect is known, which all layers share.
  std::array<bool, 2> is_indirect_known{};
  bool has_photons = false;      ///< they are gathered; all layers share them
  bool is_scattered = false;     ///< indirect light is part of the subsurface light
  bool is_seen_through = false;  ///< ShadingBuffers::unscattered has rays
};

/// Buffers of the surface that is shaded, used again from ray to ray.
struct ShadingBuffers {
  explicit ShadingBuffers(std::size_t light_count) : lights(light_count) {}
  WeightedTextures textures;
  std::vector<Mirror> mirrors;  ///< one a layer, if the path has mirrors
  LightsAtPoint lights;
  std::array<IndirectAnswer, 2> indirect;  ///< of the front and the back
  FoundPhotons photons, more_photons;
  std::vector<UnscatteredRay> unscattered;
};

class PhotonMap;

class SurfaceShading {
 public:
  SurfaceShading(ThreadContext& context, ShadowTester& shadows, const PathRules& rules);

  std::size_t lights() const { return m_lights.lights(); }
  /// To be called before anything else of a surface. `block`: has asked for its lights, at `place`; null: nobody has.
  void begin(const Surface& at, const BlockLights* block, std::size_t place,
             ShadingBuffers& buffers) const {
    if (m_paths.layers) {
      buffers.textures.clear();
      buffers.lights.forget_arriving();
    }
    buffers.lights.block = block;
    buffers.lights.place = place;
    if (block) return;
    m_lights.look_ahead(m_lights.lights_of(at.attributes), at.normal, at.hit(), at.from_behind,
                        at.point(), buffers.lights);
  }
  /// From the top layer down, until next to nothing passes.
  void shade(const LayeredTexture& texture, Surface& at, ShadingBuffers& buffers, LayerSum& sum);
  /// The light of the next of the plain layers of a place, of which the lights make `lit`, and what passes it.
  static void add_plain(const PlainLayer& layer, const Rgb& lit, LayerSum& sum) {
    Rgb own = layer.own;
    own += lit;
    sum.light += own * sum.filter;
    sum.filter *= layer.passed;
    sum.transparency = std::min(1.0, static_cast<double>(std::fabs(grey(sum.filter))));
  }
  /// The mirrors of all plain layers of a place. Takes from what passes them what a layer's mirror keeps.
  void find_mirrors(std::span<const PlainLayer> layers, const Surface& at, ShadingBuffers& buffers,
                    LayerSum& sum) const;
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
  struct Facing;
  struct Receiver;
  void shade_layer(const TextureLayer& layer, Surface& at, LayerSum& sum, ShadingBuffers& buffers);
  /// `transparency`: of the layers above.
  Mirror mirror_with(const Reflectivity& share, const Finish& finish, const Vec3& normal,
                     const Surface& at, double transparency) const;
  Mirror mirror_of(const Finish& finish, const Rgb& pigment, const Vec3& normal, const Surface& at,
                   double transparency) const;
  /// The light of other surfaces.
  Rgb indirectly_lit(const Finish& finish, const Rgb& pigment, const Vec3& normal, double opacity,
                     const Surface& at, ShadingBuffers& buffers, LayerSum& sum);
  /// In place of the diffuse light of lights.
  Rgb scattered(const SubsurfaceFinish& finish, const Rgb& pigment, const Surface& at,
                LayerSum& sum, ShadingBuffers& buffers);
  Rgb lit(const Finish& finish, const Rgb& pigment, const Vec3& normal, double opacity,
          const Surface& at, LightsAtPoint& known);

  /// Of the photons that came to rest nearby.
  Rgb lit_by_photons(const Finish& finish, const Rgb& pigment, const Vec3& normal, double opacity,
                     const Surface& at, LayerSum& sum, ShadingBuffers& buffers);
  bool collects_photons(const Surface& at) const;

  ThreadContext& m_context;
  const PhotonMap* const m_photons;  ///< null: there are none
  const SceneSettings& m_settings;
  const PathRules m_rules;
  const PathFeatures m_paths;
  LightLoop m_lights;
  std::unique_ptr<SubsurfaceLight> m_subsurface;  ///< null: there is none
};

}  // namespace lentray::core
