// What follows from the points of a chart: which settings are worth their time, and which one to use. Pure functions.
#pragma once

#include "tools/lentray-chart/chart.h"

namespace lentray::chart {

/// The median of every point's times, of lentray and of stock; told_apart, on_front, dominated_by and command of every
/// point. A setting is dominated by one that has no more error in no more time, and less of one of both. Lens models
/// make a front of their own.
void derive(Chart& chart);

/// The least error of all settings whose median time is at most `seconds`; the faster one of equal ones.
Choice choose_by_budget(const Chart& chart, double seconds);
/// The fastest of all settings whose error is at most `rms`, in 1/255; the one with less error of equal ones.
Choice choose_by_error(const Chart& chart, double rms);

}  // namespace lentray::chart
