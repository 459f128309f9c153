#include "tools/lentray-grouping/trials.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tools/common/json_text.h"
#include "tools/common/process.h"
#include "tools/common/repeats.h"

namespace lentray::grouping {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

double part(std::uint64_t a, std::uint64_t b) {
  return b == 0 ? 0.0 : static_cast<double>(a) / static_cast<double>(b);
}

fs::path program(const Arguments& arguments) {
  if (!arguments.lentray.empty()) return fs::absolute(arguments.lentray);
  return fs::read_symlink("/proc/self/exe").parent_path() / "lentray";
}

/// lentray's own words for an accelerator of ours.
std::vector<std::string> accelerator_options(const std::string& name) {
  if (name == "buffer") return {"Accelerator=bvh", "+UL"};
  return {"Accelerator=" + name, "-UL"};
}

/// Runs lentray and gives back its statistics.
json render(const Arguments& arguments, const Trial& trial, const fs::path& folder,
            const std::vector<std::string>& more) {
  std::vector<std::string> command{program(arguments).string(),
                                   "+I" + trial.scene,
                                   "Statistics_File=" + (folder / "s.json").string(),
                                   "Pixel_Order=" + trial.order,
                                   "Shadow_Cache=" + trial.cache,
                                   "+WT1",
                                   "-V"};
  const auto add = [&](const std::vector<std::string>& words) {
    command.insert(command.end(), words.begin(), words.end());
  };
  add(accelerator_options(trial.accelerator));
  if (!trial.size.empty()) add({"Declare=Size=" + trial.size});
  add(arguments.for_lentray);
  add(more);
  const tool::RunResult result = tool::run_program(command);
  if (result.status != 0) throw std::runtime_error("lentray failed:\n" + result.output);
  return tool::parse_json(tool::read_text(folder / "s.json"));
}

/// Counts, and the picture's bytes.
std::string log_run(const Arguments& arguments, Trial& trial, const fs::path& folder) {
  const fs::path picture = folder / "a.png";
  const json s =
      render(arguments, trial, folder, {"+O" + picture.string(), "+FN16", "Shadow_Log=On"});
  const json& shadow = s.at("shadow");
  trial.rays = shadow.at("rays");
  trial.blocked = shadow.at("blocked");
  trial.hits = shadow.at("cache").at("hits");
  if (trial.rays == 0) return tool::read_text(picture);
  const json& log = shadow.at("log");
  trial.pairs = log.at("pairs");
  trial.most_hits = log.at("most_hits");
  trial.tests = log.at("tests");
  trial.miss_tests = log.at("miss_tests");
  trial.runs = log.at("runs").at("count");
  trial.longest_run = log.at("runs").at("longest");
  return tool::read_text(picture);
}

std::vector<Trial> trials_of(const Arguments& arguments, const std::string& scene,
                             const std::string& size) {
  std::vector<Trial> trials;
  for (const std::string& accelerator : arguments.accelerators) {
    for (const std::string& cache : arguments.caches) {
      for (const std::string& order : arguments.orders) {
        Trial trial;
        trial.scene = scene;
        trial.size = size;
        trial.order = order;
        trial.cache = cache;
        trial.accelerator = accelerator;
        trials.push_back(std::move(trial));
      }
    }
  }
  return trials;
}

}  // namespace

double Trial::median() const { return tool::median_of(cpu_s); }
double Trial::least() const { return cpu_s.empty() ? 0.0 : std::ranges::min(cpu_s); }
double Trial::most() const { return cpu_s.empty() ? 0.0 : std::ranges::max(cpu_s); }
double Trial::tests_a_ray() const { return part(tests, rays); }
double Trial::hits_of_blocked() const { return part(hits, blocked); }
double Trial::hits_of_most() const { return part(hits, most_hits); }
double Trial::mean_run() const { return part(blocked, runs); }
double Trial::miss_cost() const { return part(miss_tests, rays - hits); }

namespace {

/// One scene in one size.
std::vector<Trial> run_scene(const Arguments& arguments, std::vector<Trial> trials,
                             const fs::path& folder,
                             const std::function<void(const std::string&)>& tell) {
  std::string first;
  for (Trial& trial : trials) {
    const std::string size = trial.size.empty() ? "" : ", size " + trial.size;
    tell(trial.scene + size + ": log of " + trial.order + ", " + trial.cache + ", " +
         trial.accelerator);
    const std::string picture = log_run(arguments, trial, folder);
    if (first.empty()) first = picture;
    trial.same_picture = picture == first;
  }
  for (int repeat = 0; repeat < arguments.repeats; ++repeat) {
    tell(trials.front().scene + ": time, round " + std::to_string(repeat + 1));
    for (Trial& trial : trials) {
      const json s = render(arguments, trial, folder, {"-F"});
      trial.cpu_s.push_back(s.at("time").at("render_cpu_s"));
    }
  }
  return trials;
}

}  // namespace

std::vector<Trial> run_trials(const Arguments& arguments,
                              const std::function<void(const std::string&)>& tell) {
  std::vector<Trial> all;
  const tool::TemporaryFolder folder;
  for (const std::string& scene : arguments.scenes) {
    for (const std::string& size : arguments.sizes) {
      std::vector<Trial> trials =
          run_scene(arguments, trials_of(arguments, scene, size), folder.path(), tell);
      std::move(trials.begin(), trials.end(), std::back_inserter(all));
    }
  }
  return all;
}

}  // namespace lentray::grouping
