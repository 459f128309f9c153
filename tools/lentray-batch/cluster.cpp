#include "tools/lentray-batch/cluster.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "core/base/ignored_error.h"
#include "core/base/joined.h"
#include "tools/common/duration.h"
#include "tools/common/messages.h"
#include "tools/common/process.h"
#include "tools/common/shell_words.h"
#include "tools/lentray-batch/estimate.h"

namespace lentray::batch {

namespace fs = std::filesystem;

namespace {

constexpr int kMostSubmissions = 4;  ///< of the same work

std::string run_name() {
  return tool::utc_text("%Y%m%d-%H%M%S") + "-" + std::to_string(::getpid());
}

/// "0,3-5" of {0, 3, 4, 5}.
std::string ranges(const std::vector<std::size_t>& numbers) {
  std::string out;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::size_t end = i;
    while (end + 1 < numbers.size() && numbers[end + 1] == numbers[end] + 1) ++end;
    out += (out.empty() ? "" : ",") + std::to_string(numbers[i]) +
           (end > i ? "-" + std::to_string(numbers[end]) : "");
    i = end;
  }
  return out;
}

/// The row of a picture that was made in bands.
Row joined(const std::vector<Row>& bands) {
  Row row = bands.front();
  row.name = row.name.substr(0, row.name.rfind('~'));
  row.band.clear();
  for (std::size_t i = 1; i < bands.size(); ++i) {
    const Row& b = bands[i];
    for (double Row::*time :
         {&Row::wall, &Row::cpu, &Row::reading, &Row::building, &Row::rendering, &Row::writing})
      row.*time += b.*time;
    row.memory = std::max(row.memory, b.memory);
    row.attempts += b.attempts;
    if (b.state == State::failed && row.state != State::failed) {
      row.state = State::failed;
      row.reason = b.reason;
      row.lacks_room = b.lacks_room;
      row.status = b.status;
      row.messages = b.messages;
    }
  }
  return row;
}

}  // namespace

Cluster::Cluster(const Plan& plan, Manifest& manifest, BatchProgress& progress)
    : m_plan(plan), m_manifest(manifest), m_progress(progress), m_slurm(plan.arguments.sbatch),
      m_root(plan.state->path() / "slurm") {}

bool Cluster::run(const std::vector<Job*>& jobs) {
  for (Job* job : jobs) m_jobs[job->name()] = job;
  if (m_jobs.empty()) return true;
  if (!go_on() && !prepare(jobs)) return false;
  return wait();
}

/// An array of an earlier run of the batch may still be at the same work.
bool Cluster::go_on() {
  if (!fs::exists(m_root / "current", core::ignored_error())) return false;
  const std::string current = tool::read_text(m_root / "current");  // run and job
  const std::size_t blank = current.find(' ');
  const std::string name = current.substr(0, blank);
  if (fs::path(name).filename() != name) return false;
  m_folder = std::make_unique<RunFolder>(m_root / name);
  m_job = current.substr(blank + 1);
  fs::path folder;
  if (m_folder->words(folder) != m_plan.arguments.words || folder != fs::current_path() ||
      !results_fit())
    return false;
  for (std::size_t i = 0; i < m_folder->tasks(); ++i) {
    m_tasks.push_back(m_folder->task(i));
    for (const Work& work : m_tasks.back()) m_band_count[work.item.name] = work.item.bands;
  }
  collect();
  m_submissions = 1;
  if (m_jobs.empty()) return true;
  if (m_slurm.active(m_job) > 0) {
    m_progress.say("the job array " + m_job + " is at it already");
  } else {
    submit();
  }
  return true;
}

/// Scenes, options and the program are what they were when that run's rows were written, and its tasks have what is left.
bool Cluster::results_fit() const {
  const std::map<std::string, Row> results = m_folder->results();
  for (const auto& [name, row] : results) {
    const auto at = m_jobs.find(row.band.empty() ? name : name.substr(0, name.rfind('~')));
    if (at != m_jobs.end() && !at->second->fits(row)) return false;
  }
  std::set<std::string> listed;
  for (std::size_t i = 0; i < m_folder->tasks(); ++i) {
    for (const Work& work : m_folder->task(i)) listed.insert(work.item.name);
  }
  return std::ranges::all_of(m_jobs, [&](const auto& job) { return listed.contains(job.first); });
}

bool Cluster::prepare(const std::vector<Job*>& jobs) {
  m_progress.say("estimating " + std::to_string(jobs.size()) + " pictures by coarse renders");
  const auto estimates = estimates_of(m_plan, jobs, m_manifest.rows());
  if (!estimates) return false;
  const double asked = m_plan.arguments.task_time;
  const double seconds = asked > 0.0 ? asked : task_seconds(*estimates, m_slurm.processors());
  for (const Task& task : pack(*estimates, seconds)) {
    std::vector<Work> list;
    for (const Item& item : task) {
      const Job& job = *m_jobs.at(item.name);
      Work work{item, job.scene(), std::nullopt};
      if (job.frame()) work.frame = job.frame()->clock.frame_number;
      list.push_back(work);
      m_band_count[item.name] = item.bands;
    }
    m_tasks.push_back(std::move(list));
  }
  m_folder = std::make_unique<RunFolder>(m_root / run_name());
  m_folder->write(m_plan.arguments.words, m_tasks);
  submit();
  return true;
}

