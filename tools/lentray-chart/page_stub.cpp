// Stands in for the page until it is merged.
#include "tools/lentray-chart/page.h"
#include "tools/lentray-chart/table.h"

namespace lentray::chart {

std::string page(const Chart& chart, const PageOptions&) {
  return "<!DOCTYPE html>\n<meta charset=\"utf-8\"><title>Chart</title>\n<pre>" +
         front_table(chart) + "</pre>\n";
}

}  // namespace lentray::chart
