#include "core/base/deep_threads.h"

#include <pthread.h>
#include <sys/mman.h>
#include <ucontext.h>

#include <algorithm>
#include <vector>

namespace lentray::core {
namespace {

/// Sanitizers follow the stacks that threads are started with, and take more of them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMaySwitchStacks = false;
constexpr std::size_t kStackBytesARay = std::size_t{12} << 10;
#else
constexpr bool kMaySwitchStacks = true;
constexpr std::size_t kStackBytesARay = std::size_t{3} << 10;
#endif
constexpr std::size_t kThreadStackBytes = 2 * kMostRays * kStackBytesARay;
constexpr std::size_t kDeepestStackBytes = std::size_t{16} << 30;

/// Set while the thread runs on a stack that it was not started with.
thread_local StackRange t_deep_stack;

StackRange first_stack() {
  pthread_attr_t attributes;
  void* lowest = nullptr;
  std::size_t size = 0;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return {};
  pthread_attr_getstack(&attributes, &lowest, &size);
  pthread_attr_destroy(&attributes);
  return {reinterpret_cast<std::uintptr_t>(lowest), size};
}

void* call(void* work) {
  (*static_cast<const std::function<void()>*>(work))();
  return nullptr;
}

/// A context starts with a function without arguments.
thread_local const std::function<void()>* t_work = nullptr;
void call_work() { (*t_work)(); }

}  // namespace

StackRange own_stack() {
  if (t_deep_stack.bytes > 0) return t_deep_stack;
  thread_local const StackRange first = first_stack();
  return first;
}

void run_on_deep_stack(const std::function<void()>& work) {
  // Not a thread: that would have memory of its own from malloc, apart from the first thread's.
  constexpr int kPages = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK;
  const std::size_t own = own_stack().bytes;
  std::size_t bytes = kMaySwitchStacks ? kDeepestStackBytes : 0;
  void* lowest = MAP_FAILED;
  for (; bytes > own && lowest == MAP_FAILED; bytes /= 2) {
    lowest = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, kPages, -1, 0);
    if (lowest != MAP_FAILED) break;
  }
  if (lowest == MAP_FAILED) return work();
  ucontext_t here, deep;
  getcontext(&deep);
  deep.uc_stack.ss_sp = lowest;
  deep.uc_stack.ss_size = bytes;
  deep.uc_link = &here;
  makecontext(&deep, &call_work, 0);
  t_work = &work;
  t_deep_stack = {reinterpret_cast<std::uintptr_t>(lowest), bytes};
  swapcontext(&here, &deep);
  t_deep_stack = {};
  munmap(lowest, bytes);
}

void run_on_threads(unsigned count, std::size_t levels, const std::function<void()>& work) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes,
                            std::max(kThreadStackBytes, 2 * levels * kStackBytesALevel));
  std::vector<pthread_t> threads;
  threads.reserve(count);
  void* const argument = const_cast<std::function<void()>*>(&work);
  for (unsigned i = 0; i < count; ++i) {
    pthread_t thread;
    if (pthread_create(&thread, &attributes, &call, argument) != 0) break;
    threads.push_back(thread);
  }
  pthread_attr_destroy(&attributes);
  if (threads.empty()) run_on_deep_stack(work);
  for (const pthread_t thread : threads) pthread_join(thread, nullptr);
}

}  // namespace lentray::core
