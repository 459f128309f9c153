#include "core/image/file_swap.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/ignored_error.h"
#include "core/image/run_files.h"
#include "core/image/writer.h"

namespace lentray::core {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kStandardOutput = "-", kMark = ".lentray-", kEnd = ".part";
constexpr std::size_t kLongestName = 180;  ///< what is added must fit into 255 bytes

[[noreturn]] void fail(const fs::path& place, const std::string& why) {
  throw ImageError("cannot write " + shown_place(place) + ": " + why);
}

/// Where the bytes go in the end, links followed.
fs::path resolved(const fs::path& place) {
  std::error_code error;
  fs::path target = fs::is_symlink(place, error) ? fs::weakly_canonical(place, error) : place;
  return error || target.empty() ? place : target;
}

bool is_device(const fs::path& place) {
  const fs::file_status status = fs::status(place, ignored_error());
  return fs::is_character_file(status) || fs::is_fifo(status) || fs::is_block_file(status);
}

fs::path folder_of(const fs::path& place) {
  return place.has_parent_path() ? place.parent_path() : fs::path(".");
}

std::string stem_of(const fs::path& place) {
  return "." + place.filename().string().substr(0, kLongestName) + std::string(kMark);
}

/// Temporary files that nobody holds a lock on: their makers were killed.
void remove_left_over(const fs::path& folder, const std::string& stem) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(stem) || !name.ends_with(kEnd)) continue;
    const int file = ::open(at->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (file < 0) continue;
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) (void)::unlink(at->path().c_str());
    ::close(file);
  }
}

}  // namespace

