// One step of a ray: finds what it meets, has the surface shaded, and says which rays go on from
// there; then, once their light is known, passes it all through the air between. It follows no ray
// itself: that is the integrator's. World space. One a thread; no allocation per ray once its
// buffers have grown.
// Source: where adc_bailout and max_trace_level cut is stock's
// (tests/image/shading_depth_test.cpp).
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/accel/hierarchy.h"
#include "core/base/pixel.h"
#include "core/trace/media_light.h"
#include "core/trace/open_air.h"
#include "core/trace/path_features.h"
#include "core/trace/path_rules.h"
#include "core/trace/ray_record.h"
#include "core/trace/ray_state.h"
#include "core/trace/sky.h"
#include "core/trace/start_interiors.h"
#include "core/trace/surface_layers.h"
#include "core/trace/surface_shading.h"
#include "core/trace/thread_context.h"
#include "core/trace/unit_ray.h"

namespace lentray::core {

class RayStepper {
 public:
  RayStepper(ThreadContext& context, ShadowTester& shadows, const PathRules& rules);

  /// A camera ray of a pixel's sample.
  RayState begin(const Ray& ray, Pixel pixel, std::uint64_t key) {
    m_context.pixel = pixel;
    ++m_context.counters.camera_rays;
    RayState state{unit_ray(ray), key};
    if (m_start_interiors) state.inside = m_start_interiors->at(ray.origin, m_context.interiors);
    return state;
  }
  /// Whether a ray counts too little, or has too many levels above it, to be followed: it sees
  /// nothing.
  bool is_cut(const RayState& state) const { return is_cut(state.level, state.weight); }
  /// The most levels that rays may have above them: the scene's, or others of who sets it.
  int most_levels() const { return m_max_level; }
  void set_most_levels(int levels) { m_max_level = levels; }
  /// What the ray meets first; false: nothing.
  bool meet(const RayState& state, Hit& hit) {
    return m_hierarchy.nearest(state.ray, m_min_distance, Bounds::kInf, state.kind, hit,
                               m_context.lists, m_context.tests);
  }
  /// Fills the record with what the ray meets.
  void step(const RayState& state, RayRecord& record) {
    Hit hit;
    see(state, meet(state, hit) ? &hit : nullptr, record);
  }
  /// The same of a ray that has met this; null: nothing.
  void see(const RayState& state, const Hit* hit, RayRecord& record) {
    if (hit) {
      see_surface(state, *hit, record);
    } else {
      see_nothing(state, record);
    }
  }
  void see_nothing(const RayState& state, RayRecord& record) {
    record.parts.clear();
    record.onward.clear();
    record.attributes = nullptr;
    record.length = kOpenAir;
    record.level = state.level + 1;
    record.own = sky_radiance(m_scene, state.ray.direction, state.kind >= RayKind::kReflection);
  }
  /// Evaluates the layers of surfaces, for the next two.
  SurfaceLayers& layers() { return m_layers; }
  /// Of a surface whose layers are known. `block`: has asked for the lights there, at `place` of its places.
  void see_layers(const RayState& state, const Hit& hit, const MetPlace& where,
                  const PlaceLayers& found, const LayerBuffer& layers, const BlockLights& block,
                  std::size_t place, RayRecord& record);
  /// The same where `lit(layer)` is all that comes from elsewhere to the place's layers.
  template <class Lit>
  void see_lit(const RayState& state, const Hit& hit, const MetPlace& where,
               const PlaceLayers& found, const LayerBuffer& buffer, const Lit& lit,
               RayRecord& record) {
    begin_surface(state, hit, record);
    std::size_t next = 0;
    each_texture(found, buffer, record, [&](Layers layers, double) {
      const Rgb own =
          sum_up(layers, [&](const Layer&, const Rgb&, Rgb& light) { light += lit(next++); });
      if (go_on_from(layers)) go_on(state, hit, where, layers, record);
      return own;
    });
  }
  /// What filters leave of a light at a place of a block.
  Rgb filters(const RayState& state, const MetPlace& where, std::uint32_t light,
              const BlockLights& block, std::size_t place) const {
    return m_shading.filters(state, where.point, level_of(state), light, block, place);
  }
  /// Changes the light that RayRecord::gather() found into what arrives at the ray's origin.
  void arrive(const RayState& state, const RayRecord& record, Radiance& light) {
    if (m_media && record.attributes) {
      m_media->pass_interiors(state, record.length, record.level, *record.attributes, light);
    }
    if (m_air) pass_open_air(state, record, light);
  }

