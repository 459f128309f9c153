// Takes errors of the standard library that the caller does not ask about. Threads: each has its own.
#pragma once

#include <system_error>

namespace lentray::core {

inline std::error_code& ignored_error() {
  thread_local std::error_code error;
  return error;
}

}  // namespace lentray::core
