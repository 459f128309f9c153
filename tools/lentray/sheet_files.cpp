#include "tools/lentray/sheet_files.h"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "tools/common/process.h"
#include "tools/common/progress_bar.h"
#include "tools/session/depth_text.h"
#include "tools/session/requests.h"
#include "tools/session/view_cameras.h"

namespace lentray::tool {
namespace {

using parser::RenderOptions;

bool is_told_already(const RenderOptions& o) {
  return has_views_of_one_sheet(o) && !is_first_view(o);
}

std::string scene_name(const RenderOptions& o) {
  return o.input == "-" ? std::string("standard input")
                        : std::filesystem::path(o.input).filename().string();
}

}  // namespace

std::string sheet_file(const RenderOptions& o, const std::string& file) {
  return file.empty() || file == "-" || has_views_of_one_sheet(o) ? file
                                                                  : parser::frame_path(o, file);
}

void check_depth(const CameraSetup& setup, const RenderOptions& o) {
  if (!setup.sheet) throw camera::CameraError("--depth needs a lens sheet: add Lenticular=On");
  if (o.views.quilt && !o.views.count) {
    throw camera::CameraError(
        "--depth reports on a lens sheet, and the lenses of a quilt's display are not known: leave "
        "Quilt out, or give Views=");
  }
}

bool say_depth(const CameraSetup& setup, const Session& session, const RenderOptions& o,
               const std::atomic<bool>& cancel) {
  if (is_told_already(o)) return true;
  std::optional<ProgressBar> bar;
  if (o.verbose) bar.emplace("Depth");
  const std::string title = scene_name(o), file = sheet_file(o, o.depth_view);
  const auto text = depth_text(session, setup, file.empty() ? nullptr : &title, o.threads, cancel,
                               bar ? &*bar : nullptr);
  bar.reset();
  if (!text) return false;
  // First what is kept.
  if (!text->drawing.empty()) write_whole(file, text->drawing);
  if (file != "-") std::fputs(text->report.c_str(), stdout);
  return true;
}

void write_view_cameras(const CameraSetup& setup, const RenderOptions& o) {
  if (o.view_cameras.empty()) return;
  if (!setup.sheet) {
    throw camera::CameraError(
        "View_Cameras= gives the cameras of views: add Lenticular=On, or Quilt=");
  }
  if (is_told_already(o)) return;
  const auto cameras = view_cameras(setup, camera_options(o), o.input == "-" ? "" : o.input);
  write_whole(sheet_file(o, o.view_cameras),
              cameras.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace lentray::tool