/// Written by this run: one that lies there may have come with the scenes.
fs::path Cluster::write_script() const {
  const fs::path script = m_folder->path() / "task.sh";
  const fs::path self = fs::read_symlink("/proc/self/exe");
  tool::write_whole(script, "#!/bin/sh\nexec " + tool::shell_word(self.string()) +
                                " --worker=" + tool::shell_word(m_folder->path().string()) +
                                " --task=\"$SLURM_ARRAY_TASK_ID\"\n");
  return script;
}

/// Those tasks of which something is left.
void Cluster::submit() {
  std::vector<std::size_t> numbers;
  double all = 0.0;
  for (std::size_t i = 0; i < m_tasks.size(); ++i) {
    const bool is_left = std::ranges::any_of(
        m_tasks[i], [this](const Work& w) { return !m_taken.contains(name_of(w.item)); });
    if (is_left) numbers.push_back(i);
    for (const Work& work : m_tasks[i]) all += work.item.seconds;
  }
  m_job = m_slurm.submit(write_script(), ranges(numbers), m_folder->path() / "logs");
  ++m_submissions;
  tool::write_whole(m_root / "current", m_folder->path().filename().string() + " " + m_job);
  m_progress.say("job array " + m_job + " of Slurm: " + std::to_string(numbers.size()) +
                 " tasks, about " + tool::duration_text(all) + " of a processor");
}

void Cluster::collect() {
  for (const auto& [name, row] : m_folder->results()) {
    if (m_taken.insert(name).second) take(row);
  }
}

void Cluster::take(const Row& row) {
  if (row.band.empty()) {
    const auto at = m_jobs.find(row.name);
    if (at == m_jobs.end()) return;
    at->second->adopt(row);
    m_manifest.put(row);
    m_jobs.erase(at);
    m_progress.finished(row);
    return;
  }
  const std::string name = row.name.substr(0, row.name.rfind('~'));
  if (!m_jobs.contains(name)) return;
  std::map<int, Row>& bands = m_bands[name];
  bands[std::atoi(row.band.c_str())] = row;
  if (static_cast<int>(bands.size()) < m_band_count[name]) return;
  std::vector<Row> all;
  for (const auto& [number, band] : bands) all.push_back(band);
  merge(name, all);
}

/// "1-60,61-120"
std::string Cluster::rows_of_bands(const std::string& name) const {
  std::map<int, std::string> rows;
  for (const std::vector<Work>& task : m_tasks) {
    for (const Work& work : task) {
      const Item& i = work.item;
      if (i.name == name)
        rows[i.band] = std::to_string(i.first_row) + "-" + std::to_string(i.last_row);
    }
  }
  return core::joined(rows, ",", [](const auto& band) { return band.second; });
}

void Cluster::merge(const std::string& name, const std::vector<Row>& bands) {
  Job& job = *m_jobs.at(name);
  Row row = joined(bands);
  const fs::path out = m_plan.arguments.out;
  row.picture = job.row().picture;
  if (row.state == State::done) {
    std::vector<std::string> command{m_plan.arguments.merge.string()};
    for (const Row& band : bands) command.push_back((out / band.picture).string());
    tool::append(command, {"--rows", rows_of_bands(name), "--out", (out / row.picture).string()});
    fs::create_directories((out / row.picture).parent_path());
    const tool::RunResult result = tool::run_program(command);
    if (result.status == 0) {
      row.bytes = fs::file_size(out / row.picture, core::ignored_error());
      row.picture_file = tool::stamp_of(out / row.picture).value_or(tool::FileStamp{});
      job.publish_statistics(bands.front());
    } else {
      row.state = State::failed;
      row.reason = "bands cannot be joined: " + tool::last_error(result.output);
    }
  }
  for (const Row& band : bands) {
    fs::remove(out / band.picture, core::ignored_error());
  }
  take(row);
}

bool Cluster::wait() {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds kAsk{3};
  auto asked = Clock::now();
  while (true) {
    collect();
    if (m_jobs.empty()) return true;
    m_progress.running(m_jobs.size());
    if (tool::wait_for_news(std::chrono::milliseconds(300)) != 0) {
      m_progress.say("the job array " + m_job +
                     " goes on; the same command collects what it does, scancel " + m_job +
                     " ends it");
      return false;
    }
    if (Clock::now() - asked < kAsk) continue;
    asked = Clock::now();
    if (m_slurm.active(m_job) > 0) continue;
    collect();
    if (m_jobs.empty()) return true;
    if (m_submissions < kMostSubmissions) {
      submit();
      continue;
    }
    const std::string why = "its tasks of Slurm ended without a result; their logs are in '" +
                            (m_folder->path() / "logs").string() + "'";
    for (auto& [name, job] : std::map(m_jobs)) {
      job->give_up(why);
      take(job->row());
    }
    return true;
  }
}

}  // namespace lentray::batch
