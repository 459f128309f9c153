#include "core/trace/plain_shadow_tester.h"

#include <algorithm>
#include <cmath>

#include "core/accel/hierarchy.h"
#include "core/accel/light_buffer.h"
#include "core/numeric/box_ray.h"
#include "core/object/leaf.h"
#include "core/scene/scene.h"
#include "core/scene/tolerances.h"
#include "core/trace/illumination.h"
#include "core/trace/open_air.h"
#include "core/trace/reflectance.h"
#include "core/trace/refraction.h"
#include "core/trace/surface_textures.h"

namespace lentray::core {
PlainShadowTester::PlainShadowTester(ThreadContext& context, bool count_hits)
    : m_context(context), m_tolerance(kShadowTolerance * context.scene.tolerance_scale()),
      m_hierarchy(context.scene.hierarchy()), m_test_counters(context.tests),
      m_any_transparent(context.scene.needs().transparent_shadows),
      m_begins_anew(context.scene.needs().shadows_begin_anew),
      m_interiors(context.scene.needs().interiors), m_counts_hits(count_hits),
      m_media(context.scene.needs().media), m_dimmed_by_air(context.scene.needs().dimming_air),
      m_photons(surface_photons(context) != nullptr),
      m_by_place(context.scene.needs().textures_by_place ||
                 context.scene.needs().interior_textures),
      m_bailout(context.scene.settings().adc_bailout), m_table(context.interiors) {}

Visibility PlainShadowTester::search(const ShadowQuery& query) {
  const double reach = query.distance - m_tolerance;
  if (!(reach > m_tolerance)) return {};
  const LightBuffer* buffer = m_context.scene.light_buffer(query.light);
  const LightBuffer::Spot* spot = query.spot;
  if (buffer && !spot) {
    buffer->locate(query.ray.origin, m_spot);
    spot = &m_spot;
  }
  if (buffer && !buffer->serves(*spot, query.distance)) buffer = nullptr;
  const Object* blocker = nullptr;
  if (query.only.is_known) {
    const Object* only = query.only.object;
    const RayQuery asked{m_context.lists, RayKind::kShadow};
    if (only && only->any(query.ray, start(query), reach, asked)) blocker = only;
  } else if (buffer) {
    const LightBuffer::Answer answer =
        buffer->any_opaque(*spot, query.ray, start(query), reach, m_context.lists, m_test_counters);
    blocker = answer.blocker;
    if (blocker && m_counts_hits) {
      ShadowCounts& counts = m_context.counters.lights[query.light];
      ++(answer.foreseen ? counts.hits : counts.misses);
    }
  } else {
    blocker =
        m_hierarchy.any_opaque(query.ray, start(query), reach, m_context.lists, m_test_counters);
  }
  if (blocker) return {Rgb(0.0f), blocker};
  if (!m_dimmed_by_air && !(m_any_transparent && (!buffer || buffer->may_filter(*spot)))) return {};
  return {filter_through(query, buffer, spot, reach), nullptr};
}

/// Of surfaces at one distance comes first that of the object whose box the ray enters first:
/// what is left before what is entered. Then the scene's order; so the answer does not
/// depend on who found them.
void PlainShadowTester::order_ties(const Ray& ray) {
  bool tied = false;
  const auto tie = [&](std::size_t i) {
    m_order[i].entry = entry_distance(m_hits[m_order[i].index].object->bounds(), ray);
    tied = true;
  };
  for (std::size_t i = 1; i < m_order.size(); ++i) {
    if (m_order[i].t != m_order[i - 1].t || m_order[i].place == m_order[i - 1].place) continue;
    tie(i - 1);
    tie(i);
  }
  if (tied) std::sort(m_order.begin(), m_order.end());
}

[[gnu::always_inline]] inline void PlainShadowTester::find_filters(const Ray& ray,
                                                                   const LightBuffer* buffer,
                                                                   const LightBuffer::Spot* spot,
                                                                   double reach) {
  m_hits.clear();
  if (buffer) {
    buffer->all_transparent(*spot, ray, m_tolerance, reach, m_begins_anew, m_hits, m_context.lists,
                            m_test_counters);
  } else {
    m_hierarchy.all_transparent(ray, m_tolerance, reach, m_begins_anew, m_hits, m_context.lists,
                                m_test_counters);
  }
}

void PlainShadowTester::order_filters(const Ray& ray) {
  m_order.clear();
  for (std::size_t i = 0; i < m_hits.size(); ++i) {
    m_order.push_back({m_hits[i].t, 0.0, m_hits[i].place, static_cast<std::uint32_t>(i)});
  }
  std::sort(m_order.begin(), m_order.end());
  order_ties(ray);
}

Rgb PlainShadowTester::filter_through(const ShadowQuery& query, const LightBuffer* buffer,
                                      const LightBuffer::Spot* spot, double reach) {
  const Light& light = m_context.scene.lights()[query.light];
  const bool air = m_dimmed_by_air && light.dimmed_by_air && query.volumes;
  find_filters(query.ray, buffer, spot, reach);
  if (m_hits.empty() && !air) return Rgb(1.0f);
  m_collects = m_photons && query.collects;
  m_volumes = query.volumes && (m_media || m_dimmed_by_air);
  m_inside = m_interiors ? query.inside : InteriorsId::kOpen;
  Rgb filter(1.0f);
  Ray ray = query.ray;
  double last = filter_found(ray, light, filter);
  while (m_begins_anew && !filter.is_black() && !m_hits.empty()) {
    ray.origin = ray.at(last);
    reach -= last;
    find_filters(ray, buffer, spot, reach);
    last = filter_found(ray, light, filter);
  }
  if (air && !filter.is_black()) {
    const double rest = reach + m_tolerance - last;
    if (rest > m_tolerance && m_table.is_hollow(m_inside)) {
      filter *= left_by_air({{ray.at(last), ray.direction}, rest});
    }
  }
  return filter;
}

/// Multiplies by what m_hits let through; with m_begins_anew the first of them. Answers where the last was.
double PlainShadowTester::filter_found(const Ray& ray, const Light& light, Rgb& filter) {
  order_filters(ray);
  // A surface that follows the one before within the tolerance does not count.
  double last = 0.0;
  for (const Place& at : m_order) {
    if (!(at.t - last > m_tolerance)) continue;
    const Hit& hit = m_hits[at.index];
    if (m_collects && is_for_photons(hit, light)) {
      filter = Rgb(0.0f);
      break;
    }
    const InteriorEntry entry = interior_of(hit.leaf->attributes(), hit.object);
    const bool leaves = m_interiors && m_table.contains(m_inside, entry.key);
    const double length = at.t - last;
    filter *= surface_filter(hit, ray, length, leaves);
    if (filter.is_black()) break;
    if (m_volumes) {
      const Segment way{{ray.at(last), ray.direction}, length};
      if (m_media) filter *= left_by_interiors(way);
      if (light.dimmed_by_air) filter *= left_by_air(way);
    }
    if (m_interiors) {
      m_inside = leaves ? m_table.remove(m_inside, entry.key) : m_table.push(m_inside, entry);
    }
    last = at.t;
    if (m_begins_anew) break;
  }
  return last;
}

Rgb PlainShadowTester::left_by_interiors(const Segment& way) {
  find_media(m_table, m_inside, m_media_here);
  return m_attenuation.left(m_media_here, way);
}

// Media of the air dim the way to a surface in solids that are not hollow too.
Rgb PlainShadowTester::left_by_air(const Segment& way) {
  const Atmosphere& air = m_context.scene.atmosphere();
  m_media_here.clear();
  for (const auto& medium : air.media) m_media_here.push_back(medium.get());
  const Rgb left = m_attenuation.left(m_media_here, way);
  return m_table.is_hollow(m_inside) ? left * left_by_fogs(air, way) : left;
}

bool PlainShadowTester::is_for_photons(const Hit& hit, const Light& light) const {
  const PassFlags& flags = m_context.scene.pass_flags(hit.leaf->attributes());
  return flags.photon_target > 0.0 &&
         photons_go_on(flags.photon_refraction, light.photon_refraction);
}

std::optional<Rgb> PlainShadowTester::plain_filter(const Attributes& attributes) const {
  const LayeredTexture* texture = m_by_place ? nullptr : attributes.texture->everywhere();
  if (!texture || (attributes.interior && attributes.interior->caustics != 0.0))
    return std::nullopt;
  Rgb through(1.0f);
  for (const TextureLayer& layer : texture->layers()) {
    const Colour* constant = layer.pigment->constant();
    if (!constant) return std::nullopt;
    through *= passed(*constant);
  }
  return through;
}

// Texture maps blend what their textures let through. `inside`: the light came through the
// interior of that surface to here.
Rgb PlainShadowTester::surface_filter(const Hit& hit, const Ray& ray, double depth, bool inside) {
  const Attributes& attributes = hit.leaf->attributes();
  const Interior* interior = attributes.interior;
  const bool fades = inside && interior && interior->fade_power > 0.0;
  if (const auto plain = plain_filter(attributes)) {
    return fades ? *plain * fade_in_interior(*interior, depth) : *plain;
  }
  const Vec3 point = ray.at(hit.t);
  const bool caustics = interior && interior->caustics != 0.0;
  const Vec3& along = ray.direction;
  Vec3 normal = hit.leaf->normal(point, hit.shape);
  const bool from_behind = dot(normal, along) > 0.0;
  if (from_behind) normal = -normal;
  SurfaceContext surface{point, normal, along, &hit};
  m_textures.clear();
  textures_at(surface, from_behind, m_bailout, m_textures);
  Rgb sum;
  for (const WeightedTexture& weighted : m_textures) {
    const TexturePlace place = m_textures.place(weighted);
    Rgb through(1.0f);
    for (const TextureLayer& layer : weighted.texture->layers()) {
      const Colour* constant = layer.pigment->constant();
      through *= passed(constant ? *constant : layer.pigment->colour(place.point, surface));
      if (!caustics) continue;
      const double cosine = dot(
          layer.normal ? place.outwards(place.perturbed(*layer.normal, normal, surface)) : normal,
          along);
      through = times(through, 1.0 + std::pow(std::fabs(cosine), interior->caustics));
    }
    sum += times(through, weighted.weight);
  }
  return fades ? sum * fade_in_interior(*interior, depth) : sum;
}

}  // namespace lentray::core
