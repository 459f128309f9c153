#include "tools/lentray-batch/job.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/formed.h"
#include "core/base/ignored_error.h"
#include "core/image/reader.h"
#include "parser/files/watched_files.h"
#include "parser/options/create_ini.h"
#include "parser/options/said_options.h"
#include "tools/common/companion.h"
#include "tools/common/duration.h"
#include "tools/common/json_fields.h"
#include "tools/common/json_text.h"
#include "tools/common/messages.h"
#include "tools/common/process.h"
#include "tools/common/shell_words.h"
#include "tools/lentray-batch/run_log.h"
#include "tools/lentray-batch/verdict.h"
#include "tools/lentray-batch/views.h"
#include "tools/session/seen.h"

namespace lentray::batch {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::size_t kMostMessages = 200;
constexpr std::uint64_t kMostLog = 25'000'000;  ///< bytes

/// As lentray names the files of a frame, or of a view.
fs::path numbered(fs::path path, const std::string& digits) {
  const std::string extension = path.extension().string();
  return path.replace_extension() += digits + extension;
}

std::string hexadecimal(std::uint64_t value) {
  return core::formed("%016llx", static_cast<unsigned long long>(value));
}

/// What decides the picture, but for the files that its scene reads.
std::string key_of(const Plan& plan, const parser::RenderOptions& o,
                   const std::optional<parser::AnimationFrame>& frame) {
  std::string text =
      hexadecimal(plan.program) + "\n" + parser::picture_lines(o) + parser::file_lines(o);
  for (const std::string& folder : o.library_paths) text += folder + "\n";
  for (const std::string& folder : o.permitted_paths) text += "permitted " + folder + "\n";
  text += std::string(o.strict ? "strict " : "") + (o.restrict_io ? "restricted " : "") +
          (o.clock_given ? std::to_string(o.clock) : "");
  if (frame) {
    const parser::FrameClock& c = frame->clock;
    for (const double value :
         {c.clock, c.initial_clock, c.final_clock, c.clock_delta, double(c.frame_number),
          double(c.initial_frame), double(c.final_frame)}) {
      text += core::formed(" %.17g", value);
    }
  }
  return hexadecimal(parser::checksum(text));
}

/// Disks, quotas and limits of a file's size.
bool tells_of_no_room(const std::string& reason) {
  return std::ranges::any_of(
             std::array{ENOSPC, EDQUOT, EFBIG},
             [&](int error) { return reason.find(std::strerror(error)) != std::string::npos; }) ||
         reason.find("no space") != std::string::npos;
}

json read_json(const fs::path& path) { return tool::json_if_any(tool::file_bytes(path)); }

/// The batch's options, what the scene may read, and then the scene's own, whose INI file is called so.
std::vector<std::string> options_in_words(const Plan& plan, const Scene& scene,
                                          const fs::path& ini) {
  std::vector<std::string> words = plan.arguments.for_lentray;
  if (plan.arguments.restricts) {
    for (const fs::path& folder : folders_of(plan.arguments.inputs, scene.source))
      words.push_back("Permitted_Path=" + (folder / "").string());
  }
  if (plan.arguments.scene_ini && !scene.ini.empty())
    tool::append(words, {"--scene-ini", ini.string()});
  return words;
}

std::string signal_text(int signal) {
  const char* name = sigdescr_np(signal);
  return "ended by signal " + std::to_string(signal) +
         (name == nullptr ? "" : std::string(" (") + name + ")");
}

}  // namespace

std::string utc_now() { return tool::utc_text("%Y-%m-%dT%H:%M:%SZ"); }

std::string word_of(const Scene& scene) {
  const std::string name = scene.source.filename().string();
  // Blanks and quotes at the ends are no part of an option's value.
  const bool has_end = name.find_first_of(" \t\"'") == 0;
  return (has_end ? "+I./" : "+I") + name;
}

void enter_folder(tool::Launch& launch, const Plan& plan, const Scene& scene) {
  const fs::path folder = scene.source.parent_path();
  auto held = std::make_shared<const parser::Descriptor>(parser::look_at(folder.string()));
  if (!*held)
    throw std::runtime_error("cannot enter '" + folder.string() + "': " + std::strerror(errno));
  if (plan.arguments.restricts && !lies_in(plan.arguments.inputs, parser::real_path(*held)))
    throw std::runtime_error("Restrict_IO: '" + folder.string() +
                             "' leads out of the folders of this batch");
  launch.folder = parser::handle_of(*held);
  launch.held = std::move(held);
}

