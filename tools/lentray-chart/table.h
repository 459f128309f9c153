// The chart as CSV and as a short table for a terminal. Pure functions.
#pragma once

#include <string>

#include "tools/lentray-chart/chart.h"

namespace lentray::chart {

/// A row a setting; docs/accuracy.md gives the columns.
std::string csv_of(const Chart& chart);

/// The settings on the front, the fastest first; lens models below them.
std::string front_table(const Chart& chart);

}  // namespace lentray::chart
