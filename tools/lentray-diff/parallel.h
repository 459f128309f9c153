// Work that waits for other programs, on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace lentray::diff {

/// Runs job(0) .. job(count - 1), `processes` at a time; throws the first error.
template <class Job>
void in_parallel(std::uint32_t count, int processes, const Job& job) {
  std::atomic<std::uint32_t> next{0};
  std::mutex guard;
  std::exception_ptr error;
  const auto work = [&] {
    for (std::uint32_t i = next++; i < count; i = next++) {
      try {
        job(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(guard);
        if (!error) error = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> threads;
  const auto wanted =
      std::min<std::uint32_t>(count, static_cast<std::uint32_t>(std::max(1, processes)));
  for (std::uint32_t i = 0; i < wanted; ++i) threads.emplace_back(work);
  for (std::thread& t : threads) t.join();
  if (error) std::rethrow_exception(error);
}

}  // namespace lentray::diff
