// lentray-grouping: pixel orders and shadow caches put to the test on scenes.
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "core/image/run_files.h"
#include "tools/common/gnuplot.h"
#include "tools/common/own_folder.h"
#include "tools/common/process.h"
#include "tools/common/tool_main.h"
#include "tools/lentray-grouping/report.h"

namespace lentray::grouping {
namespace {

enum Status : int { kDone = 0, kDiffer = 2 };

int experiment(const Arguments& arguments) {
  for (const std::string& scene : arguments.scenes) core::note_input(scene);
  core::claim_writable(arguments.csv, "the table");
  core::claim_writable(arguments.html, "the page");
  tool::refuse_foreign_page(arguments.html, "lentray-grouping");
  core::claim_writable(arguments.gains, "the gains");
  if (!arguments.html.empty()) tool::check_gnuplot();
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  const std::vector<Trial> trials = run_trials(arguments, [&](const std::string& what) {
    if (terminal) std::cerr << what << std::endl;
  });
  std::cout << table_of(trials);
  if (!arguments.csv.empty()) tool::write_whole(arguments.csv, csv_of(trials));
  if (!arguments.gains.empty()) tool::write_whole(arguments.gains, gains_csv_of(trials));
  if (!arguments.html.empty())
    tool::write_whole(arguments.html, html_of(trials, arguments.command));
  const bool same =
      std::all_of(trials.begin(), trials.end(), [](const Trial& t) { return t.same_picture; });
  return same ? kDone : kDiffer;
}

}  // namespace
}  // namespace lentray::grouping

int main(int count, char** words) {
  using namespace lentray::grouping;
  return lentray::tool::tool_main({"lentray-grouping"}, count, words, parse_arguments, usage,
                                  experiment);
}
