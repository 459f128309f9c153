// Processor time, in seconds. Any number of threads.
#pragma once

#include <ctime>

namespace lentray::core {

/// Of the process, over all its threads.
inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace lentray::core
