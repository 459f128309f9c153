// Looking things up by name in a table, and saying what there is when the name is unknown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lentray::shadow {

/// Equal but for letter case (ASCII).
bool same_name(std::string_view a, std::string_view b);

/// "unknown pixel order 'diagonal': there are rows, columns".
std::string unknown_name(std::string_view what, std::string_view name,
                         const std::vector<std::string_view>& known);

/// Of the entries of a table, in its order.
template <class Table>
std::vector<std::string_view> names_of(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& entry : table) names.push_back(entry.name);
  return names;
}

}  // namespace lentray::shadow
