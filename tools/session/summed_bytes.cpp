#include "tools/session/summed_bytes.h"

#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/byte_text.h"
#include "core/image/run_files.h"
#include "parser/files/watched_files.h"

namespace lentray::tool {

bool take_mark(std::string_view& bytes, const FileMark& mark) {
  FileMark there;
  return core::take_bytes(bytes, there) &&
         std::memcmp(there.kind, mark.kind, sizeof mark.kind) == 0 && there.version == mark.version;
}

void append_summed(std::string_view piece, std::string& out) {
  core::append_bytes(std::uint64_t{piece.size()}, out);
  core::append_bytes(parser::checksum(piece), out);
  out.append(piece);
}

bool take_summed(std::string_view& bytes, std::string_view& piece) {
  std::uint64_t size = 0, sum = 0;
  if (!core::take_bytes(bytes, size) || !core::take_bytes(bytes, sum) || bytes.size() < size)
    return false;
  piece = bytes.substr(0, size);
  bytes.remove_prefix(size);
  return parser::checksum(piece) == sum;
}

std::string take_file(int file, const std::string& path) {
  struct stat about {};
  if (file < 0 || ::fstat(file, &about) != 0) return std::strerror(errno);
  if (!S_ISREG(about.st_mode)) return "it is no regular file";
  if (about.st_nlink > 1) return "it has another name (a hard link)";
  if (core::is_input(path)) return "the scene reads it";
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) return "another run is at the same picture";
  return ::ftruncate(file, 0) != 0 ? std::strerror(errno) : "";
}

void remove_taken(int file, const std::string& path) {
  struct stat open {
  }, there{};
  if (file < 0 || ::fstat(file, &open) != 0 || ::lstat(path.c_str(), &there) != 0) return;
  if (open.st_dev == there.st_dev && open.st_ino == there.st_ino) (void)::unlink(path.c_str());
}

}  // namespace lentray::tool
