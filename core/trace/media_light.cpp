#include "core/trace/media_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/trace/illumination.h"
#include "core/trace/random_key.h"
#include "core/trace/reflectance.h"

namespace lentray::core {
namespace {

enum Passage : std::uint64_t { kInteriors, kAir };  ///< each has random numbers of its own

bool any_scatters(const MediaList& media) {
  return std::any_of(media.begin(), media.end(), [](const Medium* m) { return m->scatters(); });
}

bool any_collects(const MediaList& media) {
  return std::any_of(media.begin(), media.end(),
                     [](const Medium* m) { return m->collects_photons; });
}

bool any_directed(const MediaList& media) {
  return std::any_of(media.begin(), media.end(), [](const Medium* m) {
    return m->phase.kind != PhaseFunction::Kind::kIsotropic;
  });
}

}  // namespace

/// A point of the media: what they emit there, and what they scatter of each light.
class MediaLight::Probe final : public MediaProbe {
 public:
  Probe(MediaLight& owner, const RayState& state, int level, const LightLists& lists,
        std::uint64_t key)
      : m_owner(owner), m_state(state), m_level(level), m_lists(lists),
        m_scatters(any_scatters(owner.m_media)), m_directed(any_directed(owner.m_media)),
        m_collects(any_collects(owner.m_media)), m_random(key, RandomSequence::Use::kMedia),
        m_light_key(RandomSequence::use_key(key, RandomSequence::Use::kMediaLights)) {}

  MediaPoint at(double distance, bool lit) override {
    MediaPoint point;
    const Vec3 place = m_state.ray.at(distance);
    Rgb scattering;
    for (const Medium* medium : m_owner.m_media) {
      const Rgb density = medium->density(place);
      point.source += density * medium->emission;
      point.extinction += density * medium->extinction();
      scattering += density * medium->scattering;
    }
    if (!m_scatters || scattering.is_black()) return point;
    if (lit) point.source += scattering * arriving(place, distance);
    if (m_owner.m_photons) point.source += scattering * brought_by_photons(place);
    return point;
  }
  double random() override { return m_random.next(); }

 private:
  /// The lights, each weighed by how much of it goes on along the ray.
  Rgb arriving(const Vec3& place, double distance) {
    struct Facing {
      const Probe& probe;
      const double distance;
      bool may_face(const LightSource& source, const Vec3&) const {
        const auto& part = probe.m_owner.m_part_of[source.index];
        return part && part->holds(distance);
      }
      bool faces(const LightSource&, const Vec3&) const { return true; }
    };
    struct Receiver {
      const Probe& probe;
      Rgb sum{};
      bool may_show(const IncomingLight&) const { return true; }
      void receive(const IncomingLight& light) {
        sum += probe.going_on(light.colour, light.ray.direction);
      }
    };
    Receiver receiver{*this};
    const std::uint64_t key = branch_key(m_light_key, m_lit_points++);
    m_owner.m_lights.at({place, m_level, m_state.tree_place, m_state.inside, key, true, m_collects},
                        m_lists, m_owner.m_at_point, Facing{*this, distance}, receiver);
    return receiver.sum;
  }
  Rgb brought_by_photons(const Vec3& place) {
    FoundPhotons& found = m_owner.m_found;
    m_owner.m_photons->gather(place, nullptr, found, m_owner.m_more);
    if (found.is_empty() || !(found.radius() > 0.0)) return {};
    Rgb sum;
    for (const FoundPhotons::One& one : found) {
      const Photon& photon = m_owner.m_photons->tree()[one.number];
      sum += going_on(power_of(photon), way_back(photon));
    }
    return times(sum, 3.0 / (4.0 * std::numbers::pi * std::pow(found.radius(), 3.0)));
  }
  /// What goes on along the ray of light that comes from there.
  Rgb going_on(const Rgb& light, const Vec3& from) const {
    return m_directed ? light * phase(dot(from, m_state.ray.direction)) : light;
  }
  /// The mean of all media, also of those that do not scatter.
  float phase(double cosine) const {
    double sum = 0.0;
    for (const Medium* medium : m_owner.m_media) sum += medium->phase(cosine);
    return static_cast<float>(sum / static_cast<double>(m_owner.m_media.size()));
  }

  MediaLight& m_owner;
  const RayState& m_state;
  const int m_level;
  const LightLists& m_lists;
  const bool m_scatters, m_directed, m_collects;
  RandomSequence m_random;
  const std::uint64_t m_light_key;
  std::uint64_t m_lit_points = 0;  ///< so far
};

MediaLight::MediaLight(ThreadContext& context, ShadowTester& shadows)
    : m_context(context), m_lights(context, shadows, true),
      m_photons(media_photons(context)), m_at_point(context.scene.lights().size()),
      m_part_of(context.scene.lights().size()) {}

void MediaLight::pass_interiors(const RayState& state, double length, int level,
                                const Attributes& attributes, Radiance& light) {
  find_media(m_context.interiors, state.inside, m_media);
  pass(state, length, level, &attributes, branch_key(state.key, kInteriors), light);
}

void MediaLight::pass_air(const RayState& state, double length, int level,
                          const Attributes* attributes, Radiance& light) {
  m_media.clear();
  for (const auto& medium : m_context.scene.atmosphere().media) m_media.push_back(medium.get());
  pass(state, length, level, attributes, branch_key(state.key, kAir), light);
}

void MediaLight::pass(const RayState& state, double length, int level, const Attributes* attributes,
                      std::uint64_t key, Radiance& light) {
  if (m_media.empty()) return;
  const LightLists lists =
      attributes ? m_lights.lights_of(*attributes) : LightLists{m_context.scene.global_lights()};
  find_lit_parts(lists, state.ray, length);
  const Medium& first = leading(m_media);
  m_cutter.cut(first.sampling, first.densities.empty(), length, m_lit, m_intervals);
  Probe probe(*this, state, level, lists, key);
  const SamplingPlan plan{first.sampling, least_aa_threshold(m_media), first.variance_limits};
  sample_media(plan, probe, m_intervals);
  const MediaSum sum = sum_of(m_intervals);
  light.rgb = light.rgb * sum.left + sum.source;
  light.transmit *= grey(sum.left);
}

void MediaLight::find_lit_parts(const LightLists& lists, const Ray& ray, double length) {
  const auto& all = m_context.scene.lights();
  m_lit.clear();
  for (const std::span<const std::uint32_t> lights : lists) {
    for (const std::uint32_t i : lights) {
      m_part_of[i] = all[i].lights_media ? lit_part(all[i], ray, length) : std::nullopt;
      if (m_part_of[i]) m_lit.push_back(*m_part_of[i]);
    }
  }
}

}  // namespace lentray::core