int open_device(const fs::path& place) {
  constexpr int kLooks = 50;
  constexpr timespec kBetween{0, 20'000'000};
  for (int look = 1;; ++look) {
    const int file = ::open(place.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (file >= 0) {
      const int flags = ::fcntl(file, F_GETFL);
      (void)::fcntl(file, F_SETFL, flags & ~O_NONBLOCK);
      return file;
    }
    if (errno != ENXIO) return -1;
    if (look == kLooks) fail(place, "nobody reads from that pipe");
    ::nanosleep(&kBetween, nullptr);
  }
}

std::string shown_place(const fs::path& place) {
  return place == kStandardOutput ? "to standard output" : "'" + place.string() + "'";
}

void check_writable(const fs::path& wanted) {
  if (wanted.empty() || !wanted.has_filename()) fail(wanted, "no file name given");
  const fs::path place = resolved(wanted);
  if (fs::is_directory(place, ignored_error())) fail(wanted, "a folder has that name");
  const fs::path folder = folder_of(place);
  if (!fs::exists(folder, ignored_error()))
    fail(wanted, "the folder '" + folder.string() + "' does not exist");
  if (!fs::is_directory(folder, ignored_error()))
    fail(wanted, "'" + folder.string() + "' is not a folder");
  check_not_input(place);
  if (fs::exists(place, ignored_error())) {
    if (::access(place.c_str(), W_OK) != 0) fail(wanted, std::strerror(errno));
    if (is_device(place)) return;
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    fail(wanted, "the folder '" + folder.string() + "': " + std::strerror(errno));
  }
}

std::string why_not_writable(const fs::path& path) {
  try {
    check_writable(path);
    return {};
  } catch (const ImageError& error) {
    return error.what();
  }
}

namespace {

/// Temporary files there are. Process-wide: who ends the program in the middle of its work, on a signal or for want
/// of memory, holds none of the objects that made them.
struct Temporaries {
  std::mutex mutex;
  std::set<fs::path> files;
};
Temporaries& temporaries() {
  static auto* const all = new Temporaries;  // outlives whoever ends last
  return *all;
}

}  // namespace

/// Where files cannot be flushed at all, none is.
static bool tells_of_loss(int error) { return error == EIO || error == ENOSPC || error == EDQUOT; }

/// That a file has its name.
static void flush_folder(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  (void)::fsync(file);
  ::close(file);
}

void FileSwap::remove_temporaries() {
  const std::lock_guard lock(temporaries().mutex);
  for (const fs::path& file : temporaries().files) (void)::unlink(file.c_str());
}

FileSwap::FileSwap(const fs::path& place) : m_place(place) {
  if (place == kStandardOutput) {
    m_device = true;
  } else {
    check_writable(place);
    m_place = resolved(place);
    m_device = is_device(m_place);
    // Before the work: the pipe of nobody is an error at once.
    if (m_device && (m_to = open_device(m_place)) < 0) fail(m_place, std::strerror(errno));
  }
  make_temporary();
}

FileSwap::~FileSwap() {
  const std::lock_guard lock(temporaries().mutex);
  temporaries().files.erase(m_temporary);
  if (!m_committed) fs::remove(m_temporary, ignored_error());
  ::close(m_lock);
  if (m_to >= 0) ::close(m_to);
}

void FileSwap::make_temporary() {
  std::error_code error;
  const fs::path folder = m_device ? fs::temp_directory_path(error) : folder_of(m_place);
  if (error) fail(m_place, error.message());
  const std::string stem = stem_of(m_place);
  remove_left_over(folder, stem);
  static std::atomic<unsigned> serial{0};  // only makes names differ, never seen in a result
  while (m_lock < 0) {
    m_temporary = folder / (stem + std::to_string(::getpid()) + "-" + std::to_string(serial++) +
                            std::string(kEnd));
    m_lock =
        ::open(m_temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, m_device ? 0600 : 0666);
    if (m_lock < 0) {
      if (errno == EEXIST) continue;
      fail(m_place, std::strerror(errno));
    }
    // Where there are no locks nothing is cleared away.
    while (::flock(m_lock, LOCK_EX) != 0 && errno == EINTR) {
    }
    struct stat there {};
    if (::fstat(m_lock, &there) == 0 && there.st_nlink > 0) break;
    ::close(m_lock);  // taken for a left-over before it was locked
    m_lock = -1;
  }
  const std::lock_guard lock(temporaries().mutex);
  temporaries().files.insert(m_temporary);
}

void FileSwap::copy_to_device() {
  const bool out = m_place == kStandardOutput;
  const int from = ::open(m_temporary.c_str(), O_RDONLY | O_CLOEXEC);
  const int to = out ? STDOUT_FILENO : std::exchange(m_to, -1);
  std::string why = from < 0 || to < 0 ? std::strerror(errno) : "";
  std::vector<char> buffer(1 << 18);
  while (why.empty()) {
    const ssize_t got = ::read(from, buffer.data(), buffer.size());
    if (got == 0) break;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) why = std::strerror(errno);
    for (ssize_t done = 0; done < got;) {
      const ssize_t put = ::write(to, buffer.data() + done, static_cast<std::size_t>(got - done));
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) {
        why = std::strerror(errno);
        break;
      }
      done += put;
    }
  }
  if (from >= 0) ::close(from);
  if (!out && to >= 0 && ::close(to) != 0 && why.empty()) why = std::strerror(errno);
  if (!why.empty()) fail(m_place, why);
}

void FileSwap::commit() {
  if (m_device) return copy_to_device();  // the destructor removes the temporary file
  std::error_code error;
  struct stat before {};
  if (::stat(m_place.c_str(), &before) == 0) (void)::fchmod(m_lock, before.st_mode & 07777);
  check_not_input(m_place);
  if (::fsync(m_lock) != 0 && tells_of_loss(errno)) fail(m_place, std::strerror(errno));
  fs::rename(m_temporary, m_place, error);
  if (error) fail(m_place, error.message());
  flush_folder(folder_of(m_place));
  note_made(m_place);
  m_committed = true;
  // A process that was killed holds its locks until it is gone, which may be after this one began.
  remove_left_over(folder_of(m_place), stem_of(m_place));
}

}  // namespace lentray::core
