#include "core/trace/ray_waves.h"

#include <algorithm>
#include <memory>

#include "core/trace/illumination.h"

namespace lentray::core {

RayWaves::RayWaves(ThreadContext& context, Integrator& integrator, ShadowTester& shadows)
    : m_context(context), m_integrator(integrator), m_stepper(integrator.stepper()),
      m_lights(context, shadows), m_plain(context, shadows, m_lights) {
  // Indirect light is asked for in the order of the rays of one sample after the other.
  m_works = m_lights.works() && !context.indirect;
  // Photons light surfaces one by one.
  m_has_plain = m_plain.works() && !surface_photons(context);
  if (!m_works) return;
  m_nodes = std::make_unique<Node[]>(kMostNodes);
}

void RayWaves::trace(std::span<const Ray> rays, std::span<const SampleOfPixel> samples,
                     const FirstHits* hits, std::span<Radiance> seen) {
  m_context.interiors.forget_if_large();
  m_samples = samples;
  m_count = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    m_camera[i] = m_stepper.begin(rays[i], samples[i].pixel, samples[i].key);
    add(m_camera[i], i, 0);
  }
  for (std::size_t first = 0; first < m_count;) {
    const std::size_t end = std::min(first + kMost, first == 0 ? rays.size() : m_count);
    meet(first, end, first == 0 ? hits : nullptr);
    light(first, end);
    shade(first, end);
    first = end;
  }
  resolve();
  for (std::size_t i = 0; i < rays.size(); ++i) seen[i] = m_nodes[i].seen;
}

void RayWaves::meet(std::size_t first, std::size_t end, const FirstHits* known) {
  for (std::size_t i = first; i < end; ++i) {
    const std::size_t at = i - first;
    const Node& node = m_nodes[i];
    if (node.is_cut) {
      m_hits[at] = nullptr;
    } else if (known && known->is_known(i)) {
      m_hits[at] = known->hit(i);
    } else {
      Hit& hit = m_own_hits[at];
      hit = {};
      m_hits[at] = m_stepper.meet(*node.state, hit) ? &hit : nullptr;
    }
  }
}

namespace {

/// The side of a surface where lights may light one of its layers; a null vector: both.
Vec3 front_of(Layers layers, const MetPlace& where) {
  if (layers.size() == 1) return layers.front().normal;
  return std::ranges::any_of(layers, &Layer::is_turned) ? Vec3() : where.normal;
}

}  // namespace

[[gnu::always_inline]] inline void RayWaves::place(std::size_t at, const RayState& state,
                                                   const Hit& hit) {
  const MetPlace& place = *std::construct_at(&m_places[at], state.ray, hit);
  m_found[at] = m_stepper.layers().find(state, hit, place, m_layers);
  if (m_stepper.layers().may_be_lit(*hit.leaf, place.from_behind)) {
    m_lights.add(hit, place, front_of(plain_layers(at), place));
  } else {
    m_lights.add_none();
  }
}

void RayWaves::light(std::size_t first, std::size_t end) {
  if (std::none_of(m_hits.begin(), m_hits.begin() + (end - first),
                   [](const Hit* hit) { return hit; }))
    return;
  m_lights.clear();
  m_plain.clear();
  m_layers.clear();
  for (std::size_t at = 0; at < end - first; ++at) {
    if (const Hit* hit = m_hits[at]) {
      place(at, *m_nodes[first + at].state, *hit);
    } else {
      m_lights.add_none();
    }
  }
  m_lights.find();
  if (!m_has_plain) return;
  for (std::size_t at = 0; at < end - first; ++at) {
    m_plain.add(m_hits[at] ? plain_layers(at) : Layers(), m_nodes[first + at].state->ray.direction);
  }
  m_plain.light([&](std::uint32_t light, std::size_t at) {
    return m_stepper.filters(*m_nodes[first + at].state, m_places[at], light, m_lights, at);
  });
}

void RayWaves::shade(std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i) {
    Node& node = m_nodes[i];
    if (node.is_cut) continue;
    const std::size_t at = i - first;
    if (const Hit* hit = m_hits[at]) {
      if (m_plain.is_known(at)) {
        m_stepper.see_lit(
            *node.state, *hit, m_places[at], m_found[at], m_layers,
            [&](std::size_t layer) { return m_plain.sum(at, layer); }, node.record);
      } else {
        m_context.pixel = m_samples[node.root].pixel;
        m_stepper.see_layers(*node.state, *hit, m_places[at], m_found[at], m_layers, m_lights, at,
                             node.record);
      }
      if (!node.record.onward.empty()) add_onward(node);
    } else {
      m_stepper.see_nothing(*node.state, node.record);
    }
  }
}

void RayWaves::add_onward(Node& node) {
  const std::vector<OnwardRay>& onward = node.record.onward;
  if (m_count + onward.size() > kMostNodes) {
    node.first = kFollowed;
    return;
  }
  node.first = static_cast<std::uint32_t>(m_count);
  for (const OnwardRay& ray : onward) add(ray.state, node.root, node.depth + 1);
}

void RayWaves::resolve() {
  for (std::size_t i = m_count; i-- > 0;) {
    Node* const node = &m_nodes[i];
    if (node->is_cut) continue;
    std::uint32_t next = node->first;
    if (next == kFollowed) m_context.pixel = m_samples[node->root].pixel;
    node->seen = node->record.gather([&](const OnwardRay& ray) {
      if (next == kFollowed) return m_integrator.follow_from(ray.state, node->depth + 1);
      return m_nodes[next++].seen;
    });
    m_stepper.arrive(*node->state, node->record, node->seen);
  }
}

}  // namespace lentray::core
