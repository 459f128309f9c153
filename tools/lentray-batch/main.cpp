// lentray-batch: folders of scenes rendered in one go, with a manifest and a page of what became of each.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "core/base/ignored_error.h"
#include "core/image/run_files.h"
#include "parser/base/shown.h"
#include "parser/files/watched_files.h"
#include "parser/options/options.h"
#include "tools/common/machine.h"
#include "tools/common/messages.h"
#include "tools/common/process.h"
#include "tools/common/tool_main.h"
#include "tools/lentray-batch/arguments.h"
#include "tools/lentray-batch/cluster.h"
#include "tools/lentray-batch/manifest.h"
#include "tools/lentray-batch/page.h"
#include "tools/lentray-batch/page_cards.h"
#include "tools/lentray-batch/progress.h"
#include "tools/lentray-batch/scan.h"
#include "tools/lentray-batch/scheduler.h"
#include "tools/lentray-batch/table.h"
#include "tools/lentray-batch/worker.h"

namespace lentray::batch {
namespace {

namespace fs = std::filesystem;

enum Status : int { kAll = 0, kSome = 1, kNoBatch = 2, kStopped = 3 };

struct NoPage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// As a reader would type it.
std::string command_of(const std::vector<std::string>& words) {
  std::string out = "lentray-batch";
  for (const std::string& word : words) out += " " + word;
  return out;
}

const char* said_of_files(bool restricts) {
  return restricts ? "Restrict_IO=On: scenes read the folders that are named here, and write "
                     "nothing; Restrict_IO=Off lets them read all"
                   : "Restrict_IO=Off: scenes may read all files";
}

/// The jobs of a scene: one, or one a frame, or one a view.
std::vector<std::unique_ptr<Job>> jobs_of(const Plan& plan, const Scene& scene) {
  const parser::RenderOptions options = options_of(plan, scene);
  std::vector<std::unique_ptr<Job>> jobs;
  const bool has_views = options.animation.views.count > 0;
  if (has_views || (plan.arguments.frames && parser::is_animation(options.animation))) {
    for (const parser::AnimationFrame& frame : pictures_of(options)) {
      jobs.push_back(std::make_unique<Job>(plan, scene, options, frame));
    }
  } else {
    jobs.push_back(std::make_unique<Job>(plan, scene, options, std::nullopt));
  }
  return jobs;
}

/// One run of the program.
class Batch {
 public:
  explicit Batch(Arguments arguments)
      : m_state(arguments.out), m_plan(plan_of(std::move(arguments))),
        m_manifest(m_plan.arguments.out, m_state) {}

  Status run() {
    find();
    check_outputs();
    return finish(render());
  }

 private:
  /// False if a signal stopped it.
  bool render() {
    BatchProgress progress(m_kept + m_jobs.size(), m_kept, m_kept_failed, m_plan.arguments.quiet);
    if (!m_plan.arguments.quiet) progress.say(said_of_files(m_plan.arguments.restricts));
    for (const std::string& warning : m_warnings) progress.say(warning);
    if (m_plan.arguments.slurm && !on_cluster(progress)) return false;
    m_manifest.reserve(m_jobs.size());
    m_state.reserve(m_jobs.size());
    Scheduler scheduler(
        m_plan,
        [this](const Row& row) {
          note_inputs(row);
          m_manifest.put(row);
        },
        progress);
    for (std::unique_ptr<Job>& job : m_jobs) scheduler.add(std::move(job));
    scheduler.now_and_then([this] {
      try {
        write_page(PageOptions::Stage::running);
      } catch (const NoPage&) {
        // The last one says what is wrong, if it still is.
      }
    });
    return scheduler.run();
  }

  bool on_cluster(BatchProgress& progress) {
    std::vector<Job*> jobs;
    for (const std::unique_ptr<Job>& job : m_jobs) {
      if (job->needs_picture()) jobs.push_back(job.get());
    }
    if (!Cluster(m_plan, m_manifest, progress).run(jobs)) return false;
    std::erase_if(m_jobs, [](const std::unique_ptr<Job>& job) {
      return !job->needs_views() && !job->needs_comparison();
    });
    return true;
  }

  Plan plan_of(Arguments arguments) {
    Plan plan;
    plan.arguments = std::move(arguments);
    plan.processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    plan.memory = tool::machine_memory();
    plan.state = &m_state;
    const auto sum = parser::file_checksum(plan.arguments.lentray.string());
    if (!sum)
      throw std::runtime_error("there is no program '" + plan.arguments.lentray.string() + "'");
    plan.program = *sum;
    return plan;
  }

