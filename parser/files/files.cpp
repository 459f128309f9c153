#include "parser/files/files.h"

#include <fcntl.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <filesystem>

#include "core/image/run_files.h"
#include "parser/base/shown.h"
#include "parser/files/loose_path.h"
#include "parser/files/opened_file.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

/// Reading a pipe could wait for ever, a device never end.
void refuse_special(const std::string& path, const struct stat& status) {
  const std::string kind = special_kind(status);
  if (kind.empty()) return;
  throw FileRefused("'" + shown_name(path) + "' is " + kind + ": a scene reads plain files only");
}

/// Opening a device may do something. /dev/null and its like, and where this program's own texts go, do not.
void refuse_device(const std::string& path) {
  constexpr unsigned kMemory = 1, kNull = 3, kZero = 5, kFull = 7;  // Linux's numbers
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return;
  bool is_harmless = !S_ISCHR(status.st_mode) && !S_ISBLK(status.st_mode);
  if (S_ISCHR(status.st_mode)) {
    const unsigned kind = minor(status.st_rdev);
    is_harmless =
        major(status.st_rdev) == kMemory && (kind == kNull || kind == kZero || kind == kFull);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
      struct stat own {};
      if (::fstat(stream, &own) == 0 && S_ISCHR(own.st_mode))
        is_harmless = is_harmless || own.st_rdev == status.st_rdev;
    }
  }
  if (is_harmless) return;
  throw FileRefused("'" + shown_name(path) + "' is a device: a scene writes plain files");
}

class Disk final : public Files {
 public:
  bool exists(const std::string& path) const override {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || S_ISDIR(status.st_mode)) return false;
    refuse_special(path, status);
    return true;
  }

  std::optional<std::string> read(const std::string& path) const override {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (!file || S_ISDIR(status_of(file).st_mode)) return std::nullopt;
    refuse_special(path, status_of(file));
    core::note_input(status_of(file), path);
    return read_all(file);
  }

  std::optional<std::string> read_scene(const std::string& path) const override {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC));
    if (file) core::note_input(status_of(file), path);
    return file ? read_all(file) : std::nullopt;
  }

  std::string hold(const std::string& path) override {
    core::note_input(path);
    return path;
  }

  bool may_write(const std::string& path) const override {
    std::error_code error;
    if (fs::exists(path, error)) {
      return !fs::is_directory(path, error) && ::access(path.c_str(), W_OK) == 0;
    }
    const std::string folder = fs::path(path).parent_path().string();
    return fs::path(path).has_filename() &&
           ::access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) == 0;
  }

  std::unique_ptr<FileWriter> open(const std::string& path, bool append) override {
    refuse_device(path);
    // A pipe that nobody reads fails instead of waiting.
    const int flags =
        O_WRONLY | O_CREAT | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | (append ? O_APPEND : O_TRUNC);
    Descriptor file(::open(path.c_str(), flags, 0666));
    if (file) ::fcntl(file.number(), F_SETFL, append ? O_APPEND : 0);
    return make_writer(std::move(file));
  }
};

}  // namespace

std::optional<std::string> Files::find_loosely(const std::string& folder,
                                               const std::string& name) const {
  return parser::find_loosely(folder, name);
}

Files& disk_files() {
  static Disk disk;
  return disk;
}

}  // namespace lentray::parser
