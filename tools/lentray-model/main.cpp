// lentray-model: the paper's model of the shadow cache on the command line.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iostream>
#include <memory>
#include <mutex>

#include "core/image/run_files.h"
#include "tools/common/process.h"
#include "tools/common/tool_main.h"
#include "tools/lentray-model/arguments.h"
#include "tools/lentray-model/deviations.h"
#include "tools/lentray-model/figures.h"

namespace lentray::model {

using tool::write_whole;
namespace {

enum Status : int { kDone = 0, kDiffer = 2 };

/// Files are asked for before anything is computed, so that no work is lost on them.
void check_outputs(const Arguments& a) {
  core::claim_writable(a.csv, "CSV");
  core::claim_writable(a.deviations, "the deviations");
  check_figures(a);
}

/// A line on a terminal's standard error, while something is rendered.
std::function<void(double)> progress_line(bool renders) {
  if (!renders || ::isatty(STDERR_FILENO) == 0) return {};
  return [last = -1, mutex = std::make_shared<std::mutex>()](double part) mutable {
    const std::lock_guard lock(*mutex);
    const int percent = static_cast<int>(100.0 * part);
    if (percent <= last) return;
    last = percent;
    std::fprintf(stderr, "\rmeasured %d%%%s", percent, percent >= 100 ? "\n" : "");
  };
}

/// Where measured and enumerated differ, on standard error; how many there are.
std::size_t tell_differences(const Grid& grid) {
  std::size_t measured = 0, differ = 0;
  for (const StyleGrid& style : grid.styles) {
    for (const Point& p : style.points) {
      if (!p.measured) continue;
      ++measured;
      if (*p.measured == p.enumerated) continue;
      if (++differ <= 10) {
        std::cerr << "lentray-model: " << style.style.name() << " at A = " << p.a << ", D = " << p.d
                  << ": measured " << *p.measured << ", enumerated " << p.enumerated << "\n";
      }
    }
  }
  if (measured > 0) {
    std::cerr << "measured equals enumerated at " << measured - differ << " of " << measured
              << " points\n";
  }
  return differ;
}

int model(const Arguments& a) {
  check_outputs(a);
  const shadow::PaperSheet sheet(a.lens, a.lenses, a.rows);
  const auto measured = [&](const shadow::Style& style) {
    return a.measure || std::any_of(a.figures.begin(), a.figures.end(), [&](const std::string& f) {
             const shadow::Style* asked = measured_style(f);
             return asked != nullptr && *asked == style;
           });
  };
  const std::vector<shadow::Style> styles = a.styles();
  const bool renders = std::any_of(styles.begin(), styles.end(), measured);
  const bool table = a.csv.empty() && a.deviations.empty() && a.figures.empty();
  const bool needs_grid = table || !a.csv.empty() || !a.deviations.empty() ||
                          std::any_of(a.figures.begin(), a.figures.end(), shows_grid);
  Grid grid;
  if (needs_grid) grid = make_grid(a, sheet, styles, measured, progress_line(renders));
  if (!a.csv.empty()) write_whole(a.csv, csv_of(grid, a));
  if (table || !a.deviations.empty()) {
    const std::vector<Deviation> all = deviations(grid, a, sheet);
    if (!a.deviations.empty()) write_whole(a.deviations, csv_of(all));
    if (table) std::cout << table_of(all);
  }
  for (const std::string& figure : a.figures) {
    std::cout << draw_figure(figure, a, sheet, grid) << std::endl;
  }
  return tell_differences(grid) == 0 ? kDone : kDiffer;
}

}  // namespace
}  // namespace lentray::model

int main(int count, char** words) {
  using namespace lentray::model;
  return lentray::tool::tool_main({"lentray-model"}, count, words, parse_arguments, usage, model);
}