  /// Scenes, and of each what is to be done.
  void find() {
    const Arguments& a = m_plan.arguments;
    const Scan scan = find_scenes(a.inputs, {a.out, !a.restricts}, m_manifest.names());
    // What is restricted here stock does not know.
    if (a.compare && a.restricts) {
      m_warnings.emplace_back(
          "warning: --compare: stock POV-Ray obeys povray.conf alone, not Restrict_IO=On");
    }
    for (const std::string& text : scan.warnings) m_warnings.push_back("warning: " + text);
    for (const Scene& scene : scan.scenes) {
      core::note_input(scene.source);
      core::note_input(scene.ini);
      if (!scene.part_of.empty()) {
        put(row_without_job(m_plan, scene, State::skipped,
                            "a part of " + scene.part_of + ": it has no camera of its own"));
        continue;
      }
      try {
        for (std::unique_ptr<Job>& job : jobs_of(m_plan, scene)) add(std::move(job));
      } catch (const parser::OptionError& error) {
        put(row_without_job(m_plan, scene, State::failed, tool::one_line(error.what())));
      }
    }
    // Rows of scenes that are gone go too; those of other inputs stay.
    std::vector<std::string> gone;
    for (const auto& [name, row] : m_manifest.rows()) {
      std::error_code error;
      if (!m_names.contains(name) && !fs::exists(row.source, error)) gone.push_back(name);
    }
    for (const std::string& name : gone) m_manifest.drop(name);
  }

  /// None is a scene, and none is another's.
  void check_outputs() const {
    for (const auto& [name, row] : m_manifest.rows()) note_inputs(row);
    const fs::path& out = m_plan.arguments.out;
    core::claim_output(out / "manifest.jsonl", "the manifest");
    core::claim_output(out / "index.html", "the page");
    core::claim_writable(m_plan.arguments.table, "--table");
  }

  static void note_inputs(const Row& row) {
    core::note_input(row.source);
    for (const auto& [path, stamp] : row.seen.files) core::note_input(path);
  }

  void put(const Row& row) {
    m_names.insert(row.name);
    m_manifest.put(row);
    if (row.state == State::failed) m_warnings.push_back(row.name + ": failed: " + row.reason);
  }

  void add(std::unique_ptr<Job> job) {
    m_names.insert(job->name());
    const Row* known = m_manifest.find(job->name());
    bool is_new = true;
    if (job->is_up_to_date(known)) {
      job->adopt(*known);
      is_new = false;
    } else {
      job->adopt_left_over(known);
    }
    if (!is_new) m_manifest.renew(job->row());
    if (!is_new && !job->needs_views() && !job->needs_comparison()) {
      ++m_kept;
      if (job->row().state == State::failed) ++m_kept_failed;
      return;
    }
    if (job->needs_picture() || is_new) m_manifest.await(job->row());
    m_jobs.push_back(std::move(job));
  }

  /// Of the scenes of this run, as far as they are known.
  std::vector<Row> rows() const {
    std::vector<Row> out;
    for (const std::string& name : m_names) {
      if (const Row* row = m_manifest.find(name)) out.push_back(*row);
    }
    return out;
  }

  /// In a process of its own: pictures that are read for it take memory, and may be anything.
  void write_page(PageOptions::Stage stage) {
    const fs::path log = m_state.path() / "page.log";
    PageOptions options;
    for (const fs::path& input : m_plan.arguments.inputs)
      options.title += (options.title.empty() ? "" : ", ") + input.string();
    options.folder = m_plan.arguments.out;
    options.stage = stage;
    options.restricts = m_plan.arguments.restricts;
    options.expected_rows = m_names.size();
    options.wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    tool::Launch launch;
    launch.log = log;
    launch.work = [this, &options] {
      try {
        tool::write_whole(options.folder / "index.html", page(rows(), options));
        return 0;
      } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
      }
    };
    tool::Child child(launch);
    std::optional<tool::Ended> ended;
    while (!(ended = child.ended())) {
      if (tool::wait_for_news(std::chrono::milliseconds(200)) != 0)
        throw std::runtime_error("stopped while the page was made; the same command makes it");
    }
    if (ended->status == 0) return;
    const std::string said = tool::last_error(tool::read_text(log));
    throw NoPage("the page could not be written: " +
                 (!said.empty() ? said
                  : ended->status > 128
                      ? "ended by signal " + std::to_string(ended->status - 128)
                      : std::string("no space is left on the disk, or too little memory")));
  }

