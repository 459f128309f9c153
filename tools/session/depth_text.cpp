#include "tools/session/depth_text.h"

#include "camera/depth_report.h"
#include "camera/depth_survey.h"
#include "core/pass/pass_list.h"
#include "core/render/frame.h"
#include "tools/session/depth_view.h"

namespace lentray::tool {

std::optional<DepthText> depth_text(const Session& session, const CameraSetup& setup,
                                    const std::string* title, int threads,
                                    const std::atomic<bool>& cancel, core::Progress* progress) {
  const camera::SceneProbe probe = session.probe();
  camera::DepthSurveyPass survey(*setup.sheet, probe);
  core::PassList passes;
  passes.add(survey);
  if (!passes.run({.threads = core::frame_threads({.threads = threads}),
                   .levels = session.scene().deepest(),
                   .cancel = &cancel,
                   .progress = progress})) {
    return std::nullopt;
  }
  const camera::DepthSurvey& seen = survey.result();
  DepthText out;
  out.report = "Depth\n";
  for (const std::string& line : setup.report) {
    for (const char* const start : {"In the sheet's plane", "Depth: ", "Jumps: ", "Sheet distance",
                                    "Depth_Budget", "The background"})
      if (line.starts_with(start)) out.report += "  " + line + "\n";
  }
  for (const std::string& line : camera::depth_report(*setup.sheet, setup.stand, seen)) {
    out.report += "  " + line + "\n";
  }
  if (title) out.drawing = depth_view(*setup.sheet, seen, *title);
  return out;
}

}  // namespace lentray::tool
