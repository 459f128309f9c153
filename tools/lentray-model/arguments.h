// The command line of lentray-model: its own options, and the lens's as lentray has them.
// Errors: parser::OptionError, worded for the user. Pure.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "camera/lens_sheet.h"
#include "shadow/hit_model/enumeration.h"

namespace lentray::model {

/// first:last:step, both ends included.
struct Range {
  double first = 0.0, last = 0.0, step = 1.0;
  std::vector<double> values() const;
};

struct Arguments {
  camera::LensParameters lens;           ///< the paper's unless said otherwise
  std::uint32_t lenses = 133, rows = 0;  ///< rows 0: as many as columns
  Range a{0.5, 40.0, 1.0}, d{0.0, 40.0, 1.0};
  double x = 0.3;
  std::optional<double> y;                ///< none: as x
  double slice_a = 20.0, slice_d = 13.0;  ///< where figures cut and sweeps stand
  std::vector<std::uint32_t> strip_widths, strip_heights;
  shadow::paper::Alpha alpha = shadow::paper::Alpha::kPrinted;
  std::filesystem::path csv, deviations;  ///< empty: none
  std::vector<std::string> figures;       ///< names of figure_names()
  std::filesystem::path folder = ".";     ///< of the figures
  std::string format = "png";             ///< or svg
  bool measure = false;
  int threads = 0;  ///< 0: all of the machine

  double start_down() const { return y.value_or(x); }
  shadow::ShadowSquare shadow(double size, double distance) const {
    return {size, distance, x, start_down()};
  }
  /// The paper's five, and fixed strips.
  std::vector<shadow::Style> styles() const;
};

Arguments parse_arguments(const std::vector<std::string>& words);
std::string usage();

}  // namespace lentray::model
