#include "core/trace/photon_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/accel/hierarchy.h"
#include "core/base/deep_threads.h"
#include "core/scene/tolerances.h"
#include "core/trace/refraction.h"
#include "core/trace/spectrum.h"
#include "core/trace/surface_textures.h"

namespace lentray::core {
namespace {

/// Whether no photon can go on from it.
bool ends_photons(const LayeredTexture& texture) {
  const auto& layers = texture.layers();
  return texture.is_opaque() && std::all_of(layers.begin(), layers.end(), [](const auto& layer) {
           return layer.finish->reflection_max.is_black() &&
                  layer.finish->reflection_min.is_black();
         });
}

/// Photons of lights outside all light groups light it.
bool is_lit(const Attributes& attributes) {
  return !attributes.lights || attributes.lights->global;
}

}  // namespace

/// On the way to a surface.
struct PhotonPath::Leg {
  Ray ray;
  Rgb power;
  double way;  ///< from the light to the ray's origin
  float weight = 1.0f;
  int level = 0;
  InteriorsId inside = InteriorsId::kOpen;
  RayKind kind = RayKind::kPhoton;
  bool passed = false;  ///< what it left lets photons pass on their way to the target
  double wavelength = RayState::kWhite;
};

/// What a leg meets.
struct PhotonPath::Meeting {
  const Hit& hit;
  const Attributes& attributes;
  const PassFlags& flags;
  Vec3 point, normal;  ///< the normal faces the ray
  bool passes;
  InteriorEntry interior() const { return interior_of(attributes, hit.object); }
};

PhotonPath::PhotonPath(ThreadContext& context)
    : m_context(context), m_scene(context.scene), m_settings(*m_scene.settings().photons),
      m_min_distance(kMinHitDistance * m_scene.tolerance_scale()), m_start_interiors(m_scene),
      m_media(context), m_layers(context, {m_settings.adc_bailout}) {}

bool PhotonPath::shoot(const PhotonShot& shot, MediaDraws& draws, PhotonMaps& out) {
  m_context.interiors.forget_if_large();
  m_shot = &shot;
  m_draws = &draws;
  m_out = &out;
  m_met_target = false;
  Leg leg{shot.ray, shot.power, shot.way};
  if (m_scene.needs().interiors) {
    leg.inside = m_start_interiors.at(shot.ray.origin, m_context.interiors);
  }
  follow(leg);
  return m_met_target;
}

bool PhotonPath::is_wanted(const Leg& leg, const PassFlags& flags, bool& passes) {
  passes = false;
  if (leg.level > 0 && !leg.passed) return true;
  if (flags.photon_target_number == m_shot->target) {
    m_met_target = true;
    return true;
  }
  passes = flags.photon_pass_through;
  return passes;
}

void PhotonPath::follow(const Leg& leg) {
  if (leg.level >= m_settings.max_trace_level || leg.weight < m_settings.adc_bailout) return;
  if (leg.level >= static_cast<int>(kMostRays)) {
    ++m_context.counters.cut_rays;
    return;
  }
  Hit hit;
  if (!m_scene.hierarchy().nearest(leg.ray, m_min_distance, Bounds::kInf, leg.kind, hit,
                                   m_context.lists, m_context.tests)) {
    return;
  }
  const Attributes& attributes = hit.leaf->attributes();
  const PassFlags& flags = m_scene.pass_flags(attributes);
  bool passes = false;
  if (!is_wanted(leg, flags, passes)) return;
  const Vec3 point = leg.ray.at(hit.t);
  Vec3 normal = hit.leaf->normal(point, hit.shape);
  const bool from_behind = dot(normal, leg.ray.direction) > 0.0;
  if (from_behind) normal = -normal;
  const Meeting at{hit, attributes, flags, point, normal, passes};
  const SurfaceContext surface{point, normal, leg.ray.direction, &hit};
  if (const LayeredTexture* all = attributes.texture->everywhere();
      all && !attributes.interior_texture) {
    return arrive(at, *all, {texture_point(surface)}, leg);
  }
  WeightedTextures textures;
  textures_at(surface, from_behind, m_settings.adc_bailout, textures);
  for (const WeightedTexture& one : textures) {
    Leg part = leg;
    part.power = times(leg.power, one.weight);
    arrive(at, *one.texture, textures.place(one), part);
  }
}

/// What is left of its power by the interior that it comes out of.
Rgb PhotonPath::faded(const Meeting& at, const Leg& leg) const {
  const InteriorEntry interior = at.interior();
  if (!interior.interior) return leg.power;
  Rgb left(interior.interior->passed);
  if (interior.interior->fade_power > 0.0 &&
      m_context.interiors.contains(leg.inside, interior.key)) {
    left *= fade_in_interior(*interior.interior, at.hit.t);
  }
  return leg.power * left;
}

void PhotonPath::arrive(const Meeting& at, const LayeredTexture& texture, const TexturePlace& place,
                        Leg leg) {
  const bool is_behind_target = leg.level > 0 && !leg.passed;
  const PhotonMedia::Piece piece{leg.ray, at.hit.t, leg.way, leg.inside};
  if (is_behind_target && m_settings.media_steps > 0) {
    m_media.pass(piece, *m_shot, *m_draws, leg.power, m_out->media);
  } else {
    m_media.pass(piece, *m_draws, leg.power);
  }
  leg.power = faded(at, leg);
  leg.way += at.hit.t;
  ++leg.level;
  if (is_behind_target && at.flags.photon_collect && is_lit(at.attributes)) {
    m_out->surface.push_back(
        make_photon(at.point, leg.ray.origin, weighed(leg.power, leg.way, *m_shot)));
  }
  if (leg.level >= m_settings.max_trace_level) return;
  const Light& light = m_shot->light;
  const bool refracts =
      at.passes || photons_go_on(at.flags.photon_refraction, light.photon_refraction);
  const bool reflects =
      !at.passes && photons_go_on(at.flags.photon_reflection, light.photon_reflection);
  if ((!refracts && !reflects) || ends_photons(texture)) return;
  std::vector<Layer> layers;
  SurfaceContext surface{at.point, at.normal, leg.ray.direction, &at.hit};
  m_layers.find_in(texture, place, {leg.ray, at.hit, at.normal, leg.inside, true}, surface, layers);
  if (layers.empty()) return;
  bool total_reflection = false;
  if (refracts && layers.back().clear > m_settings.adc_bailout) {
    total_reflection = refract(at, layers, leg);
  }
  if (reflects) mirror_layers(at, layers, total_reflection, leg);
}

bool PhotonPath::refract(const Meeting& at, Layers layers, const Leg& leg) {
  const Rgb& filter = layers.back().below;
  const double air = m_scene.settings().atmosphere_ior;
  Leg onward = leg;
  onward.passed = at.passes;
  onward.ray.origin = at.point;
  onward.weight = leg.weight * std::max(0.0f, greatest(filter));
  const Bend bent = m_scene.needs().interiors
                        ? enter(at.interior(), air, m_context.interiors, onward.inside)
                        : Bend();
  const bool disperses = !(std::fabs(bent.dispersion - 1.0) < kTiny);
  if (std::fabs(bent.ior - 1.0) < kTiny && !disperses) {
    onward.power *= filter;
    follow(onward);
    return false;
  }
  if (!disperses) return bend(at, layers, bent.ior, leg, onward);
  if (leg.wavelength != RayState::kWhite) {
    return bend(at, layers, dispersed_ior(bent.ior, bent.dispersion, leg.wavelength), leg, onward);
  }
  for (int band = 0; band < bent.bands; ++band) {
    Leg before = leg;
    before.power *= band_hue(band, bent.bands) * (1.0f / static_cast<float>(bent.bands));
    onward.power = before.power;
    onward.wavelength = band_wavelength(band, bent.bands);
    bend(at, layers, dispersed_ior(bent.ior, bent.dispersion, onward.wavelength), before, onward);
  }
  return false;
}

bool PhotonPath::bend(const Meeting& at, Layers layers, double ior, const Leg& before, Leg onward) {
  const auto direction = refracted(before.ray.direction, layers.front().normal, ior);
  if (!direction) {
    // What no layer filters goes back, as heavy as what would have gone on.
    Leg back = before;
    back.weight = onward.weight;
    mirror(at, layers.front().normal, std::move(back));
    return true;
  }
  onward.ray.direction = *direction;
  onward.power *= layers.back().below;
  follow(onward);
  return false;
}

void PhotonPath::mirror(const Meeting& at, const Vec3& normal, Leg onward) {
  onward.ray = {at.point, normalized(mirrored(onward.ray.direction, normal, at.normal))};
  onward.passed = at.passes;
  onward.kind = reflected(onward.kind);
  follow(onward);
}

/// All layers reflect by the normal of the lowest that was seen.
void PhotonPath::mirror_layers(const Meeting& at, Layers layers, bool total_reflection,
                               const Leg& leg) {
  double clear = 1.0;  // of the layers above
  for (const Layer& layer : layers) {
    const float weight = static_cast<float>(leg.weight * clear) * layer.mirror.weight;
    clear = layer.clear;
    const Rgb& colour = layer.mirror.colour;
    if (colour.is_black()) continue;
    if (total_reflection && nearly_equal(layers.front().normal, layer.normal)) continue;
    Leg onward = leg;
    if (layer.finish->reflection_exponent != 1.0) {
      const double exponent = 1.0 / layer.finish->reflection_exponent;
      for (int c = 0; c < 3; ++c) {
        onward.power[c] = static_cast<float>(std::pow(leg.power[c], exponent));
      }
    }
    onward.power *= colour;
    onward.weight = weight * greatest(colour);
    mirror(at, layers.back().normal, onward);
  }
}

}  // namespace lentray::core
