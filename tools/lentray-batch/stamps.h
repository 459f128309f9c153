// Files as they were when they were read, and whether they still are. Errors: none; a file that cannot be read has
// no stamp. Threads: any number.
#pragma once

#include <filesystem>
#include <optional>

#include "tools/lentray-batch/row.h"

namespace lentray::batch {

/// Of a file whose checksum is not known yet.
std::optional<FileStamp> stamp_of(const std::filesystem::path& path);
/// Of a file that had this checksum when a run read it, which began at `since` (ns since 1970): what changed meanwhile
/// counts as changed.
FileStamp stamp_read(const std::filesystem::path& path, std::uint64_t sum, std::int64_t since);
/// Size and time decide; where they differ, the checksum.
bool is_as_it_was(const std::filesystem::path& path, const FileStamp& stamp);

/// Now, ns since 1970, by the clock of the file system's times.
std::int64_t now();
/// When a file was written; 0: there is none.
std::int64_t modified(const std::filesystem::path& path);

}  // namespace lentray::batch
