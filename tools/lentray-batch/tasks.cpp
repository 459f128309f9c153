#include "tools/lentray-batch/tasks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lentray::batch {
namespace {

constexpr double kLongestTask = 180.0,
                 kShortest = 5.0;  ///< seconds of a task: a scheduler takes about one to start it
constexpr double kTasksAProcessor = 6.0;
constexpr std::int64_t kFewestRows = 16;

double seconds_of(const Estimate& e) { return e.fixed + e.rendering; }
double seconds_of(const Task& task) {
  return std::accumulate(task.begin(), task.end(), 0.0,
                         [](double sum, const Item& item) { return sum + item.seconds; });
}

/// Rows before band k.
std::int64_t edge(const Estimate& e, std::int64_t k, std::int64_t bands) {
  return k == bands ? e.rows : e.rows / e.grain * k / bands * e.grain;
}

int bands_of(const Estimate& e, double seconds) {
  if (e.rows < 2 * kFewestRows || seconds_of(e) <= 1.5 * seconds) return 1;
  const double room = std::max(seconds - e.fixed, e.fixed);  // what is repeated stays below a half
  const double most = static_cast<double>(e.rows / std::max(kFewestRows, e.grain));
  return static_cast<int>(std::clamp(std::ceil(e.rendering / room), 1.0, most));
}

}  // namespace

double task_seconds(const std::vector<Estimate>& pictures, int processors) {
  double all = 0.0;
  for (const Estimate& e : pictures) all += seconds_of(e);
  return std::clamp(all / (kTasksAProcessor * std::max(1, processors)), kShortest, kLongestTask);
}

std::vector<Task> pack(const std::vector<Estimate>& pictures, double seconds) {
  std::vector<Item> items;
  for (const Estimate& e : pictures) {
    const int bands = bands_of(e, seconds);
    for (int k = 0; k < bands; ++k) {
      Item item{e.name, k, bands, 1, 0, e.fixed + e.rendering / bands};
      item.first_row = 1 + edge(e, k, bands);
      item.last_row = edge(e, k + 1, bands);
      items.push_back(item);
    }
  }
  std::ranges::stable_sort(items, std::greater(), &Item::seconds);
  // Each item goes into the first task that has room for it.
  std::vector<Task> tasks;
  std::vector<double> filled;
  std::size_t open = 0;  // tasks before it are full
  for (const Item& item : items) {
    std::size_t at = open;
    while (at < tasks.size() && filled[at] + item.seconds > seconds) ++at;
    if (at == tasks.size()) {
      tasks.emplace_back();
      filled.push_back(0.0);
    }
    tasks[at].push_back(item);
    filled[at] += item.seconds;
    while (open < tasks.size() && filled[open] >= 0.999 * seconds) ++open;
  }
  std::ranges::stable_sort(tasks, std::greater(),
                           [](const Task& task) { return seconds_of(task); });
  return tasks;
}

}  // namespace lentray::batch
