#include "tools/lentray/picture_run.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/base/deep_threads.h"
#include "core/base/joined.h"
#include "core/image/run_files.h"
#include "core/image/spare_room.h"
#include "parser/dump/scene_json.h"
#include "parser/files/watched_files.h"
#include "parser/options/create_ini.h"
#include "parser/read_scene.h"
#include "parser/restrictions/run_rules.h"
#include "parser/source/cancelled.h"
#include "shadow/pixel_orders.h"
#include "tools/common/json_text.h"
#include "tools/common/machine.h"
#include "tools/common/process.h"
#include "tools/lentray/camera_place.h"
#include "tools/lentray/frame_depths.h"
#include "tools/lentray/sheet_files.h"
#include "tools/session/explain.h"
#include "tools/session/going_on.h"
#include "tools/session/identity.h"
#include "tools/session/pass_file.h"
#include "tools/session/picture_file.h"
#include "tools/session/picture_journal.h"
#include "tools/session/radiosity_store.h"
#include "tools/session/ray_dump.h"
#include "tools/session/requests.h"
#include "tools/session/scene_disk.h"
#include "tools/session/session.h"
#include "tools/session/statistics.h"

namespace lentray::tool {

struct SceneInUse {
  SceneInUse(const parser::RenderOptions& options, const std::string& path) : disk(options, path) {}
  SceneDisk disk;
  std::optional<Session> session{};
  std::optional<CameraSetup> sheet{};  ///< that views are of
};

namespace {

using parser::RenderOptions;
using Clock = std::chrono::steady_clock;

/// What a run has become so far.
struct Run {
  const RenderOptions& options;
  const parser::FrameClock& clock;
  MessageForm& form;
  Warnings& warnings;
  std::string output;  ///< where the picture goes; empty: nowhere
  core::FileType type = core::FileType::png;
  CameraSetup camera{};
  Identity identity{};  ///< of this picture; what its scene saw once that is read
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
void check_outputs(Run& run) {
  const RenderOptions& o = run.options;
  parser::judge_outputs(o);
  core::claim_writable(o.dump_rays, "--dump-rays");
  core::claim_writable(sheet_file(o, o.depth_view), "--depth-view");
  core::claim_writable(sheet_file(o, o.view_cameras), "View_Cameras");
  if (!renders(o)) return;
  if (o.shadow_log && o.statistics_file.empty()) {
    throw parser::OptionError("Shadow_Log goes into the statistics: name a Statistics_File");
  }
  const auto width = static_cast<std::uint32_t>(o.width);
  parser::check_picture_size(o.width, o.height, bytes_a_row(film_settings(o).antialiasing, width),
                             machine_memory());
  if (!o.statistics_file.empty())
    core::claim_writable(parser::frame_path(o, o.statistics_file), "Statistics_File");
  if (!o.dependencies_file.empty())
    core::claim_writable(parser::frame_path(o, o.dependencies_file), "Dependencies_File");
  if (!o.output_to_file) return;
  core::claim_writable(RadiosityStore::output(o), "Radiosity_File_Name");
  run.output = parser::output_path(o, run.type);
  core::claim_writable(run.output, "the picture");
}

/// The diagnostics may live longer than a run, but not than these.
void connect(parser::Diagnostics& diagnostics, MessageForm& form, Warnings& warnings) {
  diagnostics.set_headings(form.headings());
  diagnostics.connect(parser::Stream::kWarning,
                      [&warnings](std::string_view text) { warnings.add(std::string(text)); });
  for (const auto stream :
       {parser::Stream::kDebug, parser::Stream::kRender, parser::Stream::kStatistics}) {
    diagnostics.connect(
        stream, [&form, stream](std::string_view text) { form.texts().write(stream, text); });
  }
}

/// With Strict=On nothing may be missing from the picture.
void refuse_if_strict(const RenderOptions& o, const std::vector<std::string>& not_rendered) {
  if (!o.strict || not_rendered.empty()) return;
  throw parser::OptionError("Strict=On: the picture would lack " + core::joined(not_rendered));
}

/// --parse-only, --dump: text -> descriptions, checked as far as they can be without rendering.
void parse_alone(Run& run, const Picture& what, const std::atomic<bool>& cancel) {
  const RenderOptions& o = run.options;
  SceneDisk disk(o, what.scene);
  for (const std::string& text : disk.warnings()) run.warnings.tell(text);
  parser::SourceManager sources(disk.files());
  parser::Diagnostics diagnostics(sources);
  connect(diagnostics, run.form, run.warnings);
  const double before = cpu_seconds();
  Reading reading = reading_of(o, run.clock, what.scene, &cancel);
  reading.parser.only_check = !o.dump;
  parser::SceneDesc scene =
      parser::read_descriptions(what.scene, sources, diagnostics, reading.parser);
  const double seconds = cpu_seconds() - before;
  const std::size_t objects = scene.objects.size() + scene.dropped;
  const std::string dump = o.dump ? json_text(parser::scene_json(scene, sources), 1) : "";
  parser::BuildReport report;
  parser::build_scene(scene, diagnostics, reading.build, &report);
  if (what.is_read) what.is_read(disk);
  run.warnings.say();
  refuse_if_strict(o, report.not_rendered);
  if (o.dump) std::puts(dump.c_str());
  if (!o.verbose) return;
  std::fprintf(stderr, "Parsed: %zu objects and lights, %zu warnings, %.3f s\n", objects,
               diagnostics.warnings().size(), seconds);
}

/// The picture's files are known as soon as the scene is read, and those of one that cannot be read
/// as far as it was.
void write_dependencies(const Run& run, const SceneDisk& disk) {
  const RenderOptions& o = run.options;
  if (o.dependencies_file.empty()) return;
  write_whole(parser::frame_path(o, o.dependencies_file),
              json_text(disk.dependencies(run.identity.program, run.identity.seen), 1) + "\n");
}

/// Pictures of views share a scene, unless it asks for a clock that is another now. A command
/// between them may have changed a file.
bool can_share(const Picture& what, const Reading& reading) {
  const RenderOptions& o = what.options;
  if (!what.kept || !what.kept->sheet || o.animation.views.count == 0) return false;
  if (!what.kept->session->serves(reading.parser)) return false;
  if (!has_frame_commands(o)) return true;
  return change_in(what.kept->disk.seen(), what.scene).empty();
}

/// As far as the scene was read.
void note_seen(Run& run, const Picture& what) {
  Seen& seen = run.identity.seen = what.kept->disk.seen();
  if (!what.kept->session) return;
  const parser::PictureReads& reads = what.kept->session->reads();
  if (reads.name) seen.name = what.scene;
  seen.now = reads.now;
}

CameraOptions camera_of(const Picture& what) {
  CameraOptions out = camera_options(what.options);
  out.depths = what.depths;
  return out;
}

/// What one frame alone has is said with its number.
void tell_of_camera(Run& run, const Picture& what) {
  for (const std::string& text : run.camera.warnings) {
    const bool is_frames = what.depths && text.starts_with("jumps: ");
    run.warnings.tell(is_frames ? text + " (frame " + std::to_string(run.clock.frame_number) + ")"
                                : text);
  }
}

/// The first picture of a scene.
void read_scene(Run& run, const Picture& what, Reading reading) {
  what.kept.reset();  // before there is another
  what.kept = std::make_shared<SceneInUse>(run.options, what.scene);
  SceneInUse& scene = *what.kept;
  for (const std::string& text : scene.disk.warnings()) run.warnings.tell(text);
  try {
    scene.session.emplace(std::move(reading), scene.disk.files(),
                          [&form = run.form, &warnings = run.warnings](auto& diagnostics) {
                            connect(diagnostics, form, warnings);
                          });
    try {
      run.camera = scene.session->camera(camera_of(what));
    } catch (const camera::CameraError& error) {
      fail_with_place(error, *scene.session, run.options);
    }
    tell_of_camera(run, what);
    if (run.options.depth) check_depth(run.camera, run.options);
  } catch (...) {
    note_seen(run, what);
    write_dependencies(run, scene.disk);
    throw;
  }
  if (run.camera.sheet && !run.options.views.quilt) {
    scene.sheet.emplace();
    scene.sheet->sheet = run.camera.sheet;
    scene.sheet->stand = run.camera.stand;
    scene.sheet->composed = run.camera.composed;
  }
}

/// Scene and camera.
void find_scene(Run& run, const Picture& what, const std::atomic<bool>& cancel) {
  Reading reading = reading_of(run.options, run.clock, what.scene, &cancel);
  if (run.options.continues && is_file_place(run.output))
    reading.parser.now = moment_of(run.output);
  if (can_share(what, reading)) {
    run.camera = what.kept->session->another_view(*what.kept->sheet, camera_of(what));
  } else {
    read_scene(run, what, std::move(reading));
  }
  note_seen(run, what);
  write_dependencies(run, what.kept->disk);
  if (const std::string file = RadiosityStore::input(run.options); !file.empty()) {
    core::note_input(file);
    if (const auto sum = parser::file_checksum(file)) run.identity.seen.files[file].sum = *sum;
  }
}

/// With +C.
bool is_there_already(Run& run, const std::string& scene) {
  const RenderOptions& o = run.options;
  if (!o.continues || !is_file_place(run.output) ||
      !is_finished(run.output, run.identity, o.input == "-" ? "" : scene)) {
    return false;
  }
  run.form.keep_picture(run.output);
  return true;
}

/// Null: the scene has no radiosity, or none is kept.
std::unique_ptr<RadiosityStore> radiosity_store(const Run& run, const SceneInUse& scene) {
  const Session& session = *scene.session;
  const RenderOptions& o = run.options;
  if (!session.scene().settings().radiosity) return nullptr;
  if (!o.radiosity_from_file && !o.radiosity_to_file) return nullptr;
  const Identity identity{run.identity.program,
                          parser::light_lines(o) + session.radiosity_lines(run.camera),
                          run.identity.seen};
  auto store = std::make_unique<RadiosityStore>(o, identity);
  store->read();
  return store;
}

void tell_of_file(Run& run, const std::string& file) {
  run.form.texts().write(parser::Stream::kRender,
                         "What is done is kept in '" + file + "': +C continues it\n");
}

void tell_of_journal(Run& run, PictureJournal& journal) {
  if (journal.keep()) tell_of_file(run, journal_path(run.output));
}

/// The rays of a pixel of the integral image, or of a strip of it, cover its area already.
bool has_spread_rays(const Run& run) {
  const parser::ViewOptions& views = run.options.views;
  return run.camera.sheet && !views.quilt && !views.count && run.camera.sheet->rays_a_place() > 1;
}

/// Sampling for the eye is for sheets; other pictures take it for what stock does.
FilmSettings film_of(Run& run) {
  FilmSettings film = film_settings(run.options);
  core::AntialiasingMethod& method = film.antialiasing.method;
  const bool is_print = run.camera.sheet && !run.options.views.quilt;
  if (method == core::AntialiasingMethod::kSpread && !is_print)
    method = core::AntialiasingMethod::kCorners;
  film.antialiasing.blends_light &= is_print;
  if (core::holds_any_light(run.type))
    film.antialiasing.most = std::numeric_limits<float>::infinity();
  if (film.antialiasing.compares() && has_spread_rays(run)) {
    run.warnings.add(
        "+A gains nothing with Lens_Model=thick, for the rays of a pixel are spread over its area "
        "already: leave +A out, or raise Lens_Rays");
  }
  if (method == core::AntialiasingMethod::kSpread) {
    for (const char* name : {"Jitter", "Jitter_Amount", "Antialias_Gamma"}) {
      if (run.options.said.contains(name))
        run.warnings.add(std::string(name) + " does nothing with Sampling_Method=3");
    }
  }
  return film;
}

/// False if the run was cancelled.
bool render(Run& run, SceneInUse& scene, const std::atomic<bool>& cancel, bool is_frame) {
  Session& session = *scene.session;
  const RenderOptions& o = run.options;
  const FilmSettings film = film_of(run);
  const Plan plan = session.plan(run.camera, film);
  std::optional<PictureJournal> journal;
  if (is_file_place(run.output)) {
    journal.emplace(run.output, plan.shape.width, plan.shape.height, run.identity);
    if (o.continues) journal->go_on();
  }
  PictureJournal* const kept = journal ? &*journal : nullptr;
  std::vector<core::SpareRoom*> rooms;
  std::optional<PassFile> passes;
  if (journal && session.has_passes()) {
    passes.emplace(run.output, run.identity);
    if (o.continues) passes->go_on();
    rooms.push_back(&*passes);
  }
  if (journal) rooms.push_back(kept);
  core::SpareRooms spare(std::move(rooms));
  const std::unique_ptr<RadiosityStore> store = radiosity_store(run, scene);
  run.form.begin_rendering(o, plan.report, plan.pixels);
  std::unique_ptr<core::Progress> bar;
  if (o.verbose) bar = run.form.progress();
  std::optional<PictureFile> picture(std::in_place, run.output,
                                     image_format(o, run.type, session.scene().settings()),
                                     run.camera, &spare);
  bool is_cut_off = false;
  try {
    run.report = session.render(
        plan, {*picture, bar.get(), kept, passes ? &*passes : nullptr, &cancel, store.get()});
    run.report.render_cpu_s -= picture->cpu_seconds();
    bar.reset();
    is_cut_off = cancel.load();
    if (!is_cut_off) picture->finish();
  } catch (const core::ImageError&) {
    bar.reset();
    picture.reset();  // what was kept last finds the room of its file
    if (journal) tell_of_journal(run, *journal);
    throw;
  }
  if (passes && !passes->trouble().empty()) run.warnings.tell(passes->trouble());
  if (is_cut_off) {
    if (journal) tell_of_journal(run, *journal);
    if (passes && passes->write()) tell_of_file(run, passes->path());
    return false;
  }
  if (journal) journal->finish(is_frame);
  if (passes) passes->forget();
  if (journal && !journal->trouble().empty()) run.warnings.tell(journal->trouble());
  run.report.write_cpu_s = picture->cpu_seconds();
  if (store) {
    store->finish();
    for (const std::string& text : store->warnings()) run.warnings.tell(text);
  }
  return true;
}

/// Those that were shot for this picture, later ones share.
void save_photons(Run& run, const PhotonRun& photons, const parser::Files& files) {
  const auto& passes = run.report.passes;
  const bool are_new = std::any_of(passes.begin(), passes.end(),
                                   [](const auto& pass) { return pass.name == "photons"; });
  if (!are_new || photons.file().empty()) return;
  if (!run.options.writes_to_disk) {
    return run.warnings.tell(
        "the photons are not saved: with Scene_Writes=memory a scene leaves no files behind");
  }
  if (!files.may_write(photons.file())) {
    return run.warnings.tell("the photons are not saved: '" + photons.file() +
                             "' cannot be written");
  }
  if (const std::string trouble = photons.save(); !trouble.empty()) run.warnings.tell(trouble);
}

/// What the picture told about the numbers it was given.
void report_advice(Run& run, SceneInUse& scene) {
  const Session& session = *scene.session;
  for (const std::string& text : session.advice()) run.warnings.add(text);
  if (const PhotonRun* const photons = session.photons()) {
    save_photons(run, *photons, scene.disk.files());
    if (const std::string text = photons->warning(); !text.empty()) run.warnings.tell(text);
    run.form.texts().write(parser::Stream::kStatistics, photons->text());
  }
  if (const RadiosityRun* const radiosity = session.radiosity()) {
    if (const std::string text = radiosity->warning(); !text.empty()) run.warnings.tell(text);
    run.form.texts().write(parser::Stream::kStatistics, run.form.radiosity(*radiosity));
  }
  if (const std::uint64_t cut = run.report.counters.cut_rays; cut > 0) {
    run.warnings.tell(std::to_string(cut) + " rays met " + std::to_string(core::kMostRays) +
                      " surfaces behind one another, and ended there");
  }
}

void write_statistics(const Run& run, const Session& session) {
  const RenderOptions& o = run.options;
  if (o.statistics_file.empty()) return;
  shadow::RunReport report = run.report;
  report.scene = o.input;
  report.accelerator = o.accelerator;
  nlohmann::json all = statistics(report, run.camera, session.scene().settings());
  all["not_rendered"] = session.not_rendered();
  if (session.photons()) all["photons"] = session.photons()->json();
  if (const auto& subsurface = session.scene().settings().subsurface) {
    all["subsurface"] = {{"samples_diffuse", subsurface->samples_diffuse},
                         {"samples_single", subsurface->samples_single}};
  }
  if (session.radiosity()) all["radiosity"] = session.radiosity()->json();
  write_whole(parser::frame_path(o, o.statistics_file), json_text(std::move(all), 2) + "\n");
}

/// What a run prints instead of a picture; nothing: it is to make one.
std::optional<Status> tell(Run& run, Session& session, const std::atomic<bool>& cancel) {
  const RenderOptions& o = run.options;
  if (o.explain) {
    session.prepare(run.camera.camera());
    std::fputs(explanation(session.scene(), run.camera, session.not_rendered()).c_str(), stdout);
  }
  if (o.depth && !say_depth(run.camera, session, o, cancel)) return kAborted;
  if (o.explain || o.depth) return kDone;
  for (const std::string& line : run.camera.report) {
    run.form.texts().write(parser::Stream::kRender, line + "\n");
  }
  if (o.dump_rays.empty()) return std::nullopt;
  dump_rays(run.camera.camera(), o.dump_rays);
  return kDone;
}

/// The program ends soon, and the system takes its memory back at once: nobody need visit the
/// scene's parts first. Process-wide: it is to outlive all that main() holds.
void leave_to_system(std::shared_ptr<SceneInUse> scene) {
  [[maybe_unused]] static const auto* const left =  // reached until the end
      new std::shared_ptr<SceneInUse>(std::move(scene));
}

Status make_picture(Run& run, const Picture& what, const std::atomic<bool>& cancel) {
  const auto start = Clock::now();
  const RenderOptions& o = run.options;
  check_order(o);
  check_outputs(run);
  if (o.parse_only || o.dump) {
    parse_alone(run, what, cancel);
    return kDone;
  }
  run.identity = identity_of(o, what.clock);
  if (what.depths) run.identity.options += depths_line(*what.depths);
  if (renders(o) && is_there_already(run, what.scene)) return kDone;
  if (renders(o)) run.form.begin_reading(o, what.clock, run.output);
  find_scene(run, what, cancel);
  Session& session = *what.kept->session;
  check_outputs(run);  // now that all inputs are known
  if (what.is_read) what.is_read(what.kept->disk);
  run.warnings.say();
  refuse_if_strict(o, session.not_rendered());
  write_view_cameras(run.camera, o);
  if (const auto status = tell(run, session, cancel)) return *status;
  session.drop_text();
  if (!render(run, *what.kept, cancel, what.is_frame)) return kAborted;
  report_advice(run, *what.kept);
  run.warnings.say();
  run.report.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  run.report.peak_bytes = peak_bytes();
  write_statistics(run, session);
  run.form.end_picture(o, run.report, run.output);
  if (what.is_last) leave_to_system(std::move(what.kept));
  return kDone;
}

}  // namespace

bool renders(const RenderOptions& o) {
  return !o.explain && !o.depth && !o.parse_only && !o.dump && o.dump_rays.empty();
}

Status run_picture(const Picture& what, const std::atomic<bool>& cancel, MessageForm& form,
                   Warnings& warnings) {
  Run run{what.options, what.clock, form, warnings, {}};
  try {
    return make_picture(run, what, cancel);
  } catch (const parser::Cancelled&) {
    return kAborted;
  }
}

}  // namespace lentray::tool
