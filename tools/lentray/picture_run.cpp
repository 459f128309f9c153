#include "tools/lentray/picture_run.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <thread>

#include "camera/scene_probe.h"
#include "core/base/memory_limit.h"
#include "core/image/run_files.h"
#include "core/render/focal_blur.h"
#include "core/render/frame.h"
#include "core/scene/scene.h"
#include "core/trace/illumination.h"
#include "parser/compile/scene.h"
#include "parser/dump/scene_json.h"
#include "parser/read_scene.h"
#include "parser/source/build_error.h"
#include "parser/source/diagnostics.h"
#include "shadow/pixel_orders.h"
#include "shadow/report.h"
#include "shadow/run_log.h"
#include "shadow/run_meter.h"
#include "shadow/tester_factory.h"
#include "tools/common/json_text.h"
#include "tools/common/machine.h"
#include "tools/lentray/camera_place.h"
#include "tools/lentray/camera_setup.h"
#include "tools/lentray/depth_run.h"
#include "tools/lentray/explain.h"
#include "tools/lentray/identity.h"
#include "tools/lentray/output.h"
#include "tools/lentray/pass_file.h"
#include "tools/lentray/pass_run.h"
#include "tools/lentray/picture_file.h"
#include "tools/lentray/picture_journal.h"
#include "tools/lentray/quality.h"
#include "tools/lentray/radiosity_run.h"
#include "tools/lentray/ray_dump.h"
#include "tools/lentray/run_summary.h"
#include "tools/lentray/scene_disk.h"
#include "tools/lentray/view_cameras.h"

