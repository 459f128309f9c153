// A batch as one HTML page that holds everything it needs and works from a file: a card a scene with its picture
// made small, integral images as views that follow the pointer, messages, times, comparisons, filters.
//
// Pictures of full size are reached by links relative to the batch's folder, where the page belongs. Times in
// seconds, sizes in bytes. Small pictures are kept in the folder, in .lentray-batch/thumbnails, by path, size and
// time of the picture; those that the page does not use are deleted there.
// Errors: none for pictures that are missing, broken or too large (the card says so) nor for text that is no UTF-8.
// Threads: one page of a folder at a time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/lentray-batch/row.h"

namespace lentray::batch {

struct PageOptions {
  enum class Stage { running, stopped, finished };  ///< only of the last no row is to come
  std::string title;
  std::filesystem::path folder;         ///< the batch's
  std::size_t most_bytes = 20'000'000;  ///< of the page; at least 100,000, which its frame takes
  Stage stage = Stage::finished;
  bool restricts = false;  ///< Restrict_IO=On: the page says so
  std::size_t expected_rows =
      0;  ///< of the batch when it is through, those that wait too: pictures get sizes that leave room
  double wall = 0.0;  ///< of the whole batch
};

/// The page. The fewer the rows, the larger the small pictures; with very many, text is cut too.
std::string page(const std::vector<Row>& rows, const PageOptions& options);

}  // namespace lentray::batch
