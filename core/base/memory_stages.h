// What the stages of a run hold in memory, one after the other: from a scene's text to what a picture is traced
// with. Bytes. Any number of threads.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace lentray::core {

struct MemoryStage {
  std::string_view name;
  std::uint64_t bytes = 0;
};
using MemoryStages = std::vector<MemoryStage>;

/// What the program has asked the allocator for and not given back; 0 where that is unknown.
std::uint64_t heap_bytes();
/// What has been added since heap_bytes() was `before`; 0 if it has become less.
std::uint64_t heap_bytes_since(std::uint64_t before);

/// What the process works on; of literals alone. There is one for the process, because a thread that sees its memory
/// grow too large ends all of it and says where.
void begin_stage(const char* name);
const char* current_stage();

}  // namespace lentray::core
