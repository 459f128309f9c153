// Stacks for work that recurses, in threads and in the program's first one. They are large, and take
// memory only where they are used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace lentray::core {

/// What one level of objects or textures in each other takes of the stack at most, whatever goes through
/// them: reading, building, tracing, destroying (`ImageNestedScenes`).
constexpr std::size_t kStackBytesALevel = std::size_t{32} << 10;

/// Rays that go on from one another, at most: half of each stack has room for them, the other half for what
/// the last of them meets.
constexpr std::size_t kMostRays = 50'000;

/// The stack that the caller runs on; it grows downwards. Empty if the system does not say.
struct StackRange {
  std::uintptr_t lowest = 0;
  std::size_t bytes = 0;

  /// How many levels fit into half of it.
  std::size_t levels() const { return bytes / 2 / kStackBytesALevel; }
};
StackRange own_stack();

/// Calls `work`, which must not throw, in the calling thread and on the largest stack that the system
/// gives, up to 16 GB. On the caller's own if that is larger than any other.
void run_on_deep_stack(const std::function<void()>& work);

/// Runs `work`, which must not throw, on `count` threads at once and waits for all. On fewer if the
/// system gives no more; in the caller's, on a deep stack, if it gives none. Half of each stack has room for
/// `levels` of objects and textures in each other.
void run_on_threads(unsigned count, std::size_t levels, const std::function<void()>& work);

}  // namespace lentray::core
