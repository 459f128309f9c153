#include "core/image/written_bytes.h"

#include <atomic>
#include <limits>

#include "core/base/memory_limit.h"

namespace lentray::core {
namespace {

// Process-wide, as the limit is.
std::atomic<double> g_limit{std::numeric_limits<double>::infinity()};
std::atomic<std::uint64_t> g_written{0};

std::string count_within(std::uint64_t bytes, double share) {
  const double limit = g_limit;
  std::uint64_t before = g_written;
  do {
    if (static_cast<double>(before + bytes) > share * limit)
      return "the run may write " + memory_text(limit) + " (Max_Written)";
  } while (!g_written.compare_exchange_weak(before, before + bytes));
  return {};
}

}  // namespace

void limit_written(double bytes) { g_limit = bytes; }
std::uint64_t written_bytes() { return g_written; }

std::string count_written(std::uint64_t bytes) { return count_within(bytes, 1.0); }
std::string count_kept(std::uint64_t bytes) { return count_within(bytes, 0.5); }

}  // namespace lentray::core
