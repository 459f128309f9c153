// The internal(N) functions that functions.inc names, by their numbers.
// Source: functions.inc and its manual section; numbers of parameters as stock counts them; values
// compared by tests/compat/language/internals.cases.
#pragma once

#include <memory>

#include "core/function/function.h"

namespace lentray::core {

/// Null if there is no such number.
std::shared_ptr<const Function> internal_function(int number);

}  // namespace lentray::core