namespace lentray::tool {
namespace {

using parser::RenderOptions;
using Clock = std::chrono::steady_clock;

core::Antialiasing antialiasing(const RenderOptions& o) {
  core::Antialiasing out;
  if (o.antialias) out.method = o.sampling_method;
  out.threshold = o.antialias_threshold;
  out.depth = o.antialias_depth;
  if (o.antialias_grid > 0) {
    out.method = 3;
    out.depth = o.antialias_grid;
  }
  out.jitter = o.jitter ? o.jitter_amount : 0.0;
  out.gamma = o.antialias_gamma;
  return out;
}

/// What a band's row takes in memory, with a share for the encoder.
double bytes_a_row(const RenderOptions& o, std::uint32_t width) {
  return 1.25 * core::bytes_a_band_row(antialiasing(o), width);
}

/// What a run has become so far.
struct Run {
  const RenderOptions& options;
  const parser::FrameClock& clock;
  MessageForm& form;
  Warnings& warnings;
  const std::atomic<bool>& cancel;
  std::string output;  ///< where the picture goes; empty: nowhere
  core::FileType type = core::FileType::png;
  std::unique_ptr<core::Scene> scene{};
  std::vector<std::string> not_rendered{};
  std::vector<core::WatchedSlope> slopes{};
  CameraSetup camera{};
  core::Vec3 eye{};  ///< radiosity_eye() of its camera
  std::optional<RadiosityRun> radiosity{};
  DepthText depth{};    ///< with --depth
  Identity identity{};  ///< of this picture; its files once the scene is read
  shadow::RunReport report{};
};

/// The numbers of an order such as strips(4,32).
void check_order(const RenderOptions& o) {
  try {
    shadow::make_order(o.pixel_order, 1, 1);
  } catch (const std::invalid_argument& error) {
    throw parser::OptionError(error.what());
  }
}

/// Files are asked for before anything is read, so that no work is lost on them.
void check_output(const std::string& place, std::string_view what) {
  if (place.empty() || place == "-") return;
  core::check_writable(place);
  core::claim_output(place, what);
}

void check_outputs(Run& run) {
  const RenderOptions& o = run.options;
  judge_options(o);
  check_output(o.dump_rays, "--dump-rays");
  check_output(depth_file(o), "--depth-view");
  check_output(view_cameras_file(o), "View_Cameras");
  if (!renders(o)) return;
  if (o.shadow_log && o.statistics_file.empty()) {
    throw parser::OptionError("Shadow_Log goes into the statistics: name a Statistics_File");
  }
  const auto width = static_cast<std::uint32_t>(o.width);
  parser::check_picture_size(o.width, o.height, bytes_a_row(o, width), machine_memory());
  if (!o.statistics_file.empty())
    check_output(parser::frame_path(o, o.statistics_file), "Statistics_File");
  if (!o.dependencies_file.empty())
    check_output(parser::frame_path(o, o.dependencies_file), "Dependencies_File");
  if (!o.output_to_file) return;
  run.output = parser::output_path(o, run.type);
  check_output(run.output, "the picture");
}

parser::ParserOptions parser_options(const RenderOptions& o, const parser::FrameClock& clock) {
  parser::ParserOptions out;
  out.library_paths = o.library_paths;
  out.declares = o.declares;
  out.include_header = o.include_header;
  out.frame = clock;
  out.image_width = static_cast<int>(o.width);
  out.image_height = static_cast<int>(o.height);
  out.language_version = o.language_version;
  return out;
}

void connect(parser::Diagnostics& diagnostics, Run& run) {
  diagnostics.set_headings(run.form.headings());
  diagnostics.connect(parser::Stream::kWarning,
                      [&run](std::string_view text) { run.warnings.add(std::string(text)); });
  for (const auto stream :
       {parser::Stream::kDebug, parser::Stream::kRender, parser::Stream::kStatistics}) {
    diagnostics.connect(
        stream, [&run, stream](std::string_view text) { run.form.texts().write(stream, text); });
  }
}

/// With Strict=On nothing may be missing from the picture.
void refuse_if_strict(const RenderOptions& o, const std::vector<std::string>& not_rendered) {
  if (!o.strict || not_rendered.empty()) return;
  std::string list;
  for (const std::string& feature : not_rendered) list += (list.empty() ? "" : ", ") + feature;
  throw parser::OptionError("Strict=On: the picture would lack " + list);
}

/// --parse-only, --dump: text -> descriptions, checked as far as they can be without rendering.
void parse_alone(Run& run, const Picture& what) {
  const RenderOptions& o = run.options;
  const std::string& path = what.scene;
  SceneDisk disk(o, path, run.warnings);
  parser::SourceManager sources(disk.files());
  parser::Diagnostics diagnostics(sources);
  connect(diagnostics, run);
  const double before = cpu_seconds();
  parser::ParserOptions options = parser_options(o, run.clock);
  options.only_check = !o.dump;
  const parser::SceneDesc scene = parser::read_descriptions(path, sources, diagnostics, options);
  const double seconds = cpu_seconds() - before;
  const core::SceneParts parts =
      parser::build_scene(scene, diagnostics, {o.quality, o.alpha, o.overrides});
  if (what.is_read) what.is_read();
  run.warnings.say();
  refuse_if_strict(o, parts.not_rendered);
  if (o.dump) {
    std::puts(json_text(parser::scene_json(scene, sources), 1).c_str());
  }
  if (!o.verbose) return;
  std::fprintf(stderr, "Parsed: %zu objects and lights, %zu warnings, %.3f s\n",
               scene.objects.size() + scene.dropped, diagnostics.warnings().size(), seconds);
}

/// At most, and without antialiasing.
int rays_a_pixel(const parser::SceneDesc& scene) {
  if (!scene.camera || scene.camera->aperture == 0.0) return 1;
  return std::clamp(scene.camera->blur_samples, 1, core::FocalBlur::kMostRays);
}

/// The picture's files are known as soon as the scene is read, and those of one that cannot be read
/// as far as it was.
void write_dependencies(const Run& run, const SceneDisk& disk) {
  const RenderOptions& o = run.options;
  if (o.dependencies_file.empty()) return;
  nlohmann::json out{{"program", run.identity.program},
                     {"read", disk.seen()},
                     {"missing", disk.watched().missing()},
                     {"written", disk.watched().written()}};
  write_text_file(parser::frame_path(o, o.dependencies_file), json_text(std::move(out), 1) + "\n");
}

/// Blur_Samples holds where the scene has focal blur.
void override_blur(const RenderOptions& o, parser::SceneDesc& scene) {
  if (!o.overrides.blur_samples || !scene.camera || scene.camera->blur_samples <= 0) return;
  scene.camera->blur_samples = scene.camera->blur_samples_min = *o.overrides.blur_samples;
}

/// What is said of lens sheets names objects.
bool may_have_sheet(const RenderOptions& o, const parser::SceneDesc& scene) {
  return o.lenticular || o.views.quilt ||
         (scene.camera && scene.camera->kind == parser::CameraKind::kLenticular);
}

/// Text -> descriptions -> compiled scene and camera.
void compile_scene(Run& run, const std::string& path, SceneDisk& disk) {
  const RenderOptions& o = run.options;
  parser::SourceManager sources(disk.files());
  parser::Diagnostics diagnostics(sources);
  connect(diagnostics, run);

  const double before = cpu_seconds();
  parser::SceneDesc description =
      parser::read_descriptions(path, sources, diagnostics, parser_options(o, run.clock));
  const double parsed = cpu_seconds();
  run.report.parse_cpu_s = parsed - before;
  override_blur(o, description);

  parser::ObjectPlaces places;
  parser::BuildOptions build{o.quality, o.alpha, o.overrides};
  if (may_have_sheet(o, description)) build.places = &places;
  core::SceneParts parts = parser::build_scene(description, diagnostics, build);
  description.objects = {};  // their memory is used again by what is built next
  run.not_rendered = parts.not_rendered;
  run.slopes = parts.slopes;
  reduce(parts, o.quality);
  core::CompileOptions compile;
  if (o.accelerator == "grid") compile.accelerator = core::Accelerator::kGrid;
  if (o.accelerator == "list") compile.accelerator = core::Accelerator::kList;
  compile.general_path = !o.specialised_paths;
  if (o.light_buffer) {
    compile.light_buffer_pixels = static_cast<std::uint64_t>(o.width) *
                                  static_cast<std::uint64_t>(o.height) *
                                  static_cast<std::uint64_t>(rays_a_pixel(description));
  }
  run.scene = std::make_unique<core::Scene>(std::move(parts), compile);
  run.report.compile_cpu_s = cpu_seconds() - parsed;

  const auto textures = parser::texture_settings(description, run.scene->settings(),
                                                 {.quality = o.quality, .overrides = o.overrides});
  const auto probe = camera::probe_of(*run.scene, [&](const camera::ProbeHit& hit) {
    const parser::ObjectPlace* const place = places.place_of(hit.id, hit.whole);
    return place ? parser::object_name(*place, sources) : hit.object;
  });
  places.sort_parts();
  try {
    const auto request =
        parser::camera_request(description.camera.value_or(parser::CameraDesc{}), textures);
    run.eye = radiosity_eye(request);
    run.camera = make_camera(request, o, probe);
  } catch (const camera::CameraError& error) {
    fail_with_place(error, description.camera, o, diagnostics);
  } catch (const parser::BuildError& error) {  // of a bokeh or a normal
    diagnostics.fail(error.where(), error.what());
  }
  for (std::string& text : run.camera.warnings) run.warnings.tell(text);
  run.camera.warnings.clear();
  if (o.depth) run.depth = depth_of(run.camera, probe, o, run.scene->deepest(), run.cancel);
}

void read_scene(Run& run, const std::string& path) {
  SceneDisk disk(run.options, path, run.warnings);
  try {
    compile_scene(run, path, disk);
  } catch (...) {
    write_dependencies(run, disk);
    throw;
  }
  write_dependencies(run, disk);
  for (const auto& [file, sum] : disk.seen()) run.identity.files[file == path ? "" : file] = sum;
}

/// The picture's size, and the rows that are made at a time.
core::FrameShape shape_of(Run& run) {
  const RenderOptions& o = run.options;
  const camera::Camera& camera = run.camera.camera();
  core::FrameShape shape{camera.width(), camera.height(), o.band_height};
  const double limit = o.max_memory > 0.0 ? o.max_memory : 0.5 * machine_memory();
  const double row = bytes_a_row(o, shape.width);
  if (o.band_height == 0) {
    // In steps, so that the same run gets the same bands.
    constexpr double kStep = 16.0 * 1024 * 1024;
    const double scene = std::ceil(core::resident_bytes() / kStep) * kStep;
    shape.band_height =
        shadow::band_height(o.pixel_order, shape.width, shape.height, row, limit - scene);
    if (shape.band_height * row > limit - scene) {
      throw parser::OptionError(
          "Max_Memory is less than the scene and a row of the picture take; that is " +
          core::memory_text(scene + row));
    }
  }
  // Tiles of antialiasing are not cut.
  const std::uint32_t grain = core::Film::rows_together(antialiasing(o));
  shape.band_height = (std::min(shape.band_height, shape.height) + grain - 1) / grain * grain;
  run.report.band_height = shape.band_height;
  run.report.bands = (shape.height + shape.band_height - 1) / shape.band_height;
  return shape;
}

/// How many of `size` columns or rows lie before an edge; what is below 1 is a part of them all.
/// As stock: a start of 1 is the first column, an end of 1 the whole width; and 0.9 is the float
/// next to it, which leaves a column less than a reader might think.
std::uint32_t columns_before(double given, std::uint32_t size, bool is_start, const char* name) {
  const double edge = static_cast<float>(given);
  const bool is_part = is_start ? edge < 1.0 : edge <= 1.0;
  const double before =
      is_part ? std::floor(edge * size) : std::floor(edge) - (is_start ? 1.0 : 0.0);
  if (before > size || (is_start && before >= size)) {
    throw parser::OptionError(std::string(name) + " lies beyond the picture's " +
                              std::to_string(size));
  }
  return static_cast<std::uint32_t>(before);
}

/// The pixels that are rendered, if not all.
std::optional<core::PixelRegion> region_of(const RenderOptions& o, const core::FrameShape& shape) {
  if (!o.start_column && !o.end_column && !o.start_row && !o.end_row) return std::nullopt;
  core::PixelRegion region;
  region.left = columns_before(o.start_column.value_or(1.0), shape.width, true, "Start_Column");
  region.top = columns_before(o.start_row.value_or(1.0), shape.height, true, "Start_Row");
  region.right = columns_before(o.end_column.value_or(1.0), shape.width, false, "End_Column");
  region.bottom = columns_before(o.end_row.value_or(1.0), shape.height, false, "End_Row");
  if (region.left >= region.right) throw parser::OptionError("Start_Column lies behind End_Column");
  if (region.top >= region.bottom) throw parser::OptionError("Start_Row lies behind End_Row");
  return region;
}

std::uint64_t pixels_of(const std::optional<core::PixelRegion>& region,
                        const core::FrameShape& shape) {
  if (!region) return std::uint64_t{shape.width} * shape.height;
  return std::uint64_t{region->right - region->left} * (region->bottom - region->top);
}

/// What the picture told about the numbers it was given.
void report_slopes(Run& run) {
  for (const core::WatchedSlope& slope : run.slopes) {
    const std::string advice = slope.watch->advice();
    if (!advice.empty()) run.warnings.add(slope.heading + advice);
  }
  if (const std::uint64_t cut = run.report.counters.cut_rays; cut > 0) {
    run.warnings.tell(std::to_string(cut) +
                      " rays met more surfaces behind one another "
                      "than there is memory for, and ended there");
  }
}

bool goes_to_file(const Run& run) {
  std::error_code error;
  const auto status = std::filesystem::status(run.output, error);
  return !run.output.empty() && run.output != "-" &&
         (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status));
}

/// With +C. True if the picture is there already; throws if what was begun is of something else.
bool is_there_already(Run& run, const std::string& scene) {
  if (!run.options.continues || !goes_to_file(run)) return false;
  const bool exists = std::filesystem::exists(run.output);
  const auto earlier = PictureJournal::earlier(run.output);
  if (earlier) {
    Identity now = run.identity;
    now.files = earlier->identity.files;
    std::string why = difference(earlier->identity, now);
    if (why.empty() && run.options.input != "-")
      why = difference_of_files(earlier->identity, scene);
    if (!why.empty()) {
      throw parser::OptionError("'" + run.output + "' cannot be gone on with: " + why +
                                (earlier->is_finished ? " since the frame was made" : "") +
                                " (without +C everything is begun anew)");
    }
  }
  if (!exists || (earlier && !earlier->is_finished)) return false;
  run.form.keep_picture(run.output);
  return true;
}

void tell_of_file(Run& run, const std::string& file) {
  run.form.texts().write(parser::Stream::kRender,
                         "What is done is kept in '" + file + "': +C goes on with it\n");
}

void tell_of_journal(Run& run, PictureJournal& journal) {
  if (journal.keep()) tell_of_file(run, journal_path(run.output));
}

/// False if the run was cancelled.
bool render(Run& run, const std::atomic<bool>& cancel, bool is_frame) {
  const RenderOptions& o = run.options;
  const camera::Camera& camera = run.camera.camera();
  // One view of a sheet is an ordinary picture.
  const camera::LensSheet* lenses =
      run.camera.sheet && !run.camera.view ? &run.camera.sheet->sheet() : nullptr;
  const core::FrameShape shape = shape_of(run);
  auto testers = shadowless_tester(o.quality);
  if (!testers) testers = shadow::make_tester_factory(o.shadow_cache);
  const shadow::RunLog log(*testers);
  const core::ShadowTesterFactory* asked = testers.get();
  if (o.shadow_log) asked = &log;
  const shadow::RunMeter meter(*asked,
                               lenses ? static_cast<std::uint32_t>(lenses->lens().pixels) : 0);
  if (shadow::follows_shadows(o.pixel_order)) asked = &meter;
  std::optional<PictureJournal> journal;
  if (goes_to_file(run)) {
    journal.emplace(run.output, shape.width, shape.height, run.identity);
    if (o.continues) journal->go_on();
  }
  core::FrameOptions frame;
  frame.ledger = journal ? &*journal : nullptr;
  frame.antialiasing = antialiasing(o);
  frame.angles = o.antialias_angles;
  frame.region = region_of(o, shape);
  const core::FilmColumns columns = core::traced_columns(camera, shape, frame);
  const auto orders =
      shadow::make_band_orders(o.pixel_order, {columns.left, columns.right}, lenses, &meter);
  frame.threads = o.threads;
  frame.count_tests = !o.statistics_file.empty() && o.count_tests;
  frame.alpha = o.alpha;
  frame.cancel = &cancel;
  run.report.threads = o.threads > 0
                           ? o.threads
                           : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  run.report.tests_counted = frame.count_tests;
  run.report.width = shape.width;
  run.report.height = shape.height;
  run.form.begin_rendering(o, run.report, pixels_of(frame.region, shape));
  std::unique_ptr<core::Progress> bar;
  if (o.verbose) bar = run.form.progress();
  core::PassList passes;
  core::Illumination light;  // that passes leave
  run.radiosity.emplace(*run.scene, run.camera, run.eye, *testers, light);
  if (run.radiosity->pass()) passes.add(*run.radiosity->pass());
  const auto film_work = static_cast<double>(pixels_of(frame.region, shape));
  const std::string passes_of = journal ? run.output : "";
  const PassesDone done =
      run_passes(passes, {o, *run.scene, passes_of, run.identity, cancel, bar.get(), film_work});
  if (!done.trouble.empty()) run.warnings.tell(done.trouble);
  if (!done.kept_in.empty()) tell_of_file(run, done.kept_in);
  if (!done.is_whole) return false;
  if (std::string warning = run.radiosity->warning(light); !warning.empty()) {
    run.warnings.tell(warning);
  }
  run.report.passes = passes.reports();
  if (!passes.is_empty()) frame.illumination = &light;
  const double before = cpu_seconds();
  std::optional<PictureFile> picture(std::in_place, run.output, run.type, o, run.scene->settings(),
                                     run.camera, journal ? &*journal : nullptr);
  bool is_cut_off = false;
  try {
    run.report.counters = core::render_frame(*run.scene, camera, shape, *orders, *asked, frame,
                                             *picture, passes.film_progress());
    bar.reset();
    is_cut_off = cancel.load();
    if (!is_cut_off) picture->finish();
  } catch (const core::ImageError&) {
    bar.reset();
    picture.reset();  // what was kept last finds the room of its file
    if (journal) tell_of_journal(run, *journal);
    throw;
  }
  if (is_cut_off) {
    if (journal) tell_of_journal(run, *journal);
    return false;
  }
  run.report.shadow_log = log.lights();
  if (journal) journal->finish(is_frame);
  if (journal && !passes.is_empty()) PassFile::forget(run.output);
  if (journal && !journal->trouble().empty()) run.warnings.tell(journal->trouble());
  run.report.write_cpu_s = picture->cpu_seconds();
  run.report.render_cpu_s = cpu_seconds() - before - run.report.write_cpu_s;
  return true;
}

/// The program ends soon, and the system takes its memory back at once: nobody need visit the scene's
/// parts first.
void leave_to_system(std::unique_ptr<core::Scene> scene) {
  [[maybe_unused]] static const core::Scene* left = nullptr;  // reached until the end
  left = scene.release();
}

}  // namespace