  Status finish(bool is_done) {
    const bool is_kept = keep_rows();
    if (is_done) {
      m_state.free_reserve();
      m_state.forget_radiosity();
    } else {
      std::fputs("lentray-batch: stopped; the same command goes on from here\n", stderr);
    }
    const bool has_page = keep_page(is_done);
    if (!is_done) return kStopped;
    const Arguments& a = m_plan.arguments;
    if (!a.table.empty())
      tool::write_whole(a.table, table(rows(), command_of(a.words), stock_version()));
    const Status status = summary(has_page);
    return is_kept && has_page ? status : kSome;
  }

  /// False if rows could not be written. On a full disk the file stays as it was appended to.
  bool keep_rows() {
    try {
      m_manifest.tidy();
    } catch (const std::exception& error) {
      if (m_manifest.trouble().empty()) return true;
      std::fprintf(stderr, "lentray-batch: rows of the manifest are lost: %s\n", error.what());
      return false;
    }
    return true;
  }

  bool keep_page(bool is_done) {
    try {
      write_page(is_done ? PageOptions::Stage::finished : PageOptions::Stage::stopped);
      return true;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "lentray-batch: %s\n", parser::shown_text(error.what()).c_str());
      return false;
    }
  }

  std::string stock_version() const {
    const std::string said = tool::run_program({m_plan.arguments.povray, "--version"}).output;
    const std::size_t at = said.find("POV-Ray ");
    return at == std::string::npos
               ? ""
               : said.substr(at + 8, said.find_first_of(" \n", at + 8) - at - 8);
  }

  Status summary(bool has_page) const {
    std::size_t done = 0, failed = 0, skipped = 0, warned = 0, below = 0;
    std::map<std::string, int> grades;
    for (const std::string& name : m_names) {
      const Row& row = *m_manifest.find(name);
      done += row.state == State::done ? 1 : 0;
      failed += row.state == State::failed ? 1 : 0;
      skipped += row.state == State::skipped ? 1 : 0;
      warned += row.warnings > 0 ? 1 : 0;
      if (!row.verdict) continue;
      ++grades[row.verdict->grade.empty() ? "not compared" : row.verdict->grade];
      const auto grade = core::grade_named(row.verdict->grade);
      if (m_plan.arguments.asked && !row.verdict->grade.empty() &&
          (!grade || *grade < *m_plan.arguments.asked))
        ++below;
    }
    std::string text = std::to_string(done) + " done, " + std::to_string(failed) + " failed, " +
                       std::to_string(skipped) + " left out (parts), " + std::to_string(warned) +
                       " with warnings";
    for (const auto& [grade, count] : grades) text += ", " + std::to_string(count) + " " + grade;
    if (below > 0) text += "; " + std::to_string(below) + " below the grade that is asked for";
    std::printf("%s\n", text.c_str());
    const std::vector<Row> all = rows();
    const Summary sum = summary_of(all, cards_of(all));
    if (const std::string kinds = text_of(sum.kinds, sum.done); !kinds.empty())
      std::printf("%s\n", kinds.c_str());
    if (has_page) std::printf("%s\n", (m_plan.arguments.out / "index.html").c_str());
    return (m_plan.arguments.asked ? below : failed) > 0 ? kSome : kAll;
  }

  StateFolder m_state;
  const Plan m_plan;
  Manifest m_manifest;
  std::vector<std::unique_ptr<Job>> m_jobs;
  std::set<std::string> m_names;
  std::size_t m_kept = 0, m_kept_failed = 0;  ///< rows that nothing has changed of
  std::vector<std::string> m_warnings;
  const std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// Its first line is a row, perhaps of another version.
bool looks_like_rows(const fs::path& file) {
  const std::string text = tool::file_bytes(file);
  const nlohmann::json row = nlohmann::json::parse(text.substr(0, text.find('\n')), nullptr, false);
  return row.is_object() && row.contains("name") && row.contains("state");
}

/// The page and the manifest of something else stay.
void refuse_foreign(const fs::path& out) {
  tool::refuse_foreign_page(out / "index.html", "lentray-batch");
  tool::refuse_foreign(out / "manifest.jsonl", "lentray-batch", [&](const fs::path& file) {
    return fs::exists(out / ".lentray-batch", core::ignored_error()) || looks_like_rows(file);
  });
}

int batch(const Arguments& arguments) {
  tool::hold_signals();
  if (arguments.restricts && arguments.worker.empty()) tool::refuse_links(arguments.out);
  if (arguments.worker.empty()) refuse_foreign(arguments.out);
  return arguments.worker.empty() ? Batch(arguments).run() : do_task(arguments);
}

}  // namespace
}  // namespace lentray::batch

int main(int count, char** words) {
  using namespace lentray::batch;
  return lentray::tool::tool_main({"lentray-batch", kNoBatch, true}, count, words, parse_arguments,
                                  usage, batch);
}
