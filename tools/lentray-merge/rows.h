// Rows of a picture, counted from 1 at the top, as +SR and +ER count them; both ends included.
// Errors: std::invalid_argument with the reason. Pure.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lentray::merge {

struct Rows {
  std::uint32_t first = 1, last = 0;
  bool holds(std::uint32_t row) const { return first <= row && row <= last; }
  bool operator==(const Rows&) const = default;
};

/// "61-120", or "61" for one row.
Rows rows_of(std::string_view text);
/// "rows 1 to 60 and 181 to 240", "row 7".
std::string text_of(const std::vector<Rows>& all);
/// What none of them holds of a picture of that height, from the top.
std::vector<Rows> missing_rows(std::vector<Rows> all, std::uint32_t height);

}  // namespace lentray::merge
