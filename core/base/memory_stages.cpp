#include "core/base/memory_stages.h"

#include <malloc.h>

#include <atomic>

namespace lentray::core {
namespace {

std::atomic<const char*> g_stage{"starting"};

}  // namespace

std::uint64_t heap_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

std::uint64_t heap_bytes_since(std::uint64_t before) {
  const std::uint64_t now = heap_bytes();
  return now > before ? now - before : 0;
}

void begin_stage(const char* name) { g_stage = name; }
const char* current_stage() { return g_stage; }

}  // namespace lentray::core
