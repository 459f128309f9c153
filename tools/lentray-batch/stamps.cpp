#include "tools/lentray-batch/stamps.h"

#include <sys/stat.h>
#include <time.h>

#include "parser/files/watched_files.h"

namespace lentray::batch {
namespace {

std::int64_t nanoseconds(const timespec& t) {
  return std::int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec;
}

/// Without checksum.
std::optional<FileStamp> outside_of(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileStamp{static_cast<std::uint64_t>(status.st_size), nanoseconds(status.st_mtim), 0};
}

}  // namespace

std::optional<FileStamp> stamp_of(const std::filesystem::path& path) {
  auto stamp = outside_of(path);
  const auto sum = parser::file_checksum(path.string());
  if (!stamp || !sum) return std::nullopt;
  stamp->sum = *sum;
  return stamp;
}

FileStamp stamp_read(const std::filesystem::path& path, std::uint64_t sum, std::int64_t since) {
  FileStamp stamp = outside_of(path).value_or(FileStamp{});
  stamp.sum = sum;
  if (stamp.modified >= since) stamp.modified = 0;  // the checksum is to decide
  return stamp;
}

bool is_as_it_was(const std::filesystem::path& path, const FileStamp& stamp) {
  const auto now = outside_of(path);
  if (!now) return false;
  if (now->size == stamp.size && now->modified == stamp.modified) return true;
  return parser::file_checksum(path.string()) == stamp.sum;
}

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_REALTIME, &time);
  return nanoseconds(time);
}

std::int64_t modified(const std::filesystem::path& path) {
  const auto stamp = outside_of(path);
  return stamp ? stamp->modified : 0;
}

}  // namespace lentray::batch
