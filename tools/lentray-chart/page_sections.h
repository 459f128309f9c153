// The parts of a chart's page that are there without its script, as HTML: headline, filters, the table of settings and
// the reference. Text of scenes and options is escaped. Pure functions; threads: any number. Errors: none.
#pragma once

#include <string>

#include "tools/lentray-chart/page.h"
#include "tools/lentray-chart/page_pictures.h"

namespace lentray::chart {

/// "12 of 40 settings are measured, 2 failed. Still running."
std::string status_line(const Chart& chart, bool is_finished);
/// Rows of a definition list: the machine, the picture, stock, the reference.
std::string tiles(const Chart& chart);
/// Buttons: all, the front, each kind that there is, those that failed.
std::string filters(const Chart& chart);
/// What symbols and the band mean.
std::string legend(const Chart& chart);

/// What becomes of a setting, in words: "on the front", "plain is better", "failed: no such file".
std::string verdict(const Chart& chart, const Point& point);
/// Rows of the table, a row a setting.
std::string table_rows(const Chart& chart);

/// How far a reference is converged, and every step to it.
std::string reference_text(const Reference& reference, const std::string& problem);

}  // namespace lentray::chart
