// One run of `sheet`: reads the pictures, fits and arranges them, writes the pages.
// Errors: PageError, core::ImageError, parser::OptionError, worded for the user. One thread.
#pragma once

#include "tools/lentray-print/arguments.h"
#include "tools/lentray-print/commands.h"
#include "tools/lentray-print/page.h"

namespace lentray::print {

Report run_sheet(const Arguments& arguments);

/// Mirrored and turned as the arguments have it, or turned for pictures whose lenses lie across.
Page finished(Page page, const Arguments& arguments, bool is_across = false);

}  // namespace lentray::print
