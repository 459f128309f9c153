#include "tools/lentray-batch/worker.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "parser/files/watched_files.h"
#include "tools/common/json_text.h"
#include "tools/common/machine.h"
#include "tools/lentray-batch/run_folder.h"
#include "tools/lentray-batch/scheduler.h"

namespace lentray::batch {

namespace fs = std::filesystem;

namespace {

/// No other process has it: the node's name and the process's number.
std::string worker_name(int task) {
  char host[256] = "";
  ::gethostname(host, sizeof host - 1);
  const char* node = std::getenv("SLURMD_NODENAME");
  return std::string(node != nullptr ? node : host) + "-" + std::to_string(::getpid()) + "-" +
         std::to_string(task);
}

double number_of(const char* variable, double otherwise) {
  const char* text = std::getenv(variable);
  const double number = text == nullptr ? 0.0 : std::strtod(text, nullptr);
  return number > 0.0 ? number : otherwise;
}

/// What Slurm gives the task.
void share_of_node(Plan& plan) {
  plan.processors = static_cast<int>(number_of("SLURM_CPUS_PER_TASK", 1.0));
  constexpr double kMegabyte = 1024.0 * 1024.0;
  const double machine = tool::machine_memory();
  plan.memory = std::min(
      machine, number_of("SLURM_MEM_PER_NODE",
                         number_of("SLURM_MEM_PER_CPU", machine / kMegabyte / plan.processors) *
                             plan.processors) *
                   kMegabyte);
}

void append(const fs::path& file, const Row& row) {
  const std::string line = tool::json_text(json_of(row)) + "\n";
  const int out = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  const bool is_written =
      out >= 0 && ::write(out, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  if (!is_written || ::close(out) != 0)
    throw std::runtime_error("cannot write '" + file.string() + "': " + std::strerror(errno));
}

std::unique_ptr<Job> job_of(const Plan& plan, const Work& work) {
  const Scene& scene = work.scene;
  const bool has_ini = !scene.ini.empty();
  if (!is_below(scene.name) || folders_of(plan.arguments.inputs, scene.source).empty() ||
      (has_ini &&
       fs::path(scene.ini).replace_extension() != fs::path(scene.source).replace_extension()))
    throw std::runtime_error("a task names '" + scene.source.string() +
                             "', which is no scene of this batch");
  const parser::RenderOptions options = options_of(plan, work.scene);
  std::optional<parser::AnimationFrame> frame;
  if (work.frame) {
    for (const parser::AnimationFrame& f : pictures_of(options)) {
      if (f.clock.frame_number == *work.frame) frame = f;
    }
  }
  std::optional<Band> band;
  const Item& i = work.item;
  if (i.bands > 1) band = Band{i.band, i.bands, i.first_row, i.last_row};
  return std::make_unique<Job>(plan, work.scene, options, frame, band);
}

}  // namespace

int do_task(const Arguments& arguments) {
  const RunFolder folder(fs::absolute(arguments.worker));
  fs::path where;
  const std::vector<std::string> words = folder.words(where);
  fs::current_path(where);
  Plan plan;
  plan.arguments = parse_arguments(words);
  share_of_node(plan);
  const std::string worker = worker_name(arguments.task);
  plan.scratch = folder.scratch(worker);
  fs::create_directories(plan.scratch);
  const StateFolder state(plan.arguments.out, StateFolder::Access::shared);
  plan.state = &state;
  plan.program = parser::file_checksum(plan.arguments.lentray.string()).value_or(0);

  const std::map<std::string, Row> known = folder.results();
  const fs::path results = folder.result_file(worker);
  BatchProgress progress(0, 0, 0, true);
  Scheduler scheduler(
      plan, [&](const Row& row) { append(results, row); }, progress);
  for (const Work& work : folder.task(static_cast<std::size_t>(arguments.task))) {
    if (!known.contains(name_of(work.item))) scheduler.add(job_of(plan, work));
  }
  const bool is_done = scheduler.run();
  std::error_code ignored;
  fs::remove_all(plan.scratch, ignored);
  return is_done ? 0 : 3;
}

}  // namespace lentray::batch
