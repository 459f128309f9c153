#include "tools/lentray/explain.h"

#include <sstream>

namespace lentray::tool {

std::string explanation(const core::Scene& scene, const CameraSetup& setup,
                        const std::vector<std::string>& not_rendered) {
  const core::Needs& needs = scene.needs();
  std::ostringstream out;
  out << "Camera: " << setup.camera().name() << ", " << setup.camera().width() << " x "
      << setup.camera().height() << " pixels\n";
  for (const std::string& line : setup.report) out << "  " << line << "\n";
  out << "Primitives:";
  for (const auto& [name, count] : needs.primitives) out << " " << count << " " << name;
  if (needs.primitives.empty()) out << " none";
  out << "\nLights: " << scene.lights().size() << "\n";
  const struct { const char* name; bool needed; } features[] = {
      {"infinite objects", needs.infinite_objects},
      {"CSG", needs.csg},
      {"clipping", needs.clipping},
      {"transparency", needs.transparency},
      {"coloured shadows", needs.transparent_shadows},
      {"refraction", needs.refraction},
      {"interiors", needs.interiors},
      {"reflection", needs.reflection},
      {"layered textures", needs.layered_textures},
      {"textures by place", needs.textures_by_place},
      {"interior textures", needs.interior_textures},
      {"highlights", needs.highlights},
      {"area lights", needs.area_lights},
      {"spot lights", needs.spot_lights},
      {"fading lights", needs.fading_lights},
      {"shadowless lights", needs.shadowless_lights},
      {"visibility flags", needs.visibility_flags},
      {"sky_sphere", needs.sky_sphere},
  };
  std::string yes, no;
  for (const auto& feature : features) {
    std::string& list = feature.needed ? yes : no;
    list += (list.empty() ? "" : ", ") + std::string(feature.name);
  }
  out << "Needed: " << (yes.empty() ? "nothing special" : yes) << "\n";
  out << "Not needed, and left out: " << (no.empty() ? "nothing" : no) << "\n";
  out << "Greatest useful trace level: " << needs.greatest_depth << "\n";
  if (!not_rendered.empty()) {
    out << "Not rendered yet:";
    for (const std::string& feature : not_rendered) out << " " << feature;
    out << "\n";
  }
  return out.str();
}

}  // namespace lentray::tool
