#include "parser/compile/atmosphere.h"

#include <cmath>
#include <numbers>

#include "core/base/tiny.h"
#include "core/pattern/single.h"
#include "parser/descriptions/maps.h"

namespace lentray::parser {
namespace {

using core::kTiny;
using core::single;

constexpr double kRadians = std::numbers::pi / 180.0;

core::Fog build_fog(const FogDesc& desc, int noise_generator) {
  core::Fog fog;
  fog.distance = desc.distance;
  fog.colour = desc.colour;
  fog.on_ground = desc.type == 2;
  fog.offset = desc.fog_offset;
  fog.altitude = desc.fog_alt;
  fog.up = normalized(desc.up);
  fog.turbulence_depth = desc.turb_depth;
  fog.noise_generator = noise_generator;
  if (desc.turbulence) {
    fog.turbulence =
        core::Turbulence{*desc.turbulence, desc.octaves, single(desc.lambda), single(desc.omega)};
  }
  return fog;
}

core::Rainbow build_rainbow(const RainbowDesc& desc) {
  std::vector<std::pair<double, core::Colour>> colours;
  for (const auto& entry : desc.colour_map->entries) colours.emplace_back(entry.value, entry.item);
  const core::Vec3 antisolar = normalized(desc.direction);
  const core::Vec3 right = normalized(cross(normalized(desc.up), antisolar));
  return {antisolar,
          right,
          normalized(cross(antisolar, right)),
          (desc.angle - 0.5 * desc.width) * kRadians,
          desc.width * kRadians,
          0.5 * desc.arc_angle * kRadians,
          0.5 * desc.falloff_angle.value_or(desc.arc_angle) * kRadians,
          desc.distance,
          desc.jitter,
          core::BlendMap(std::move(colours))};
}

}  // namespace

core::Atmosphere build_atmosphere(const SceneDesc& scene, int noise_generator) {
  core::Atmosphere air;
  for (const FogDesc& fog : scene.fogs) {
    if (std::fabs(fog.distance) > kTiny) air.fogs.push_back(build_fog(fog, noise_generator));
  }
  for (const RainbowDesc& rainbow : scene.rainbows) {
    if (rainbow.colour_map && rainbow.distance != 0.0 && rainbow.width != 0.0) {
      air.rainbows.push_back(build_rainbow(rainbow));
    }
  }
  return air;
}

}  // namespace lentray::parser
