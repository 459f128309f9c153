// What this process and its machine have and use. Any number of threads.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/cpu_seconds.h"

namespace lentray::tool {

using core::cpu_seconds;
/// Seconds of processor time of the calling thread.
double thread_cpu_seconds();
/// Of programs that this one ran and that have ended, with all that they ran.
double cpu_seconds_of_children();

/// Bytes: the most that was held; of the machine (infinite where it does not say).
std::uint64_t peak_bytes();
double machine_memory();

/// The model of the processor as the system names it; "processor" where it does not say.
std::string processor_name();

}  // namespace lentray::tool
