// Series of points along a line: the paper's cuts through its surfaces, and sweeps into the corners
// where its equations fail. mm; each series has the answers of one or of all styles.
#pragma once

#include <string>
#include <vector>

#include "tools/lentray-model/grid.h"

namespace lentray::model {

struct Series {
  std::string axis;          ///< what x is, with its unit
  bool logarithmic = false;  ///< x
  bool logarithmic_hits = false;
  std::vector<shadow::Style> styles;
  std::vector<double> x;
  std::vector<std::vector<Point>> points;  ///< of each x, one a style
};

/// Over A at D = Slice_D, over D at A = Slice_A: within the ranges of the arguments.
Series cut_along_a(const Arguments& arguments, const shadow::PaperSheet& sheet,
                   const shadow::Style& style);
Series cut_along_d(const Arguments& arguments, const shadow::PaperSheet& sheet,
                   const shadow::Style& style);

/// near: D -> 0. theta: theta/alpha from below to above 1. small: A through ps and P. wide: P/f up
/// to total reflection and beyond. edges: Xstart across the sheet. From A = Slice_A, D = Slice_D.
Series sweep(const std::string& name, const Arguments& arguments, const shadow::PaperSheet& sheet);

/// A line for each x; closed forms printed and refracted, and what is enumerated, style by style.
std::string csv_of(const Series& series);

}  // namespace lentray::model
