// What the experiment found, as CSV, as a table and as a page with charts. Pure but for gnuplot,
// which draws the charts. Errors: std::runtime_error without gnuplot.
#pragma once

#include <string>
#include <vector>

#include "tools/lentray-grouping/trials.h"

namespace lentray::grouping {

std::string csv_of(const std::vector<Trial>& trials);
/// gains_of() for every group, a line each.
std::string gains_csv_of(const std::vector<Trial>& trials);
std::string table_of(const std::vector<Trial>& trials);
/// One page that holds everything: tables that sort, charts as SVG, light and dark.
std::string html_of(const std::vector<Trial>& trials, const std::string& command);

/// The trials of one scene, size and accelerator.
using Group = std::vector<Trial>;
std::vector<Group> groups_of(const std::vector<Trial>& trials);

/// Equation 1 put to the times of a group: seconds = rest + per_test x tests, by least squares.
struct CostFit {
  double rest = 0.0, per_test = 0.0;  ///< s
};
CostFit fit_cost(const Group& group);

/// What `columns` saves against another order with the same cache, as parts.
struct Gain {
  std::string cache, against;
  double miss_cost = 0.0;  ///< Cm/Ch, in tests; the mean of the two orders
  double time = 0.0;       ///< of the time of rendering
  double tests = 0.0;      ///< of the tests for shadow rays: what equation 1 counts
  double equation2 = 0.0;  ///< of those as equation 2 has them, from the hits alone
};
/// Against `rows` and `views`, as far as the group has these orders.
std::vector<Gain> gains_of(const Group& group);

}  // namespace lentray::grouping
