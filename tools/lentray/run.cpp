#include "tools/lentray/run.h"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "camera/scene_probe.h"
#include "core/render/frame.h"
#include "core/scene/scene.h"
#include "parser/build/scene.h"
#include "parser/diagnostics.h"
#include "parser/grammar/scene.h"
#include "parser/parser.h"
#include "shadow/pixel_orders.h"
#include "shadow/report.h"
#include "shadow/tester_factory.h"
#include "tools/lentray/camera_setup.h"
#include "tools/lentray/explain.h"
#include "tools/lentray/output.h"
#include "tools/lentray/progress_bar.h"
#include "tools/lentray/quality.h"
#include "tools/lentray/ray_dump.h"
#include "tools/lentray/scene_file.h"

namespace lentray::tool {
namespace {

using parser::RenderOptions;
using Clock = std::chrono::steady_clock;

/// Seconds of processor time that this process has used, over all threads.
double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return t.tv_sec + t.tv_usec * 1e-6; };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::uint64_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

double machine_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
  if (pages <= 0 || size <= 0) return std::numeric_limits<double>::infinity();
  return static_cast<double>(pages) * static_cast<double>(size);
}

/// What a run has become so far.
struct Run {
  const RenderOptions& options;
  std::vector<std::string>& warnings;
  std::string output;                  ///< where the picture goes; empty: nowhere
  parser::OutputType type = parser::OutputType::kPng;
  std::unique_ptr<core::Scene> scene{};
  std::vector<std::string> not_rendered{};
  CameraSetup camera{};
  shadow::RunReport report{};
};

/// Files are asked for before anything is read, so that no work is lost on them.
void check_outputs(Run& run) {
  const RenderOptions& o = run.options;
  const bool renders = !o.explain && o.dump_rays.empty();
  if (!o.dump_rays.empty() && o.dump_rays != "-") core::check_writable(o.dump_rays);
  if (!renders) return;
  parser::check_picture_size(o.width, o.view ? 8 : o.height, machine_memory());
  if (!o.statistics_file.empty()) core::check_writable(o.statistics_file);
  if (!o.output_to_file) return;
  run.output = parser::output_path(o, run.type);
  if (run.output != "-") core::check_writable(run.output);
}

parser::ParserOptions parser_options(const RenderOptions& o) {
  parser::ParserOptions out;
  out.library_paths = o.library_paths;
  out.declares = o.declares;
  out.clock = o.clock;
  out.image_width = static_cast<int>(o.width);
  out.image_height = static_cast<int>(o.height);
  out.language_version = o.language_version;
  return out;
}

/// Text -> descriptions -> compiled scene and camera.
void read_scene(Run& run, const std::string& path) {
  const RenderOptions& o = run.options;
  parser::SourceManager sources;
  parser::Diagnostics diagnostics(sources);
  diagnostics.connect(parser::Stream::kWarning, [&run](std::string_view text) {
    run.warnings.emplace_back(text);
  });
  if (!o.debug_console) diagnostics.connect(parser::Stream::kDebug, {});
  if (!o.render_console) diagnostics.connect(parser::Stream::kRender, {});
  if (!o.statistic_console) diagnostics.connect(parser::Stream::kStatistics, {});

  const double before = cpu_seconds();
  parser::Grammar grammar;
  parser::Parser parser(sources, diagnostics, parser_options(o), grammar);
  parser.open(path);
  const parser::SceneDesc description = parser::parse_scene(parser, grammar);
  const double parsed = cpu_seconds();
  run.report.parse_cpu_s = parsed - before;

  core::SceneParts parts = parser::build_scene(description, diagnostics, {o.quality});
  run.not_rendered = parts.not_rendered;
  reduce(parts, o.quality);
  core::CompileOptions compile;
  compile.linear_search = o.accelerator == "list";
  if (o.light_buffer) compile.light_buffer_pixels = std::uint64_t{o.width} * o.height;
  run.scene = std::make_unique<core::Scene>(std::move(parts), compile);
  run.report.compile_cpu_s = cpu_seconds() - parsed;

  const auto request = parser::camera_request(description.camera.value_or(parser::CameraDesc{}));
  run.camera = make_camera(request, o, camera::probe_of(*run.scene));
  for (std::string& text : run.camera.warnings) run.warnings.push_back("warning: " + text);
  run.camera.warnings.clear();
}

