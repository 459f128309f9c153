// The light that arrives at any point, on a surface or in the air, in three steps: *collect* the
// lights that may reach the point, *ask* what their shadow rays pass, *resolve* what is left into a
// sum. World space; colours linear. One a thread.
// collect() needs neither objects nor random numbers, and what ask() finds of a light without area
// is the same whatever was asked before. So many points may be collected and their shadow rays
// asked in any order, as long as each point is resolved in the order of its lights. Area lights
// are asked when their turn comes to be resolved: which samples are taken depends on what others
// have met, and their jitter is drawn in the order of the lights. What is collected of one is the
// ray to its middle, which gives its axes.
// Source: reference manual 3.7, "Light Source", "Area Lights", "Light Groups".
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/accel/light_buffer.h"
#include "core/light/light_ray.h"
#include "core/object/leaf.h"
#include "core/scene/tolerances.h"
#include "core/trace/area_shaft.h"
#include "core/trace/block_lights.h"
#include "core/trace/plain_shadow_tester.h"
#include "core/trace/random_key.h"
#include "core/trace/shadow_tester.h"
#include "core/trace/thread_context.h"

namespace lentray::core {

struct UnmetObject;

/// A light, and those of its properties that every shading point needs, copied next to each other so that they
/// share cache lines.
struct LightSource {
  LightSource(const Light& l, std::uint32_t i, const LightBuffer* b, bool areas)
      : position(l.position), colour(l.colour), straight(is_straight(l)), even(is_even(l)),
        shadowless(l.shadowless), by_area(l.illuminates_by_area()), has_points(areas && by_area),
        has_area(areas && l.has_area), may_be_hindered(!l.shadowless || l.projector), index(i),
        light(l), buffer(b) {}
  /// Certain without a square root that it is behind a surface. `to` leads to its position.
  bool surely_behind(const Vec3& to, const Vec3& normal) const {
    return straight && !by_area && dot(normal, to) < 0.0;
  }
  Vec3 position;
  Rgb colour;
  bool straight, even, shadowless, by_area;
  bool has_points;       ///< each point of its area lights a surface by itself
  bool has_area;         ///< its shadow is that of its area
  bool may_be_hindered;  ///< not all of it arrives everywhere
  std::uint32_t index;   ///< into Scene::lights()
  const Light& light;
  const LightBuffer* buffer;  ///< null: the hierarchy answers for it
};

/// The lights that light something: two lists of their indices, in the order in which they are summed up.
using LightLists = std::array<std::span<const std::uint32_t>, 2>;

/// A light that may reach a point.
struct IncomingLight {
  const LightSource* source;
  LightRay ray;  ///< to the light's position
  Rgb colour;    ///< collected: while nothing stands in the way; asked: what arrives
};

/// A point whose light is asked for. Of a ray: how far it has come and what it travels in.
struct LitPoint {
  const Vec3& point;
  int level;                 ///< trace level of the ray, 1: camera ray
  std::uint32_t tree_place;  ///< as ShadowQuery's
  InteriorsId inside;        ///< of the ray
  std::uint64_t key;         ///< of the random numbers of the point
  bool in_air = false;       ///< lies on no surface
  bool collects = true;      ///< may be lit by photons
  bool volumes = true;       ///< fog and media dim what arrives
};

/// What is known of the lights at one point: where it lies in their buffers. A buffer that is used from point to point.
struct LightsAtPoint {
  explicit LightsAtPoint(std::size_t lights) : spots(lights) {}
  /// All but what the block knows is to be asked for.
  void begin_in_block(const BlockLights& of, std::size_t at) {
    block = &of;
    place = at;
    for (LightBuffer::Spot& spot : spots) spot.known = false;
  }
  const BlockLights* block = nullptr;  ///< that has asked for the point already; null: none
  std::size_t place = 0;               ///< of the point in it
  std::vector<LightBuffer::Spot> spots;
};

class LightLoop {
 public:
  /// `area_lights`: false: they are points.
  LightLoop(ThreadContext& context, ShadowTester& shadows, bool area_lights)
      : m_context(context), m_scene(context.scene), m_shadows(shadows), m_plain(shadows.plain()),
        m_tolerance(kShadowTolerance * context.scene.tolerance_scale()), m_shaft(context) {
    for (std::size_t i = 0; i < m_scene.lights().size(); ++i) {
      m_sources.emplace_back(m_scene.lights()[i], static_cast<std::uint32_t>(i),
                             m_scene.light_buffer(i), area_lights);
    }
  }

