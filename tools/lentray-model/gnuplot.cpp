#include "tools/lentray-model/gnuplot.h"

#include <stdexcept>

#include "core/image/file_swap.h"
#include "tools/lentray-diff/process.h"

namespace lentray::model {

void check_gnuplot() { diff::run({"gnuplot", "--version"}); }

std::string gnuplot_preamble(const std::string& format, int width, int height) {
  const std::string terminal = format == "svg" ? "svg enhanced" : "pngcairo enhanced";
  return "set terminal " + terminal + " size " + std::to_string(width) + "," +
         std::to_string(height) + " font 'Sans,10' background rgb 'white'\n" +
         "set output 'chart'\nset encoding utf8\nset tics nomirror\n";
}

std::string gnuplot(const std::string& script, const std::string& data) {
  const diff::TemporaryFolder folder;
  diff::write_text(folder / "data", data);
  diff::write_text(folder / "script", script);
  const diff::RunResult result = diff::run({"gnuplot", "script"}, folder.path());
  if (result.status != 0 || !std::filesystem::exists(folder / "chart")) {
    throw std::runtime_error("gnuplot could not draw a chart: " + result.output);
  }
  return diff::read_text(folder / "chart");
}

void write_whole(const std::filesystem::path& place, const std::string& bytes) {
  core::FileSwap swap(place);
  diff::write_text(swap.temporary(), bytes);
  swap.commit();
}

}  // namespace lentray::model
