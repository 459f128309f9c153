// Charts of speed against accuracy: error over processor time, both logarithmic, and beside it the times of the
// settings that leave the picture as it is.
//
// A kind has a symbol and a colour; a setting whose error is not distinguished from the reference's own change is hollow,
// in a band below ten times that change. An error of 0 stands at the foot of the axis, marked 0. Bars are the spread
// of times. The front is the least error that a time gets. Lens models have a chart of their own, as they have a
// reference of their own.
// Times in seconds of processor time, errors rms in 1/255. Settings without a time or an error are left out.
// Errors: std::runtime_error without gnuplot or with what it says. Threads: any number.
#pragma once

#include <string>
#include <vector>

#include "tools/lentray-chart/chart.h"

namespace lentray::chart {

/// Both charts as one file.
std::string chart_svg(const Chart& chart);
std::string chart_png(const Chart& chart);

/// For which windows a chart of the page is.
enum class Window { wide, narrow };
/// What the chart of errors shows.
enum class Subject { settings, lens_models };

/// SVG for the inside of a page. Every setting has a circle on top of its symbol, of the class "hit", with its id in
/// data-id, in the order of times. Empty where there is nothing to draw.
std::string error_chart(const Chart& chart, Subject subject, Window window);
std::string exact_chart(const Chart& chart, Window window);

/// Whether this chart draws that setting.
bool is_in_error_chart(const Chart& chart, const Point& point, Subject subject);
bool is_in_exact_chart(const Point& point);

/// A kind as readers read it: "area light".
std::string words_of(Kind kind);
/// A kind's symbol for legends: SVG of 16 by 16 pixels.
std::string symbol_of(Kind kind, bool is_hollow = false);

}  // namespace lentray::chart