  std::size_t lights() const { return m_sources.size(); }
  LightLists lights_of(const Attributes& attributes) const {
    if (!attributes.lights) return {m_scene.global_lights()};
    return {attributes.lights->global ? m_scene.global_lights() : std::span<const std::uint32_t>(),
            attributes.lights->local};
  }

  /// Finds a point of a surface in the lights' buffers, so that their cells are in the processor's
  /// cache when the loop comes to them. To be called before at(), once a point of a surface. Lights
  /// behind the surface are most often not asked for: their spots stay unknown.
  void look_ahead(const LightLists& lists, const Vec3& normal, const Hit& hit, bool from_behind,
                  const Vec3& point, LightsAtPoint& known) const;

  /// The lights of the lists, in their order, but for those that are dark at the point or unwanted:
  ///   bool facing.may_face(source, to)     false: nothing of the light is wanted; cheap
  ///   bool facing.faces(source, direction) the same, with the unit direction to the light
  /// Writes from `out` on, where there is room for all of the lists; returns the end.
  template <class Facing>
  [[gnu::always_inline]] IncomingLight* collect(const Vec3& point, const LightLists& lists,
                                                const Facing& facing, IncomingLight* out) const {
    for (const std::span<const std::uint32_t> lights : lists) {
      for (const std::uint32_t i : lights) {
        if (may_reach(m_sources[i], point, facing, *out)) ++out;
      }
    }
    return out;
  }

  /// The query of a point seen by the context's pixel, for ask(), which completes it.
  ShadowQuery query_at(const LitPoint& lit) const {
    ShadowQuery query;
    query.ray.origin = lit.point;
    query.level = lit.level;
    query.tree_place = lit.tree_place;
    query.column = m_context.pixel.column;
    query.row = m_context.pixel.row;
    query.inside = lit.inside;
    query.key = lit.key;
    query.from_air = lit.in_air;
    query.collects = lit.collects;
    query.volumes = lit.volumes;
    return query;
  }
  /// What filters leave of a light at a place of a block where the answer is kFiltered.
  Rgb filters(const LitPoint& lit, std::uint32_t light, const BlockLights& block,
              std::size_t place) const;
  /// Takes from the colour what does not arrive.
  void ask(IncomingLight& incoming, ShadowQuery& query, const LightsAtPoint& known) {
    if (!incoming.source->may_be_hindered) return;
    const std::uint32_t light = incoming.source->index;
    query.light = light;
    if (incoming.source->has_area) {
      incoming.colour = of_area(incoming.colour, incoming.ray, query);
    } else {
      incoming.colour = of_point(incoming.colour, incoming.ray, query, known);
    }
  }

  /// Gives what arrives to receiver.receive(incoming). receiver.may_show(incoming) is asked before filters are: false,
  /// where whatever they leave changes nothing.
  template <class Receiver>
  [[gnu::always_inline]] static void resolve(const IncomingLight& incoming, Receiver& receiver) {
    if (!is_dark(incoming.colour)) receiver.receive(incoming);
  }

