#include "tools/lentray-merge/rows.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace lentray::merge {
namespace {

std::uint32_t number_of(std::string_view text, std::string_view all) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number == 0) {
    throw std::invalid_argument("'" + std::string(all) + "' are no rows; 1-60 is the form");
  }
  return number;
}

}  // namespace

Rows rows_of(std::string_view text) {
  const std::size_t dash = text.find('-');
  Rows rows;
  rows.first = number_of(text.substr(0, dash), text);
  rows.last = dash == std::string_view::npos ? rows.first : number_of(text.substr(dash + 1), text);
  if (rows.last < rows.first)
    throw std::invalid_argument("'" + std::string(text) + "' end before they start");
  return rows;
}

std::string text_of(const std::vector<Rows>& all) {
  const bool one = all.size() == 1 && all[0].first == all[0].last;
  std::string text = one ? "row " : "rows ";
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) text += i + 1 == all.size() ? " and " : ", ";
    text += std::to_string(all[i].first);
    if (all[i].last > all[i].first) text += " to " + std::to_string(all[i].last);
  }
  return text;
}

std::vector<Rows> missing_rows(std::vector<Rows> all, std::uint32_t height) {
  std::sort(all.begin(), all.end(), [](const Rows& a, const Rows& b) { return a.first < b.first; });
  std::vector<Rows> missing;
  std::uint32_t next = 1;
  for (const Rows& rows : all) {
    if (rows.first > next) missing.push_back({next, rows.first - 1});
    next = std::max(next, rows.last + 1);
  }
  if (next <= height) missing.push_back({next, height});
  return missing;
}

}  // namespace lentray::merge