parser::RenderOptions options_of(const Plan& plan, const Scene& scene) {
  parser::OptionSources sources;
  sources.trusts_scene_folder = false;  // its name may mean another one a moment later
  return parser::read_options(options_in_words(plan, scene, scene.ini), sources);
}

Row row_without_job(const Plan&, const Scene& scene, State state, const std::string& reason) {
  Row row;
  row.name = scene.name;
  row.source = scene.source.string();
  row.state = state;
  row.reason = reason;
  row.attempts = 0;
  row.finished = utc_now();
  return row;
}

Job::Job(const Plan& plan, Scene scene, const parser::RenderOptions& options,
         std::optional<parser::AnimationFrame> frame, std::optional<Band> band)
    : m_plan(plan), m_scene(std::move(scene)), m_options(options), m_frame(std::move(frame)),
      m_band(band) {
  m_row.name = m_scene.name;
  if (m_frame) {
    m_row.frame = m_frame->clock.frame_number;
    m_row.name += "#" + m_frame->digits;
  }
  m_row.source = m_scene.source.string();
  m_row.attempts = 0;
  m_row.key = key_of(plan, m_options, m_frame);
  m_scene_key = key_of(plan, m_options, std::nullopt);
  m_row.picture =
      m_scene.name + (m_frame ? m_frame->digits : "") + core::extension_of(m_options.type);
  if (!m_band) return;
  m_row.name += "~" + std::to_string(m_band->index);
  m_row.band = std::to_string(m_band->index) + "/" + std::to_string(m_band->count);
  m_row.picture = band_picture(m_row.picture, m_band->index);
}

std::vector<parser::AnimationFrame> pictures_of(const parser::RenderOptions& options) {
  parser::check_pixels(options);
  constexpr std::size_t kMost = 100'000;
  const parser::AnimationFrames all = parser::frames_of(options.animation);
  if (all.size() > kMost) {
    throw parser::OptionError(parser::with_said(
        core::formed("it has %zu frames, and a batch makes %zu of a scene", all.size(), kMost),
        options, {"Initial_Frame", "Final_Frame", "Views"}));
  }
  std::vector<parser::AnimationFrame> frames(all.begin(), all.end());
  if (options.animation.views.count > 0) {
    for (parser::AnimationFrame& view : frames)
      view.clock.frame_number = std::atoi(view.digits.c_str());
  }
  return frames;
}

PictureSize size_of(const parser::RenderOptions& o) {
  if (o.animation.views.count > 0 && o.views.size) {
    return {static_cast<double>(o.views.size->width), static_cast<double>(o.views.size->height)};
  }
  return {static_cast<double>(o.width), static_cast<double>(o.height)};
}

double rows_of_file(const parser::RenderOptions& o) {
  const bool is_view = o.view || o.animation.views.count > 0;
  const bool is_on_its_side = o.lenticular && o.lens.across.value_or(false) && !is_view;
  const PictureSize size = size_of(o);
  return is_on_its_side ? size.width : size.height;
}

std::string band_picture(const std::string& picture, int index) {
  return ".lentray-batch/bands/" + picture + "." + std::to_string(index) +
         fs::path(picture).extension().string();
}

/// A run's files of a frame or view are named as lentray names them, which makes several of them in one run.
fs::path Job::kept_file(const char* kind) const {
  if (m_frame && !m_band)
    return numbered(m_plan.state->file(m_scene.name + "#", m_scene_key, kind), m_frame->digits);
  return m_plan.state->file(m_row.name, m_row.key, kind);
}

/// The name that lentray is given.
fs::path Job::given_file(const char* kind) const {
  if (m_plan.scratch.empty()) {
    return m_frame ? m_plan.state->file(m_scene.name + "#", m_scene_key, kind) : kept_file(kind);
  }
  fs::path place = root() / "runs" / (m_frame ? m_scene.name + "#" : m_row.name);
  place += std::string(".") + kind;
  fs::create_directories(place.parent_path());
  return place;
}

fs::path Job::run_file(const char* kind) const {
  return m_frame ? numbered(given_file(kind), m_frame->digits) : given_file(kind);
}

/// Below it files are made.
fs::path Job::root() const {
  if (m_plan.scratch.empty()) return m_plan.arguments.out;
  return m_band ? m_plan.scratch / ("band" + std::to_string(m_band->index)) : m_plan.scratch;
}

