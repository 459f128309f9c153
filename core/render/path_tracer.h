// The tracer behind Tracer::make, specialised by what a scene can hold: a path leaves out what
// certainly never happens, so every path gives the same bits where it may be used.
// World space. One a thread; no allocation per ray once its buffers have grown.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/accel/hierarchy.h"
#include "core/accel/light_buffer.h"
#include "core/light/area_light.h"
#include "core/light/light_ray.h"
#include "core/render/interior_stack.h"
#include "core/render/random_key.h"
#include "core/render/reflectance.h"
#include "core/render/render_threads.h"
#include "core/render/sky.h"
#include "core/render/start_interiors.h"
#include "core/render/surface_textures.h"
#include "core/render/tracer.h"
#include "core/scene/tolerances.h"

namespace lentray::core {

/// What a path can do; bits of PathTracer's argument.
enum PathFeature : unsigned {
  kPathTransparency = 1,  ///< filter, transmit, refraction, interiors
  kPathReflection = 2,
  kPathLayers = 4,        ///< layered textures, textures by place, interior textures
  kPathArea = 8,          ///< area lights
};
inline constexpr unsigned kAllPaths = 16;

/// A ray on its way, with what it carries. The ray is borrowed: a copy made right after it was
/// written would wait for it.
struct RayState {
  explicit RayState(const Ray& r) : ray(r) {}
  /// Not an aggregate: that would clear the whole stack first.
  RayState(const Ray& r, const InteriorStack& in, std::uint32_t tree_place, RayKind ray_kind)
      : ray(r), inside(in), place(std::min(tree_place, kTreePlaces - 1)), kind(ray_kind) {}
  const Ray& ray;
  InteriorStack inside;
  std::uint32_t place = 1;  ///< in the ray tree, see ShadowQuery
  RayKind kind = RayKind::kCamera;
};

template <unsigned kFeatures>
class PathTracer final : public Tracer {
 public:
  PathTracer(const Scene& scene, ShadowTester& shadows, HitArena& arena, Counters& counters,
             bool count_tests)
      : m_scene(scene),
        m_hierarchy(scene.hierarchy()),
        m_shadows(shadows),
        m_arena(arena),
        m_counters(counters),
        m_test_counters(count_tests ? &counters : nullptr),
        m_max_level(scene.settings().max_trace_level),
        m_bailout(scene.settings().adc_bailout),
        m_min_distance(kMinHitDistance * scene.tolerance_scale()),
        m_shadow_tolerance(kShadowTolerance * scene.tolerance_scale()),
        m_atmosphere_ior(scene.settings().atmosphere_ior),
        m_mirror_images(scene.settings().mirror_images),
        m_legacy_opacity(scene.settings().language_version < 370),
        m_air(scene.needs().atmosphere ? &scene.atmosphere() : nullptr) {
    for (std::size_t i = 0; i < scene.lights().size(); ++i) {
      m_sources.emplace_back(scene.lights()[i], scene.light_buffer(i));
    }
    if (scene.needs().interiors) {
      m_start_interiors = std::make_unique<StartInteriors>(scene);
    }
  }

  using Tracer::trace;
  Radiance trace(const Ray& ray, Pixel pixel, std::uint64_t key) override;

 private:
  static constexpr bool kTransparency = (kFeatures & kPathTransparency) != 0;
  static constexpr bool kReflection = (kFeatures & kPathReflection) != 0;
  static constexpr bool kLayers = (kFeatures & kPathLayers) != 0;
  static constexpr bool kArea = (kFeatures & kPathArea) != 0;

  /// A light with what the loop over them asks first, side by side.
  struct Source {
    Source(const Light& l, const LightBuffer* b)
        : position(l.position), colour(l.colour), straight(is_straight(l)), even(is_even(l)),
          shadowless(l.shadowless), light(l), buffer(b) {}
    /// `to` leads to its position: certain without a square root that it is behind a surface.
    bool surely_behind(const Vec3& to, const Vec3& normal) const {
      return straight && dot(normal, to) < 0.0;
    }
    Vec3 position;
    Rgb colour;
    bool straight, even, shadowless;
    const Light& light;
    const LightBuffer* buffer;  ///< or null
  };
  /// A place on a surface that is being shaded. Members without initialisers: all are given.
  struct Surface {
    const RayState& state;
    const Attributes& looks;
    SurfaceContext context;  ///< patterns of a layer see the normal of the one above
    Vec3 normal;             ///< unit, facing the ray
    Vec3 texture_point;
    float weight;            ///< the ray's share of the pixel
    int level;
    bool from_behind;        ///< the ray leaves the surface's solid