 private:
  static int level_of(const RayState& state) { return state.level + (state.straight_on ? 0 : 1); }
  static void begin_surface(const RayState& state, const Hit& hit, RayRecord& record) {
    record.parts.clear();
    record.onward.clear();
    record.attributes = &hit.leaf->attributes();
    record.length = hit.t;
    record.level = level_of(state);
  }
  /// Gives each texture of a place to `see(layers, weight) -> Rgb`, which adds the rays that go on from it.
  template <class See>
  [[gnu::always_inline]] static void each_texture(const PlaceLayers& found,
                                                  const LayerBuffer& buffer, RayRecord& record,
                                                  const See& see) {
    Layers layers = found.of(buffer);
    if (found.parts == 0) {
      record.own = {see(layers, 1.0)};
      return;
    }
    record.own = {};
    for (const TexturePart& part : found.parts_of(buffer)) {
      const std::size_t before = record.onward.size();
      const Radiance own{see(layers.first(part.layers), part.weight)};
      record.parts.push_back({own, part.weight, record.onward.size() - before});
      layers = layers.subspan(part.layers);
    }
  }
  /// Of the layers of a texture. `add(layer, above, light)` adds to a layer's own light what comes from elsewhere.
  template <class Add>
  [[gnu::always_inline]] static Rgb sum_up(Layers layers, const Add& add) {
    Rgb sum, above(1.0f);
    for (const Layer& layer : layers) {
      Rgb light = layer.own;
      add(layer, above, light);
      sum += light * above;
      above = layer.below;
    }
    return sum;
  }
  bool is_cut(int level, float weight) const { return level >= m_max_level || weight < m_bailout; }

  void see_surface(const RayState& state, const Hit& hit, RayRecord& record);
  void shade(Surface& at, const PlaceLayers& found, const LayerBuffer& layers,
             ShadingBuffers& buffers, RayRecord& record);
  /// The buffers of the next surface that is shaded, until end_shading().
  ShadingBuffers& begin_shading() {
    if (m_shaded == m_buffers.size()) add_buffers();
    return *m_buffers[m_shaded++];
  }
  void end_shading() { --m_shaded; }
  void add_buffers();
  /// Whether rays go on from the layers of a texture.
  bool go_on_from(Layers layers) const {
    if (layers.empty()) return false;
    if (layers.back().clear > m_bailout) return true;
    return std::ranges::any_of(layers,
                               [](const Layer& layer) { return !layer.mirror.colour.is_black(); });
  }
  void go_on(const RayState& state, const Hit& hit, const MetPlace& where, Layers layers,
             RayRecord& record);
  void add_onward(Layers layers, const Surface& at, RayRecord& record);
  void add_mirrors(Layers layers, bool total_reflection, const Surface& at, RayRecord& record);
  void add_unscattered(const Surface& at, ShadingBuffers& buffers, RayRecord& record);
  /// Adds what goes through the surface; true on total internal reflection.
  bool add_transmitted(Layers layers, const Surface& at, RayRecord& record);
  /// Turns a ray that goes through, with that ior before the surface over behind it. True on total
  /// internal reflection: then it is that of the mirror image.
  bool refract(const Layer& top, double ior, const Surface& at, OnwardRay& onward);
  /// Makes a ray that of the mirror image in a layer.
  void reflect(const Layer& layer, const Surface& at, OnwardRay& onward);
  static OnwardRay& add_ray(const Surface& at, float weight, RayRecord& record);
  /// Fog, rainbows and media of the air on the ray, if it is in the open.
  void pass_open_air(const RayState& state, const RayRecord& record, Radiance& light);

  ThreadContext& m_context;
  const Scene& m_scene;
  const PathFeatures m_paths;
  const Hierarchy& m_hierarchy;
  SurfaceLayers m_layers;
  SurfaceShading m_shading;
  int m_max_level;
  const double m_bailout;
  const double m_min_distance;  ///< kMinHitDistance in this scene
  const double m_atmosphere_ior;
  const bool m_mirror_images;
  const Atmosphere* m_air;                                 ///< null: clear
  std::unique_ptr<MediaLight> m_media;                     ///< null: the scene has no media
  std::unique_ptr<StartInteriors> m_start_interiors;       ///< null: the scene has no interiors
  std::vector<std::unique_ptr<ShadingBuffers>> m_buffers;  ///< one a surface that is being shaded
  std::size_t m_shaded = 0;  ///< of these: several where shading itself asks for the light of rays
};

}  // namespace lentray::core
