// The shadow tester without a cache: one search for an opaque blocker, then, where the scene has
// any, one for what filters the light. World space. One a thread.
// Source: reference manual 3.7, "Filter", "Caustics", "Attenuation"; the sequence of filters and
// their spacing as measured on stock (tests/image/shading_shadows_test.cpp).
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/light/light.h"
#include "core/material/texture.h"
#include "core/trace/interior_table.h"
#include "core/trace/media_attenuation.h"
#include "core/trace/shadow_tester.h"
#include "core/trace/thread_context.h"

namespace lentray::core {

class Hierarchy;

class PlainShadowTester final : public ShadowTester {
 public:
  /// `count_hits`: what light buffers foresee counts as a hit of a cache, other blockers as misses.
  explicit PlainShadowTester(ThreadContext& context, bool count_hits = false);

  Visibility visibility(const ShadowQuery& query) override {
    ShadowCounts& counts = m_context.counters.lights[query.light];
    ++counts.rays;
    const Visibility seen = search(query);
    if (seen.blocker) ++counts.blocked;
    return seen;
  }

  PlainShadowTester* plain() override { return this; }
  /// Counts a ray as visibility() does, which was asked for elsewhere. `foreseen`: as LightBuffer::Answer's.
  void count(std::uint32_t light, bool blocked, bool foreseen) {
    ShadowCounts& counts = m_context.counters.lights[light];
    ++counts.rays;
    if (!blocked) return;
    ++counts.blocked;
    if (m_counts_hits) ++(foreseen ? counts.hits : counts.misses);
  }
  bool counts_hits() const { return m_counts_hits; }
  /// What is left of the light where no opaque object is in the way, not counted as a ray. The query's spot is
  /// known, and the light's buffer serves it.
  Rgb filters(const ShadowQuery& query) {
    return filter_through(query, m_context.scene.light_buffer(query.light), query.spot,
                          query.distance - m_tolerance);
  }

  /// The full search, not counted as a ray.
  Visibility search(const ShadowQuery& query);
  /// The same test against one opaque object of the scene: whether it alone blocks the query.
  bool blocks(const Object& object, const ShadowQuery& query) const {
    const double reach = query.distance - m_tolerance;
    if (query.only.is_known && &object != query.only.object) return false;
    return reach > m_tolerance &&
           object.any(query.ray, start(query), reach, {m_context.lists, RayKind::kShadow});
  }
  ThreadContext& context() const { return m_context; }

 private:
  /// From where on opaque surfaces count.
  double start(const ShadowQuery& query) const { return query.from_air ? 0.0 : m_tolerance; }
  /// Fills m_hits with the filtering surfaces up to `reach`.
  void find_filters(const Ray& ray, const LightBuffer* buffer, const LightBuffer::Spot* spot,
                    double reach);
  double filter_found(const Ray& ray, const Light& light, Rgb& filter);
  /// Fills m_order.
  void order_filters(const Ray& ray);
  void order_ties(const Ray& ray);
  /// `buffer`: of the light, with the `spot` there, or null.
  Rgb filter_through(const ShadowQuery& query, const LightBuffer* buffer,
                     const LightBuffer::Spot* spot, double reach);
  /// Where it is the same at every point of the hit's texture.
  std::optional<Rgb> plain_filter(const Attributes& attributes) const;
  /// Whether light comes through there as photons, and in no other way.
  bool is_for_photons(const Hit& hit, const Light& light) const;
  Rgb surface_filter(const Hit& hit, const Ray& ray, double depth, bool inside);
  /// What media in the solids around leave of the light on a piece of its way.
  Rgb left_by_interiors(const Segment& way);
  /// The same of media and fogs of the air.
  Rgb left_by_air(const Segment& way);

  ThreadContext& m_context;
  double m_tolerance;  ///< kShadowTolerance in this scene
  const Hierarchy& m_hierarchy;
  Counters* m_test_counters;
  bool m_any_transparent, m_begins_anew;
  bool m_interiors, m_counts_hits;
  bool m_media, m_dimmed_by_air;
  bool m_photons;           ///< light surfaces
  bool m_collects = false;  ///< these bring the query's light through their targets
  bool m_volumes = false;   ///< some may dim the query's light
  bool m_by_place;          ///< textures that differ from place to place or on the inside
  double m_bailout;
  LightBuffer::Spot m_spot;  ///< of the query, where it has none
  InteriorTable& m_table;
  InteriorsId m_inside = InteriorsId::kOpen;  ///< on the way of the query
  std::vector<Hit> m_hits;
  struct Place {
    double t, entry;             ///< entry: of the object's box, where distances tie
    std::uint32_t place, index;  ///< of the object in the scene, of the hit in m_hits
    auto operator<=>(const Place&) const = default;
  };
  std::vector<Place> m_order;
  WeightedTextures m_textures;
  MediaList m_media_here;
  MediaAttenuation m_attenuation;
};

using PlainShadowTesterFactory = ShadowTestersOf<PlainShadowTester>;

}  // namespace lentray::core
