// Threads for work that recurses: their stacks are large, and take memory only where they are used.
#pragma once

#include <cstdint>
#include <functional>

namespace lentray::core {

/// Runs `work`, which must not throw, on `count` threads at once and waits for all. On fewer if the
/// system gives no more; on the caller's own if it gives none.
void run_on_threads(unsigned count, const std::function<void()>& work);

/// The address in the middle of the calling thread's stack, which grows downwards.
std::uintptr_t middle_of_stack();

}  // namespace lentray::core