  /// The three steps for one point. The receiver does not ask this loop.
  template <class Facing, class Receiver>
  [[gnu::always_inline]] void at(const LitPoint& lit, const LightLists& lists, LightsAtPoint& known,
                                 const Facing& facing, Receiver& receiver) {
    ShadowQuery query = query_at(lit);
    for (const std::span<const std::uint32_t> lights : lists) {
      for (const std::uint32_t i : lights) {
        const LightAnswers::Answer answer =
            known.block ? known.block->answer(i, known.place) : LightAnswers::kUnknown;
        IncomingLight incoming;
        if (LightAnswers::has_ray(answer)) {
          if (!faces_known(m_sources[i], lit.point, facing, known, incoming)) continue;
          if (!pass(answer, lit, known, receiver, incoming)) continue;
        } else {
          if (!may_reach(m_sources[i], lit.point, facing, incoming)) continue;
          ask(incoming, query, known);
        }
        resolve(incoming, receiver);
      }
    }
  }

 private:
  /// may_reach() where the ray is known.
  template <class Facing>
  [[gnu::always_inline]] static bool faces_known(const LightSource& source, const Vec3& point,
                                                 const Facing& facing, const LightsAtPoint& known,
                                                 IncomingLight& out) {
    out.source = &source;
    out.ray = ray_at(*known.block->of(source.index), known.place);
    out.colour = source.even ? source.colour : light_colour(source.light, point, out.ray);
    return !is_dark(out.colour) && facing.faces(source, out.ray.direction);
  }
  /// ask() where the answer is known. False: whatever filters leave of the light shows nothing.
  template <class Receiver>
  [[gnu::always_inline]] bool pass(LightAnswers::Answer answer, const LitPoint& lit,
                                   const LightsAtPoint& known, const Receiver& receiver,
                                   IncomingLight& incoming) {
    const std::uint32_t light = incoming.source->index;
    const bool is_filtered = answer == LightAnswers::kFiltered;
    m_plain->count(light, LightAnswers::is_dark(answer), answer == LightAnswers::kForeseen);
    if (is_filtered && !receiver.may_show(incoming)) return false;
    if (LightAnswers::is_dark(answer)) incoming.colour *= Rgb(0.0f);
    if (is_filtered) incoming.colour *= filters(lit, light, *known.block, known.place);
    return true;
  }

  /// Collects one light; false: it is dark at the point, or unwanted.
  template <class Facing>
  [[gnu::always_inline]] static bool may_reach(const LightSource& source, const Vec3& point,
                                               const Facing& facing, IncomingLight& out) {
    const Vec3 to = source.position - point;
    if (!facing.may_face(source, to)) return false;
    out.source = &source;
    out.ray = source.straight ? ray_along(to) : light_ray(source.light, point);
    out.colour = source.even ? source.colour : light_colour(source.light, point, out.ray);
    return !is_dark(out.colour) && facing.faces(source, out.ray.direction);
  }

  Rgb of_point(const Rgb& colour, const LightRay& ray, ShadowQuery& query,
               const LightsAtPoint& known) {
    const LightBuffer::Spot& spot = known.spots[query.light];
    query.spot = spot.known ? &spot : nullptr;
    query.sample = 0;
    query.ray.direction = ray.direction;
    query.distance = ray.distance;
    return colour * left(query);
  }

  /// The part of a light's colour that the query's ray gets.
  Rgb left(ShadowQuery& query) {
    const Light& light = m_scene.lights()[query.light];
    if (light.projector) {
      if (!pass_projector(*light.projector, query)) return {};
      if (light.shadowless) return Rgb(1.0f);
    }
    return m_shadows.visibility(query).filter;
  }
  /// False if the ray misses the projector. What lies behind it throws no shadow.
  bool pass_projector(const Object& projector, ShadowQuery& query) const;

  Rgb of_area(const Rgb& colour, const LightRay& ray, ShadowQuery& query);

  void mark_unmet(const LightLists& lists, const Vec3& normal, const UnmetObject& unmet,
                  const Vec3& point, LightsAtPoint& known) const;

  ThreadContext& m_context;
  const Scene& m_scene;
  ShadowTester& m_shadows;
  PlainShadowTester* const m_plain;  ///< null: `m_shadows` is to be asked for each ray
  const double m_tolerance;          ///< kShadowTolerance in this scene
  AreaShaft m_shaft;
  std::vector<LightSource> m_sources;  ///< one a light of the scene
};

}  // namespace lentray::core
