// The page of a chart: one HTML file. Errors: core::ImageError for pictures that are damaged. One thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "tools/lentray-chart/chart.h"

namespace lentray::chart {

struct PageOptions {
  std::filesystem::path folder;  ///< the chart's, which its pictures lie in
  std::size_t most_bytes = 20'000'000;
  bool is_finished = true;
};

std::string page(const Chart& chart, const PageOptions& options);

}  // namespace lentray::chart