shadow::LensReport lens_report(const camera::Lenticular& sheet) {
  shadow::LensReport out;
  out.parameters = sheet.sheet().lens();
  out.lenses = sheet.sheet().lenses();
  out.views = sheet.sheet().views();
  out.lens_front = sheet.placement().front;
  out.scene_units_per_mm = sheet.scale();
  out.sheet_width = sheet.sheet().sheet_width();
  out.sheet_height = sheet.placement().height / sheet.scale();
  return out;
}

void write_statistics(Run& run) {
  const RenderOptions& o = run.options;
  run.report.scene = o.input;
  run.report.pixel_order = o.pixel_order;
  run.report.shadow_cache = o.shadow_cache;
  run.report.accelerator = o.accelerator;
  run.report.peak_bytes = peak_bytes();
  if (run.camera.sheet) run.report.lens = lens_report(*run.camera.sheet);
  nlohmann::json statistics = shadow::to_json(run.report);
  if (run.camera.sheet) statistics["lens"].update(lens_json(run.camera.camera()));
  write_text_file(o.statistics_file, statistics.dump(2) + "\n");
}

/// False if the run was cancelled.
bool render(Run& run, const std::atomic<bool>& cancel, core::Image& image) {
  const RenderOptions& o = run.options;
  const camera::Camera& camera = run.camera.camera();
  const auto order = shadow::make_order(o.pixel_order, camera.width(), camera.height());
  auto testers = shadowless_tester(o.quality);
  if (!testers) testers = shadow::make_tester_factory(o.shadow_cache);
  core::FrameOptions frame;
  frame.threads = o.threads;
  frame.count_tests = !o.statistics_file.empty();
  frame.alpha = o.alpha;
  frame.cancel = &cancel;
  run.report.threads =
      o.threads > 0 ? o.threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  run.report.tests_counted = frame.count_tests;
  run.report.width = camera.width();
  run.report.height = camera.height();
  std::optional<ProgressBar> bar;
  if (o.verbose) bar.emplace("Rendering");
  const double before = cpu_seconds();
  run.report.counters = core::render_frame(*run.scene, camera, *order, *testers, frame, image,
                                           bar ? &*bar : nullptr);
  run.report.render_cpu_s = cpu_seconds() - before;
  return !cancel.load();
}

}  // namespace

Status run(const RenderOptions& options, const std::atomic<bool>& cancel,
           std::vector<std::string>& warnings) {
  const auto start = Clock::now();
  Run run{options, warnings, {}};
  const SceneFile file(options);
  check_outputs(run);
  read_scene(run, file.path());
  if (options.explain) {
    std::fputs(explanation(*run.scene, run.camera, run.not_rendered).c_str(), stdout);
    return kDone;
  }
  if (options.render_console) {
    for (const std::string& line : run.camera.report) std::fprintf(stderr, "%s\n", line.c_str());
  }
  if (!options.dump_rays.empty()) {
    dump_rays(run.camera.camera(), options.dump_rays);
    return kDone;
  }
  const camera::Camera& camera = run.camera.camera();
  parser::check_picture_size(camera.width(), camera.height(), machine_memory());
  core::Image image(camera.width(), camera.height());
  if (!render(run, cancel, image)) return kAborted;
  if (!run.output.empty()) {
    write_picture(image, run.output, run.type, options, run.scene->settings(), run.camera);
  }
  run.report.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  if (!options.statistics_file.empty()) write_statistics(run);
  if (options.statistic_console && options.verbose) {
    std::fprintf(stderr, "%s: %u x %u pixels in %.2f s\n",
                 run.output.empty() ? "No file" : run.output.c_str(), camera.width(),
                 camera.height(), run.report.wall_s);
  }
  return kDone;
}

}  // namespace lentray::tool
