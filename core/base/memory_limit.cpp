#include "core/base/memory_limit.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <limits>

#include "core/base/formed.h"

namespace lentray::core {
namespace {

std::atomic<double> g_limit{std::numeric_limits<double>::infinity()};

}  // namespace

double resident_bytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

void limit_memory(double bytes) { g_limit = bytes; }
double memory_limit() { return g_limit; }

void check_room(double bytes) {
  constexpr double kSmall = 1 << 20;
  const double limit = g_limit;
  if (bytes < kSmall || limit == std::numeric_limits<double>::infinity()) return;
  const double left = std::max(0.0, limit - resident_bytes());
  if (bytes > left) {
    throw NoRoom("this takes " + memory_text(bytes) + " of memory, and " + memory_text(left) +
                 " are left (Max_Memory)");
  }
}

std::string memory_text(double bytes) {
  const char* unit = "MB";
  double value = bytes / 1e6;
  for (const char* next : {"GB", "TB", "PB"}) {
    if (value < 1000.0) break;
    value /= 1000.0;
    unit = next;
  }
  return formed("%.3g %s", value, unit);
}

}  // namespace lentray::core
