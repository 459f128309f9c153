// What lentray-views does, by its arguments. Pictures appear whole or not at all.
// Errors: core::ImageError and parser::OptionError, worded for the user. One thread.
#pragma once

#include <string>

#include "tools/lentray-views/arguments.h"

namespace lentray::views {

/// What is to be said on standard output: the sheet, or the names of the files that were written.
std::string do_task(const Arguments& arguments);

}  // namespace lentray::views
