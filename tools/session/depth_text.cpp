#include "tools/session/depth_text.h"

#include "camera/depth_report.h"
#include "tools/session/depth_view.h"

namespace lentray::tool {

DepthText depth_text(const CameraSetup& setup, const camera::DepthSurvey& seen,
                     const std::string* title) {
  DepthText out;
  out.report = "Depth\n";
  for (const std::string& line : setup.report) {
    if (line.starts_with("Sheet distance") || line.starts_with("Depth_Budget") ||
        line.starts_with("The background")) {
      out.report += "  " + line + "\n";
    }
  }
  for (const std::string& line : camera::depth_report(*setup.sheet, setup.stand, seen)) {
    out.report += "  " + line + "\n";
  }
  if (title) out.drawing = depth_view(*setup.sheet, seen, *title);
  return out;
}

}  // namespace lentray::tool