/// What was made in the scratch folder is moved to its place. What stood there is of the same picture: another worker
/// was at it too.
void Job::publish() {
  if (m_plan.scratch.empty()) return;
  fs::create_directories(picture_path().parent_path());
  fs::rename(made_picture(), picture_path());
}

/// Where the program writes it.
fs::path Job::made_picture() const {
  return root() /
         (m_scene.name + (m_frame ? m_frame->digits : "") + core::extension_of(m_options.type));
}

double Job::room(bool with_journal) const {
  constexpr double kColours = 24.0;  ///< bytes of a pixel in the journal; of samples as many
  double pixels = size_of(m_options).pixels();
  if (m_band) {
    pixels *=
        static_cast<double>(m_band->last_row - m_band->first_row + 1) / rows_of_file(m_options);
  }
  const double sample = m_options.bits > 16 ? 4.0 : m_options.bits > 8 ? 2.0 : 1.0;
  const double journal = with_journal ? kColours * (m_options.antialias ? 2.0 : 1.0) : 0.0;
  return pixels * (4.0 * sample + journal);
}

bool Job::drop_journal() const {
  return fs::remove(tool::journal_path(made_picture().string()), core::ignored_error());
}

void Job::drop_picture() const {
  fs::remove(made_picture(), core::ignored_error());
  drop_journal();
}

void Job::publish_statistics(const Row& band) const {
  fs::rename(m_plan.state->file(band.name, band.key, "statistics"), kept_file("statistics"),
             core::ignored_error());
}

void Job::move_from_scratch(const std::string& picture) const {
  if (m_plan.scratch.empty() || !fs::exists(root() / picture, core::ignored_error())) return;
  const fs::path place = m_plan.arguments.out / picture;
  fs::create_directories(place.parent_path(), core::ignored_error());
  fs::rename(root() / picture, place, core::ignored_error());
}
fs::path Job::picture_path() const { return m_plan.arguments.out / m_row.picture; }

bool Job::is_view_after(const Job& earlier) const {
  return is_view() && earlier.is_view() && !m_options.animation.views.clocks && !m_band &&
         !earlier.m_band && m_scene.source == earlier.m_scene.source &&
         m_frame->clock.frame_number ==
             earlier.m_frame->clock.frame_number + m_options.animation.step;
}

std::vector<std::string> Job::words(const Job* last) const {
  std::vector<std::string> words =
      options_in_words(m_plan, m_scene, fs::path(m_scene.ini).filename());
  if (m_frame) {
    const Job& end = last != nullptr ? *last : *this;
    tool::append(words, {"+SF" + std::to_string(m_frame->clock.frame_number),
                         "+EF" + std::to_string(end.m_frame->clock.frame_number)});
  } else if (parser::is_animation(m_options.animation)) {
    tool::append(words, {"+KFI1", "+KFF1"});
  }
  return words;
}

/// As by hand, but for what the batch needs for itself.
std::vector<std::string> Job::command(const Job& last, int threads) const {
  std::vector<std::string> command{m_plan.arguments.lentray.string()};
  tool::append(command, words(&last));
  // Lentray adds the digits of frames and views.
  const fs::path picture = root() / (m_scene.name + core::extension_of(m_options.type));
  tool::append(command,
               {word_of(m_scene), "+O" + picture.string(), "+WT" + std::to_string(threads)});
  if (m_band) {
    tool::append(command, {"+SR" + std::to_string(m_band->first_row),
                           "+ER" + std::to_string(m_band->last_row)});
  }
  return command;
}

tool::Launch Job::render(const Job& last, bool goes_on, int threads, double memory) const {
  tool::Launch launch;
  enter_folder(launch, m_plan, m_scene);
  launch.log = run_file("log");
  fs::create_directories(made_picture().parent_path());
  launch.command = command(last, threads);
  tool::append(launch.command,
               {"-V", "-D", "-P", "Count_Tests=Off", core::formed("Max_Memory=%.0f", memory),
                "Statistics_File=" + given_file("statistics").string(),
                "Dependencies_File=" + given_file("read").string(), "Scene_Writes=memory"});
  if (goes_on) launch.command.emplace_back("+C");
  // The first run that needs a pass of radiosity keeps it for the others.
  if (!m_options.radiosity_from_file && !m_options.radiosity_to_file) {
    tool::append(launch.command, {"+RFI", "+RFO", "+RF" + m_plan.state->radiosity_folder()});
  }
  return launch;
}

