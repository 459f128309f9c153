#include "tools/common/gnuplot.h"

#include <stdexcept>

#include "tools/common/process.h"

namespace lentray::tool {

void check_gnuplot() { run_program({"gnuplot", "--version"}); }

std::string gnuplot_preamble(const std::string& format, int width, int height) {
  const std::string terminal = format == "svg" ? "svg enhanced" : "pngcairo enhanced";
  return "set terminal " + terminal + " size " + std::to_string(width) + "," +
         std::to_string(height) + " font 'Sans,10' background rgb 'white'\n" +
         "set output 'chart'\nset encoding utf8\nset tics nomirror\n";
}

std::string gnuplot(const std::string& script, const std::string& data) {
  const TemporaryFolder folder;
  write_text(folder / "data", data);
  write_text(folder / "script", script);
  const RunResult result = run_program({"gnuplot", "script"}, folder.path());
  if (result.status != 0 || !std::filesystem::exists(folder / "chart")) {
    throw std::runtime_error("gnuplot could not draw a chart: " + result.output);
  }
  return read_text(folder / "chart");
}

}  // namespace lentray::tool
