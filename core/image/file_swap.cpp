#include "core/image/file_swap.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "core/image/writer.h"

namespace lentray::core {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& place, const std::string& why) {
  throw ImageError("cannot write '" + place.string() + "': " + why);
}

/// Where the bytes go in the end, links followed.
fs::path resolved(const fs::path& place) {
  std::error_code error;
  fs::path target = fs::is_symlink(place, error) ? fs::weakly_canonical(place, error) : place;
  return error || target.empty() ? place : target;
}

bool is_device(const fs::path& place) {
  std::error_code error;
  const fs::file_status status = fs::status(place, error);
  return fs::is_character_file(status) || fs::is_fifo(status) || fs::is_block_file(status);
}

fs::path folder_of(const fs::path& place) {
  return place.has_parent_path() ? place.parent_path() : fs::path(".");
}

}  // namespace

void check_writable(const fs::path& wanted) {
  if (wanted.empty() || !wanted.has_filename()) fail(wanted, "no file name given");
  const fs::path place = resolved(wanted);
  std::error_code error;
  if (fs::is_directory(place, error)) fail(wanted, "a folder has that name");
  const fs::path folder = folder_of(place);
  if (!fs::exists(folder, error)) fail(wanted, "the folder '" + folder.string() + "' does not exist");
  if (!fs::is_directory(folder, error)) fail(wanted, "'" + folder.string() + "' is not a folder");
  if (fs::exists(place, error)) {
    if (::access(place.c_str(), W_OK) != 0) fail(wanted, std::strerror(errno));
    if (is_device(place)) return;
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    fail(wanted, "the folder '" + folder.string() + "': " + std::strerror(errno));
  }
}

FileSwap::FileSwap(const fs::path& place) : m_place(resolved(place)), m_device(is_device(m_place)) {
  check_writable(place);
  static std::atomic<unsigned> serial{0};  // only makes names differ, never seen in a result
  const std::string name = "." + m_place.filename().string() + "." + std::to_string(::getpid()) +
                           "-" + std::to_string(serial++) + ".part";
  m_temporary = (m_device ? fs::temp_directory_path() : folder_of(m_place)) / name;
}

FileSwap::~FileSwap() {
  if (m_committed) return;
  std::error_code ignored;
  fs::remove(m_temporary, ignored);
}

void FileSwap::commit() {
  if (m_device) {
    std::ifstream from(m_temporary, std::ios::binary);
    std::ofstream to(m_place, std::ios::binary);
    to << from.rdbuf();
    if (!to.flush()) fail(m_place, "writing to the device failed");
    return;  // the destructor removes the temporary file
  }
  std::error_code error;
  fs::rename(m_temporary, m_place, error);
  if (error) fail(m_place, error.message());
  m_committed = true;
}

}  // namespace lentray::core