void Job::prepare(const tool::Launch& launch) {
  if (m_frame) {
    m_plan.state->forget_others(m_scene.name + "#", m_scene_key);
  } else {
    m_plan.state->forget_others(m_row.name, m_row.key);
  }
  m_log = launch.log;
  m_started = tool::now();
}

void Job::begin(int threads) {
  m_row.command = command(*this, threads);
  m_lacked_memory = false;
  ++m_row.attempts;
}

/// Its statistics come last.
bool Job::is_made() const { return tool::modified(run_file("statistics")) >= m_started; }
bool Job::is_read() const { return tool::modified(run_file("read")) >= m_started; }

tool::Ended Job::part() const {
  tool::Ended part;
  const json all = read_json(run_file("statistics"));
  const json& time = all.at("time");
  part.wall = time.at("wall_s");
  for (const char* what : {"parse_cpu_s", "compile_cpu_s", "render_cpu_s", "write_cpu_s"})
    part.cpu += time.at(what).get<double>();
  part.memory = all.at("memory").at("peak_bytes");
  return part;
}

void Job::rendered(const tool::Ended& ended, bool stopped) {
  m_row.wall += ended.wall;
  m_row.cpu += ended.cpu;
  m_row.memory = std::max(m_row.memory, ended.memory);
  m_row.status = ended.status;
  read_log();
  read_dependencies(m_started, m_started);
  if (stopped && ended.status == 2) return;
  if (ended.status != 0) return fail(ended);
  m_row.state = State::done;
  m_row.reason.clear();
  m_row.lacks_room = false;
  if (is_view() && m_plan.arguments.compare) {
    m_row.verdict.emplace();
    m_row.verdict->note = "views of Views= are not; their integral image can be";
  }
  publish();
  if (m_frame) drop_journal();  // that it is finished the row says
  m_has_picture = true;
  read_statistics();
  if (!m_plan.scratch.empty()) fs::rename(run_file("statistics"), kept_file("statistics"));
  m_row.finished = utc_now();
}

void Job::fail(const tool::Ended& ended) {
  std::string reason;
  for (const std::string& line : m_row.messages) {
    const bool is_error =
        line.find("error:") != std::string::npos ||
        (line.starts_with("lentray: ") && line.find("warning:") == std::string::npos);
    if (is_error) reason = line;
  }
  if (ended.status > 128) reason = signal_text(ended.status - 128);
  if (reason.empty() && ended.status == 1 && m_row.messages.empty())  // which found no room either
    reason = "no space is left on the disk of '" + m_plan.arguments.out.string() + "'";
  if (reason.empty() && ended.status == 126) reason = "the folder of the scene cannot be entered";
  if (reason.empty()) reason = "exit status " + std::to_string(ended.status);
  if (reason.starts_with("lentray: ")) reason.erase(0, 9);
  m_lacked_memory = ended.status == 1 && (reason.find("Max_Memory") != std::string::npos ||
                                          reason.find("not enough memory") != std::string::npos);
  give_up(reason);
}

void Job::give_up(const std::string& reason) {
  m_is_over = true;
  m_has_picture = false;
  m_row.state = State::failed;
  m_row.reason = reason;
  m_row.lacks_room = tells_of_no_room(reason);
  m_row.limits = limits();
  m_row.finished = utc_now();
  if (m_row.seen.files.empty()) {
    stamp(m_scene.source);
  }
}

void Job::fail_as(const Row& view) {
  Row row = view;
  std::swap(row, m_row);
  m_row.name = row.name;
  m_row.frame = row.frame;
  m_row.key = row.key;
  m_row.picture = row.picture;
  m_row.wall = m_row.cpu = 0.0;
  m_row.command = command(*this, 1);
  give_up(view.reason);
}

void Job::read_log() {
  std::ifstream file(m_log.empty() ? run_file("log") : m_log, std::ios::binary);
  m_row.messages.clear();
  m_row.warnings = 0;
  m_row.kinds.clear();
  for (const std::string& line : log_lines(file, m_row.frame)) {
    if (line.find("warning:") != std::string::npos) ++m_row.warnings;
    note_kind(m_row.kinds, tool::one_line(line));
    if (m_row.messages.size() >= kMostMessages) continue;
    m_row.messages.push_back(tool::one_line(line));
  }
}

