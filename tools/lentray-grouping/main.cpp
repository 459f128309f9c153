// lentray-grouping: pixel orders and shadow caches put to the test on scenes.
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <iostream>

#include "core/image/run_files.h"
#include "core/image/writer.h"
#include "parser/base/shown.h"
#include "tools/common/gnuplot.h"
#include "tools/common/process.h"
#include "tools/common/standard_streams.h"
#include "tools/common/version.h"
#include "tools/lentray-grouping/report.h"

namespace lentray::grouping {
namespace {

enum Status : int { kDone = 0, kError = 1, kDiffer = 2 };

int experiment(const Arguments& arguments, const std::string& command) {
  for (const std::string& scene : arguments.scenes) core::note_input(scene);
  for (const auto& [place, what] : {std::pair{arguments.csv, "the table"},
                                    {arguments.html, "the page"},
                                    {arguments.gains, "the gains"}}) {
    if (place.empty()) continue;
    core::check_writable(place);
    core::claim_output(place, what);
  }
  if (!arguments.html.empty()) tool::check_gnuplot();
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  const std::vector<Trial> trials = run_trials(arguments, [&](const std::string& what) {
    if (terminal) std::cerr << what << std::endl;
  });
  std::cout << table_of(trials);
  if (!arguments.csv.empty()) tool::write_whole(arguments.csv, csv_of(trials));
  if (!arguments.gains.empty()) tool::write_whole(arguments.gains, gains_csv_of(trials));
  if (!arguments.html.empty()) tool::write_whole(arguments.html, html_of(trials, command));
  const bool same =
      std::all_of(trials.begin(), trials.end(), [](const Trial& t) { return t.same_picture; });
  return same ? kDone : kDiffer;
}

int run_main(const std::vector<std::string>& words) {
  try {
    const Arguments arguments = parse_arguments(words);
    if (arguments.help) {
      std::cout << usage();
      return kDone;
    }
    if (arguments.version) {
      std::cout << "lentray-grouping " << tool::kVersion << std::endl;
      return kDone;
    }
    std::string command = "lentray-grouping";
    for (const std::string& word : words) command += " " + word;
    return experiment(arguments, command);
  } catch (const std::exception& e) {
    std::cerr << "lentray-grouping: " << parser::shown_text(e.what()) << std::endl;
    return kError;
  }
}

}  // namespace
}  // namespace lentray::grouping

int main(int count, char** words) {
  lentray::tool::hold_standard_streams();
  const int status =
      lentray::grouping::run_main(std::vector<std::string>(words + 1, words + count));
  return lentray::tool::finish_standard_output("lentray-grouping", status);
}
