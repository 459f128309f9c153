// A chart as one HTML page that holds everything it needs and works from a file: error over time, every setting with its
// picture, its difference from the reference, times, errors and command, what to choose for a time or an error, and two
// pictures compared.
//
// Pictures of full size are reached by links relative to the chart's folder, where the page belongs. Times in seconds
// of processor time, sizes in bytes. Small pictures are kept in the folder, in .lentray-chart/thumbnails, by path, size
// and time of the picture; those that the page does not use are deleted there.
// Errors: none for pictures that are missing, broken or too large nor without gnuplot (the page says so), nor for text
// that is no UTF-8. Threads: one page of a folder at a time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "tools/lentray-chart/chart.h"

namespace lentray::chart {

struct PageOptions {
  std::filesystem::path folder;  ///< the chart's
  /// Of the page; at least 100,000 and 4,000 a setting, which its frame, charts and text take.
  std::size_t most_bytes = 20'000'000;
  bool is_finished = true;  ///< no setting is to come
};

/// The page. The fewer the settings, the larger the small pictures.
std::string page(const Chart& chart, const PageOptions& options);

}  // namespace lentray::chart