void Job::read_statistics() {
  m_row.bytes = fs::is_regular_file(picture_path(), core::ignored_error())
                    ? fs::file_size(picture_path())
                    : 0;
  m_row.picture_file = tool::stamp_of(picture_path()).value_or(tool::FileStamp{});
  const json all = read_json(run_file("statistics"));
  if (!all.is_object()) return;
  m_row.width = tool::whole_of<std::uint32_t>(all.at("image").at("width"));
  m_row.height = tool::whole_of<std::uint32_t>(all.at("image").at("height"));
  const json& time = all.at("time");
  time.at("parse_cpu_s").get_to(m_row.reading);
  time.at("compile_cpu_s").get_to(m_row.building);
  time.at("render_cpu_s").get_to(m_row.rendering);
  time.at("write_cpu_s").get_to(m_row.writing);
  all.at("not_rendered").get_to(m_row.left_out);
  const bool is_other = m_options.view || is_view() || m_options.views.quilt;
  m_row.lens_pixels = is_other ? 0.0 : all.value("/lens/pixels"_json_pointer, 0.0);
  const bool is_across = all.value("/lens/lenses_lie"_json_pointer, std::string()) == "across";
  if (is_across && !is_other) std::swap(m_row.width, m_row.height);
}

bool Job::says_too_much() const {
  std::error_code error;
  const std::uint64_t bytes = m_log.empty() ? 0 : fs::file_size(m_log, error);
  return !error && bytes > kMostLog;
}

bool Job::needs_views() const {
  if (m_band || !m_plan.arguments.views || !m_has_picture || m_row.lens_pixels <= 0.0 ||
      m_views_failed)
    return false;
  return m_row.views.empty();
}

tool::Launch Job::split_views() {
  tool::Launch launch;
  launch.log = run_file("views");
  const fs::path picture = picture_path(), out = m_plan.arguments.out;
  const double pixels = m_row.lens_pixels;
  m_row.views = view_names(m_row.picture, pixels);
  launch.work = [picture, out, pixels, names = m_row.views] {
    return write_views(picture, pixels, out, names);
  };
  return launch;
}

void Job::views_split(const tool::Ended& ended) {
  if (ended.status == 0) return;
  m_row.views.clear();
  m_views_failed = true;
  m_row.messages.push_back("views: " + tool::one_line(tool::read_text(run_file("views"))));
  ++m_row.warnings;
}

bool Job::needs_comparison() const {
  if (m_band || !m_plan.arguments.compare || m_row.verdict || is_view()) return false;
  return m_has_picture || m_is_over;
}

tool::Launch Job::compare(int processes) {
  tool::Launch launch;
  enter_folder(launch, m_plan, m_scene);
  launch.log = run_file("comparison");
  const fs::path prefix = root() / "compare" / fs::path(m_row.picture).replace_extension();
  fs::create_directories(prefix.parent_path());
  launch.command = {m_plan.arguments.diff.string()};
  tool::append(launch.command, words());
  tool::append(launch.command,
               {"+I" + m_scene.source.string(), "--output=" + prefix.string(),
                "--threads=" + std::to_string(processes), "--povray=" + m_plan.arguments.povray,
                "--json=" + run_file("verdict").string()});
  if (m_plan.arguments.time_limit > 0.0) {
    launch.command.push_back("--time-limit=" +
                             std::to_string(kStocksTimes * m_plan.arguments.time_limit));
  }
  if (!m_plan.arguments.noise.empty())
    launch.command.push_back("--noise=" + m_plan.arguments.noise);
  if (m_has_picture) {
    tool::append(launch.command, {"--ours=" + picture_path().string(),
                                  "--statistics=" + kept_file("statistics").string()});
  } else {
    launch.command.emplace_back("--stock-alone");
  }
  fs::remove(run_file("verdict"), core::ignored_error());
  return launch;
}

void Job::compared(const tool::Ended& ended) {
  Verdict v;
  const json all = read_json(run_file("verdict"));
  if (ended.status > 128) {
    v.note = signal_text(ended.status - 128);
  } else if (ended.status == 2 || !all.is_object()) {
    v.note = tool::last_error(tool::read_text(run_file("comparison")));
  } else {
    v.stock_cpu = all.value("stock_cpu_s", 0.0);
    v.stock_wall = all.value("stock_wall_s", 0.0);
    const std::string begin = "compare/" + fs::path(m_row.picture).replace_extension().string();
    for (const char* kind : {"-stock.png", "-heat.png"}) move_from_scratch(begin + kind);
    v.stock = begin + "-stock.png";
    v.grade = "fails";
    if (m_has_picture) {
      v.difference = begin + "-heat.png";
      take_figures(all, v);
    }
  }
  m_row.verdict = v;
}

}  // namespace lentray::batch
