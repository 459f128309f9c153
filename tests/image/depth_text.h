// Reads what --depth says.
#pragma once

#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace lentray::test {

/// The number behind a text and "parallax ".
inline double parallax_behind(const std::string& output, const std::string& line) {
  std::smatch found;
  const std::regex pattern(line + "[^\n]*: parallax ([-0-9.e+]+) pixels a view");
  if (std::regex_search(output, found, pattern)) return std::stod(found[1]);
  ADD_FAILURE() << line << "\n" << output;
  return 1e300;
}

}  // namespace lentray::test
