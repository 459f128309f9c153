// Joins parts of a picture into the picture.
//
// Rows are read from the parts and written at once: memory is taken for a few rows of every part that is known to
// have the row, or may have it. A part that is known to have certain rows is opened when the first is wanted.
// Errors: core::ImageError, worded for the user: rows that no part has, rows in which parts disagree, parts of
// different pictures, files that cannot be read or written. What stood at `out` before is then still whole.
// Threads: one call a thread.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "tools/lentray-merge/rows.h"

namespace lentray::merge {

struct Part {
  std::filesystem::path path;
  std::optional<Rows> rows{};  ///< none: those that the file says, or all that are not black
};

void join(const std::vector<Part>& parts, const std::filesystem::path& out);

}  // namespace lentray::merge
