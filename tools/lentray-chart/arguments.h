// The command line of lentray-chart: its own options, and lentray's, which hold for every picture of the chart.
// Errors: parser::OptionError, worded for the user. Reads INI files; pure otherwise.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "parser/options/options.h"
#include "tools/lentray-chart/chart.h"

namespace lentray::chart {

struct Arguments {
  std::string scene;          ///< as given
  std::filesystem::path out;  ///< the chart's folder, as given
  int repeats = 3;
  std::optional<double> budget;  ///< s of processor time
  std::optional<double> error;   ///< rms, 1/255
  std::vector<Kind> only;        ///< empty: all that apply
  bool with_stock = true;
  bool quick = false;                   ///< fewer settings
  double reference_limit = 600.0;       ///< s of processor time
  std::filesystem::path lentray, diff;  ///< programs
  std::string povray = "povray";
  std::vector<std::string>
      for_lentray;  ///< the user's options, in order, with +WT1 unless they say threads
  parser::RenderOptions options;  ///< what those say, without default INI files
};

Arguments parse_arguments(const std::vector<std::string>& words);
std::string usage();

/// Whether settings of that kind are wanted.
bool wants(const Arguments& arguments, Kind kind);

}  // namespace lentray::chart
