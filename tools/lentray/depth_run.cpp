#include "tools/lentray/depth_run.h"

#include <cstdio>
#include <filesystem>
#include <optional>

#include "camera/depth_report.h"
#include "camera/depth_survey.h"
#include "core/pass/pass_list.h"
#include "core/render/frame.h"
#include "tools/lentray/depth_view.h"
#include "tools/lentray/output.h"
#include "tools/lentray/progress_bar.h"

namespace lentray::tool {
namespace {

/// Pictures of views of one scene: all have the same sheet.
bool is_of_views(const parser::RenderOptions& o) {
  return o.animation.views.count > 0 && !o.animation.views.clocks;
}

}  // namespace

std::string depth_file(const parser::RenderOptions& options) {
  const std::string& file = options.depth_view;
  return file.empty() || file == "-" || is_of_views(options) ? file
                                                             : parser::frame_path(options, file);
}

DepthText depth_of(const CameraSetup& setup, const camera::SceneProbe& probe,
                   const parser::RenderOptions& options, std::size_t levels,
                   const std::atomic<bool>& cancel) {
  if (!setup.sheet) throw camera::CameraError("--depth needs a lens sheet: add Lenticular=On");
  if (options.views.quilt && !options.views.count) {
    throw camera::CameraError(
        "--depth tells of a lens sheet, and the lenses of a quilt's display are not known: leave "
        "Quilt "
        "out, or give Views=");
  }
  if (is_of_views(options) && parser::rendered_view(options).value_or(0) > 0) return {};
  camera::DepthSurveyPass survey(*setup.sheet, probe);
  core::PassList passes;
  passes.add(survey);
  std::optional<ProgressBar> bar;
  if (options.verbose) bar.emplace("Depth");
  if (!passes.run({.threads = core::frame_threads({.threads = options.threads}),
                   .levels = levels,
                   .cancel = &cancel,
                   .progress = bar ? &*bar : nullptr})) {
    return {};
  }
  bar.reset();
  const camera::DepthSurvey& seen = survey.result();
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
  if (options.depth_view.empty()) return out;
  const std::string title = options.input == "-"
                                ? std::string("standard input")
                                : std::filesystem::path(options.input).filename().string();
  out.drawing = depth_view(*setup.sheet, seen, title);
  return out;
}

void say_depth(const DepthText& text, const std::string& file) {
  // First what is kept.
  if (!text.drawing.empty()) write_text_file(file, text.drawing);
  if (file != "-") std::fputs(text.report.c_str(), stdout);
}

}  // namespace lentray::tool
