#include "core/base/deep_threads.h"

#include <pthread.h>

#include <vector>

namespace lentray::core {
namespace {

/// Some 100,000 surfaces behind one another.
constexpr std::size_t kStackBytes = std::size_t{256} << 20;

void* call(void* work) {
  (*static_cast<const std::function<void()>*>(work))();
  return nullptr;
}

}  // namespace

void run_on_threads(unsigned count, const std::function<void()>& work) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStackBytes);
  std::vector<pthread_t> threads;
  threads.reserve(count);
  void* const argument = const_cast<std::function<void()>*>(&work);
  for (unsigned i = 0; i < count; ++i) {
    pthread_t thread;
    if (pthread_create(&thread, &attributes, &call, argument) != 0) break;
    threads.push_back(thread);
  }
  pthread_attr_destroy(&attributes);
  if (threads.empty()) work();
  for (const pthread_t thread : threads) pthread_join(thread, nullptr);
}

std::uintptr_t middle_of_stack() {
  pthread_attr_t attributes;
  void* lowest = nullptr;
  std::size_t size = 0;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return 0;
  pthread_attr_getstack(&attributes, &lowest, &size);
  pthread_attr_destroy(&attributes);
  return reinterpret_cast<std::uintptr_t>(lowest) + size / 2;
}

}  // namespace lentray::core
