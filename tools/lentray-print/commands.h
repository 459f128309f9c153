// What the commands of lentray-print do: pages into files, and a report of them.
// Errors: parser::OptionError, PageError, core::ImageError, core::NoRoom, worded for the user. One thread.
#pragma once

#include <string>
#include <vector>

#include "tools/lentray-print/arguments.h"

namespace lentray::print {

struct Report {
  std::vector<std::string> lines, warnings;
};

Report run_command(const Arguments& arguments);

}  // namespace lentray::print
