// What lentray-views does, by its arguments. Pictures appear whole or not at all.
// Errors: core::ImageError and parser::OptionError, worded for the user. One thread.
#pragma once

#include <string>
#include <vector>

#include "tools/lentray-views/arguments.h"

namespace lentray::views {

struct Report {
  std::string said;  ///< lines: the sheet, or the names of the files that were written
  std::vector<std::string> warnings{};
};
Report do_task(const Arguments& arguments);

}  // namespace lentray::views
