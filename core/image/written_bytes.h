// How many bytes the run has written to files, and how many it may. There is one limit for the process, because all
// its files share a disk: set it before threads start. What a file loses again, and what is written twice, counts too.
// Errors: texts. Threads: any.
#pragma once

#include <cstdint>
#include <string>

namespace lentray::core {

/// Bytes; infinity, as at first: no limit.
void limit_written(double bytes);
std::uint64_t written_bytes();

/// Before so many bytes are written. Why they may not be, to follow "cannot write 'a.png': "; empty: they may, and
/// are counted.
std::string count_written(std::uint64_t bytes);

/// count_written() for a module that cannot see it; null: nobody counts.
using CountBytes = std::string (*)(std::uint64_t bytes);

/// The same of journals and other work that is kept for a later run. It takes no more than half of the limit, so that
/// the picture has the rest.
std::string count_kept(std::uint64_t bytes);

}  // namespace lentray::core
