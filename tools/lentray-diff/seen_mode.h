// lentray-diff --seen: how far two integral images are apart for an eye before their lens sheet, on
// the terminal, as JSON and as pictures. What is measured is in eye_measure.h.
// Errors: core::ImageError, parser::OptionError and std::runtime_error, worded for the user. One
// thread.
#pragma once

#include "tools/lentray-diff/seen_arguments.h"

namespace lentray::diff {

/// The exit status: what is measured does not change it.
int compare_seen(const SeenArguments& arguments);

}  // namespace lentray::diff
