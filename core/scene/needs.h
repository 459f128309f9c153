// What a scene needs of the kernel, found once when it is compiled: the kernel leaves out what it does
// not, and `lentray --explain` prints it. Features are conservative: `false`
// means certainly absent.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace lentray::core {

struct Needs {
  std::map<std::string, std::size_t> primitives;  ///< by SDL keyword, after splitting unions
  bool infinite_objects = false;                  ///< set by the scene, whose hierarchy knows
  bool csg = false;
  bool clipping = false;
  bool transparency = false;         ///< any texture with filter or transmit
  bool transparent_shadows = false;  ///< any shadow caster that is not opaque
  bool shadows_begin_anew =
      false;                ///< of these any with a shape that does not find all crossings at once
  bool refraction = false;  ///< any interior with ior != 1 that can be seen through
  bool dispersion = false;
  bool interiors = false;
  bool reflection = false;
  bool layered_textures = false, textures_by_place = false, interior_textures = false;
  bool subsurface = false;  ///< any finish with subsurface light
  bool highlights = false;  ///< phong or specular
  bool area_lights = false, spot_lights = false, fading_lights = false, shadowless_lights = false;
  bool area_illumination = false, projected_lights = false;
  bool visibility_flags = false;  ///< no_image, no_reflection, no_shadow
  bool sky_sphere = false;
  bool atmosphere = false;   ///< fog, rainbows, media of the air
  bool media = false;        ///< in the air or in interiors
  bool dimming_air = false;  ///< fog or media of the air dim a light on its way (media_attenuation)
  int greatest_depth = 1;    ///< deepest useful trace level (1: camera rays alone)
};

/// All features, by the names that --explain gives them.
inline constexpr std::pair<std::string_view, bool Needs::*> kNeededFeatures[] = {
    {"infinite objects", &Needs::infinite_objects},
    {"constructive solid geometry", &Needs::csg},
    {"clipping", &Needs::clipping},
    {"transparency", &Needs::transparency},
    {"transparent shadows", &Needs::transparent_shadows},
    {"shadows that begin anew behind each surface", &Needs::shadows_begin_anew},
    {"refraction", &Needs::refraction},
    {"dispersion", &Needs::dispersion},
    {"interiors", &Needs::interiors},
    {"reflection", &Needs::reflection},
    {"layered textures", &Needs::layered_textures},
    {"textures by place", &Needs::textures_by_place},
    {"interior textures", &Needs::interior_textures},
    {"subsurface light", &Needs::subsurface},
    {"highlights", &Needs::highlights},
    {"area lights", &Needs::area_lights},
    {"area illumination", &Needs::area_illumination},
    {"lights projected through objects", &Needs::projected_lights},
    {"spot and cylindrical lights", &Needs::spot_lights},
    {"fading lights", &Needs::fading_lights},
    {"shadowless lights", &Needs::shadowless_lights},
    {"no_image, no_reflection, no_shadow", &Needs::visibility_flags},
    {"sky sphere", &Needs::sky_sphere},
    {"fog, rainbows or media of the air", &Needs::atmosphere},
    {"media", &Needs::media},
    {"air that dims lights", &Needs::dimming_air},
};

}  // namespace lentray::core
