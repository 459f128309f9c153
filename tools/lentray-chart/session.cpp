#include "tools/lentray-chart/session.h"

#include <system_error>

#include "tools/common/companion.h"

namespace lentray::chart {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> joined(const fs::path& program, const Arguments& arguments,
                                const std::vector<std::string>& options) {
  std::vector<std::string> command{program.string()};
  command.insert(command.end(), arguments.for_lentray.begin(), arguments.for_lentray.end());
  command.insert(command.end(), options.begin(), options.end());
  command.push_back("+I" + arguments.scene);
  return command;
}

}  // namespace

Session::Session(const Arguments& what, const ChartFolder& where, const Progress& shown)
    : arguments(what), folder(where), progress(shown), runner(where.own("log")) {}

Outcome Session::lentray(const std::vector<std::string>& options, double cpu_limit) const {
  std::vector<std::string> command = joined(arguments.lentray, arguments, options);
  command.insert(command.end(), {"-V", "-D", "Count_Tests=Off", "Scene_Writes=memory"});
  return runner.run(command, cpu_limit);
}

Outcome Session::render(const std::vector<std::string>& options, const std::string& picture,
                        double cpu_limit) const {
  const std::string place = folder.file(picture).string();
  std::vector<std::string> all = options;
  all.insert(all.end(),
             {"+O" + place, "+FN16", "Statistics_File=" + folder.own("statistics.json").string()});
  const auto forget_unfinished = [&] {
    std::error_code ignored;
    fs::remove(tool::journal_path(place), ignored);
  };
  try {
    Outcome outcome = lentray(all, cpu_limit);
    if (outcome.status != 0) forget_unfinished();
    return outcome;
  } catch (const Stopped&) {
    forget_unfinished();
    throw;
  }
}

Outcome Session::diff(const std::vector<std::string>& options, double cpu_limit) const {
  std::vector<std::string> command = joined(arguments.diff, arguments, options);
  command.insert(command.end(), {"--bits=16", "--threads=1", "--povray=" + arguments.povray,
                                 "--lentray=" + arguments.lentray.string()});
  return runner.run(command, cpu_limit);
}

std::string picture_name(const std::string& id) { return "pictures/" + id + ".png"; }

}  // namespace lentray::chart
