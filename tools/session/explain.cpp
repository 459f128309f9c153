#include "tools/session/explain.h"

#include <sstream>

#include "core/scene/explain.h"
#include "tools/session/radiosity_lattice.h"

namespace lentray::tool {

std::string explanation(const core::Scene& scene, const CameraSetup& setup,
                        const std::vector<std::string>& not_rendered) {
  std::ostringstream out;
  out << "Camera\n  " << setup.camera().name() << ", " << setup.camera().width() << " x "
      << setup.camera().height() << " pixels\n";
  for (const std::string& line : setup.report) out << "  " << line << "\n";
  out << core::explain(scene);
  if (scene.settings().radiosity) out << radiosity_plan(scene, lattice_of(setup));
  if (!not_rendered.empty()) {
    out << "Missing from the picture\n";
    for (const std::string& feature : not_rendered) out << "  " << feature << "\n";
  }
  return out.str();
}

}  // namespace lentray::tool
