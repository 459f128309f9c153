// The command line of lentray-grouping: its own options, and lentray's, which go to it
// as they are. Errors: parser::OptionError. Pure.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lentray::grouping {

struct Arguments {
  std::vector<std::string> scenes;
  std::vector<std::string> orders, caches;  ///< all there are, unless said otherwise
  std::vector<std::string> accelerators{"bvh"};
  std::vector<std::string> sizes{""};  ///< of the scenes, Declare=Size=; "": as they are
  int repeats = 5;                     ///< 0: no times
  std::filesystem::path csv, html, gains;
  std::filesystem::path lentray;  ///< the program; empty: beside this one
  std::vector<std::string> for_lentray;
  std::string command = "lentray-grouping";  ///< as it was typed
};

/// At commas outside brackets: "rows,strips(4,8)" is two.
std::vector<std::string> list_of(const std::string& text);
Arguments parse_arguments(const std::vector<std::string>& words);
std::string usage();

}  // namespace lentray::grouping
