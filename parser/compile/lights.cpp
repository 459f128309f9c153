#include "parser/compile/lights.h"

#include <cmath>
#include <numbers>

namespace lentray::parser {
namespace {

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180.0); }

}  // namespace

core::Light build_light(const LightDesc& light, const core::Transform& to_world) {
  core::Light out;
  out.position = to_world.point(light.position);
  out.point_at = to_world.point(light.point_at);
  const core::Vec3 way = out.point_at - out.position;
  out.direction = length(way) > 1e-10 ? normalized(way) : way;
  out.colour = light.colour.rgb;
  out.parallel = light.parallel;
  out.shadowless = light.kind == LightKind::kShadowless;
  if (light.kind == LightKind::kSpot) {
    out.kind = core::Light::Kind::kSpot;
    out.radius = cosine(light.radius);
    out.falloff = cosine(light.falloff);
  } else if (light.kind == LightKind::kCylinder) {
    out.kind = core::Light::Kind::kCylinder;
    out.radius = light.radius;
    out.falloff = light.falloff;
  }
  out.tightness = light.tightness;
  out.fade_distance = light.fade_distance;
  out.fade_power = light.fade_power;
  out.lights_media = light.media_interaction;
  out.dimmed_by_air = light.media_interaction && light.media_attenuation;
  out.has_area = light.has_area;
  if (light.has_area) {
    out.area.axis1 = to_world.vector(light.axis1);
    out.area.axis2 = to_world.vector(light.axis2);
    out.area.size1 = light.size1;
    out.area.size2 = light.size2;
    out.area.adaptive = light.has_adaptive ? light.adaptive : -1;
    out.area.jitter = light.jitter;
    out.area.circular = light.circular;
    out.area.orient = light.orient;
    out.area.area_illumination = light.area_illumination;
  }
  out.photon_reflection = light.photons.reflection;
  out.photon_refraction = light.photons.refraction;
  out.photon_area = light.photons.area_light;
  return out;
}

}  // namespace lentray::parser