bool renders(const RenderOptions& o) {
  return !o.explain && !o.depth && !o.parse_only && !o.dump && o.dump_rays.empty();
}

Status run_picture(const Picture& what, const std::atomic<bool>& cancel, MessageForm& form,
                   Warnings& warnings) {
  const auto start = Clock::now();
  const RenderOptions& options = what.options;
  Run run{options, what.clock, form, warnings, cancel, {}};
  core::limit_memory(options.max_memory > 0.0 ? options.max_memory : machine_memory());
  // Building the scene takes no more threads than rendering it.
  std::optional<tbb::global_control> threads;
  if (options.threads > 0) {
    threads.emplace(tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(options.threads));
  }
  check_order(options);
  check_outputs(run);
  if (options.parse_only || options.dump) {
    parse_alone(run, what);
    return kDone;
  }
  run.identity = identity_of(options, what.clock);
  if (renders(options) && is_there_already(run, what.scene)) return kDone;
  if (renders(options)) form.begin_reading(options, what.clock, run.output);
  read_scene(run, what.scene);
  check_outputs(run);  // now that all inputs are known
  if (what.is_read) what.is_read();
  warnings.say();
  refuse_if_strict(options, run.not_rendered);
  write_view_cameras(run.camera, options);
  if (options.explain) {
    std::fputs(explanation(*run.scene, run.camera, run.not_rendered).c_str(), stdout);
  }
  if (options.depth && cancel) return kAborted;
  if (options.depth) say_depth(run.depth, depth_file(options));
  if (options.explain || options.depth) return kDone;
  for (const std::string& line : run.camera.report) {
    form.texts().write(parser::Stream::kRender, line + "\n");
  }
  if (!options.dump_rays.empty()) {
    dump_rays(run.camera.camera(), options.dump_rays);
    return kDone;
  }
  const camera::Camera& camera = run.camera.camera();
  parser::check_picture_size(camera.width(), camera.height(), bytes_a_row(options, camera.width()),
                             machine_memory());
  if (!render(run, cancel, what.is_frame)) return kAborted;
  report_slopes(run);
  warnings.say();
  run.report.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  run.report.peak_bytes = peak_bytes();
  if (!options.statistics_file.empty()) {
    nlohmann::json all = statistics(run.report, options, run.camera, run.scene->settings());
    all["not_rendered"] = run.not_rendered;
    if (run.scene->settings().radiosity) all["radiosity"] = run.radiosity->json();
    write_text_file(parser::frame_path(options, options.statistics_file),
                    json_text(std::move(all), 2) + "\n");
  }
  if (const std::string samples = run.radiosity->text(); !samples.empty()) {
    form.texts().write(parser::Stream::kStatistics, samples);
  }
  form.end_picture(options, run.report, run.output);
  if (what.is_last) leave_to_system(std::move(run.scene));
  return kDone;
}

}  // namespace lentray::tool