    const Ray& ray() const { return state.ray; }
    const Vec3& point() const { return context.point; }
    InteriorEntry interior() const { return interior_of(looks, context.hit->object); }
  };
  /// What a layer leaves for the mirror image that is traced after all layers.
  struct Mirror {
    Vec3 normal;
    Rgb colour;
    float weight = 0.0f;
    double exponent = 1.0;
    const Finish* finish = nullptr;
  };
  /// Buffers of one level of recursion.
  struct Frame {
    explicit Frame(std::size_t lights) : light(lights), light_known(lights), spots(lights) {}
    WeightedTextures textures;
    std::vector<Mirror> mirrors;
    std::vector<Rgb> light;             ///< what arrives of each light: layers share it
    std::vector<std::uint8_t> light_known;
    std::vector<LightBuffer::Spot> spots;  ///< one a light that has a buffer
  };
  /// Sum over the layers of a texture, and what goes on behind them.
  struct Stack {
    Rgb sum;
    Rgb filter{1.0f, 1.0f, 1.0f};
    double transparency = 1.0;
    Vec3 top_normal;
    const Finish* top_finish = nullptr;
    std::size_t layers = 0;  ///< done
  };

  /// `level` counts the levels above this ray; one that goes straight on takes none itself.
  Radiance follow(const RayState& state, float weight, int level, bool straight_on = false);
  Radiance shade(const RayState& state, const Hit& hit, float weight, int level);
  Radiance shade_textures(Surface& at, Frame& frame);
  Radiance shade_texture(const LayeredTexture& texture, Surface& at, Frame& frame);
  void shade_layer(const TextureLayer& layer, Surface& at, Stack& stack, Frame& frame);
  Mirror mirror_of(const Finish& finish, const Rgb& pigment, const Vec3& normal,
                   const Surface& at, const Stack& stack) const;
  void add_mirror_images(const Stack& stack, bool total_reflection, const Surface& at,
                         Frame& frame, Radiance& result);
  /// The lights that light what looks like that: two lists, in stock's order.
  using LightLists = std::array<std::span<const std::uint32_t>, 2>;
  LightLists lights_of(const Attributes& looks) const {
    if (!looks.lights) return {m_scene.global_lights()};
    return {looks.lights->global ? m_scene.global_lights() : std::span<const std::uint32_t>(),
            looks.lights->local};
  }
  Rgb lit(const Finish& finish, const Rgb& pigment, const Vec3& normal, double opacity,
          const Surface& at, Frame& frame);
  /// What all shadow queries of a point have in common.
  ShadowQuery query_from(const Surface& at) const;
  /// What is left of a light's colour; fills in the query.
  Rgb arriving(std::uint32_t light, const Rgb& colour, const LightRay& ray, ShadowQuery& query,
               Frame& frame);
  Rgb shadowed(const Rgb& colour, const LightRay& ray, ShadowQuery& query, const Frame& frame);
  Rgb area_shadowed(const Rgb& colour, const LightRay& ray, ShadowQuery& query);
  /// `film`: the finish whose thin film tints the image.
  Rgb mirror_image(const Vec3& normal, float weight, const Surface& at, const Finish& film);
  double film_thickness(const Finish& finish, const Vec3& point) const;
  /// Adds what is seen through the surface; true on total internal reflection.
  bool add_transmitted(const Stack& stack, const Surface& at, Radiance& result);
  double enter(const InteriorEntry& entry, InteriorStack& inside) const;
  double relative_ior(const InteriorEntry& entry, const InteriorStack& inside) const;
  /// Fog and rainbows on the way, if it is in the open.
  void pass_open_air(const RayState& state, double depth, Radiance& light);
  double random();
  Frame& enter_frame();
  void look_ahead(const Surface& at, Frame& frame) const;
  void find_unmet(const Surface& at, Frame& frame) const;

  const Scene& m_scene;
  const Hierarchy& m_hierarchy;
  ShadowTester& m_shadows;
  HitArena& m_arena;
  Counters& m_counters;
  Counters* m_test_counters;
  const int m_max_level;
  const double m_bailout;
  const double m_min_distance;  ///< kMinHitDistance in this scene
  const double m_shadow_tolerance;  ///< kShadowTolerance in this scene
  const double m_atmosphere_ior;
  const bool m_mirror_images;
  const bool m_legacy_opacity;
  const Atmosphere* m_air;  ///< null: clear
  std::vector<Source> m_sources;  ///< one a light of the scene
  std::unique_ptr<StartInteriors> m_start_interiors;
  std::vector<std::unique_ptr<Frame>> m_frames;
  std::size_t m_depth = 0;
  std::size_t m_deepest = std::numeric_limits<std::size_t>::max();  ///< known when the stack ends
  const std::uintptr_t m_stack_end = middle_of_stack();
  AreaScratch m_area;
  Pixel m_pixel;
  std::uint64_t m_key = 0;  ///< of the sample
  std::optional<RandomSequence> m_random;  ///< of the sample, once it is asked for
};

/// The path of exactly these features (a superset of what the scene needs); for Tracer::make and
/// for the test that paths agree.
std::unique_ptr<Tracer> make_path_tracer(unsigned features, const Scene& scene,
                                         ShadowTester& shadows, HitArena& arena,
                                         Counters& counters, bool count_tests);
/// What Tracer::make chooses.
unsigned path_features(const Needs& needs);

}  // namespace lentray::core
