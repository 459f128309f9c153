// The internal(N) functions that functions.inc names, by their numbers.
// Source: functions.inc and its manual section; numbers of parameters as stock counts them; values
// compared by tests/compat/language/internals.cases.
#pragma once

#include <memory>

#include "core/function/function.h"

namespace lentray::core {

/// Null if there is no such number. `noise_generator` is the scene's, for f_noise3d: it may still
/// change while the scene is read. Without one it is 2.
std::shared_ptr<const Function> internal_function(
    int number, std::shared_ptr<const int> noise_generator = nullptr);

}  // namespace lentray::core
