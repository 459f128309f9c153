// The command line of lentray-merge. Errors: parser::OptionError, worded for the user. Pure.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/lentray-merge/rows.h"

namespace lentray::merge {

struct Arguments {
  std::vector<std::filesystem::path> parts;
  std::vector<Rows> rows;  ///< of each part; empty: as the parts say
  std::filesystem::path out;
};

Arguments parse_arguments(const std::vector<std::string>& words);
std::string usage();

}  // namespace lentray::merge
