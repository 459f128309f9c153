// The internal(N) functions that functions.inc names. Those that are plain arithmetic can be
// evaluated; the others are kept, know their parameters, and say so by not_yet().
// Source: functions.inc and its manual section; numbers of parameters as stock counts them; values
// held by tests/compat/language_functions_test.cpp.
#pragma once

#include <memory>

#include "core/function/function.h"

namespace lentray::core {

/// Null if there is no such number.
std::shared_ptr<const Function> internal_function(int number);

}  // namespace lentray::core
