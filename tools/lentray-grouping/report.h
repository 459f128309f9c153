// What the experiment found, as CSV, as a table and as a page with charts. Pure but for gnuplot,
// which draws the charts. Errors: std::runtime_error without gnuplot.
#pragma once

#include <string>
#include <vector>

#include "tools/lentray-grouping/trials.h"

namespace lentray::grouping {

std::string csv_of(const std::vector<Trial>& trials);
std::string table_of(const std::vector<Trial>& trials);
/// One page that holds everything, charts as SVG.
std::string html_of(const std::vector<Trial>& trials, const std::string& command);

/// The trials of one scene and accelerator.
using Group = std::vector<Trial>;
std::vector<Group> groups_of(const std::vector<Trial>& trials);

/// Equation 1 put to the times of a group: seconds = rest + per_test x tests, by least squares.
struct CostFit {
  double rest = 0.0, per_test = 0.0;  ///< s
};
CostFit fit_cost(const Group& group);

/// What `columns` saves against `rows` and against `views` with one cache: parts of the time,
/// measured, and as equation 2 has it from the hits and the fit.
struct Gain {
  std::string cache;
  double miss_cost = 0.0;  ///< Cm/Ch, in tests; the mean of the three orders
  double against_rows = 0.0, against_views = 0.0;
  double predicted_rows = 0.0, predicted_views = 0.0;
};
/// Empty unless the group has all three orders.
std::vector<Gain> gains_of(const Group& group);

}  // namespace lentray::grouping
