#include "parser/restrictions/restricted_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>

#include "core/image/run_files.h"
#include "parser/base/shown.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

/// `place`: where it really lies, if that is known.
[[noreturn]] void refuse(const std::string& path, const std::string& place,
                         const std::string& rule) {
  const bool elsewhere = !place.empty() && place != path;
  throw FileRefused("Restrict_IO: '" + shown_name(path) + "'" +
                    (elsewhere ? " (" + shown_name(place) + ")" : "") + " is refused: " + rule);
}

void refuse_special(const std::string& path, const std::string& place, const struct stat& status) {
  const std::string kind = special_kind(status);
  if (!kind.empty()) refuse(path, place, "it is " + kind + ", and a scene opens plain files only");
}

/// Where a name that means nothing would lie.
fs::path would_lie(const std::string& path) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? fs::path() : place;
}

}  // namespace

/// A hold on a file that may be read. Empty if there is none; whether there is one where a scene may not
/// look is not told.
Descriptor RestrictedFiles::judged(const std::string& path) const {
  if (path.empty()) return Descriptor();
  Descriptor held = look_at(path);
  const bool is_folder = held && S_ISDIR(status_of(held).st_mode);
  const std::string place = held ? real_path(held) : would_lie(path).string();
  const std::string rule = m_rules.against_reading(is_folder ? place + "/." : place);
  if (!rule.empty()) refuse(path, place, rule);
  if (!held || is_folder) return Descriptor();
  refuse_special(path, place, status_of(held));
  return held;
}

bool RestrictedFiles::exists(const std::string& path) const {
  return static_cast<bool>(judged(path));
}

std::optional<std::string> RestrictedFiles::read(const std::string& path) const {
  const Descriptor held = judged(path);
  const Descriptor file = held ? reopen(held, O_RDONLY) : Descriptor();
  if (file) core::note_input(status_of(file), path);
  return file ? read_all(file) : std::nullopt;
}

/// The user named it, but what it is a link to may be the stranger's choice. A pipe is the user's.
std::optional<std::string> RestrictedFiles::read_scene(const std::string& path) const {
  const Descriptor held = look_at(path);
  if (!held || special_kind(status_of(held)) == "a pipe") return disk_files().read_scene(path);
  return read(path);
}

std::string RestrictedFiles::hold(const std::string& path) {
  Descriptor held = judged(path);
  if (!held) refuse(path, "", "it is not there any more");
  const struct stat status = status_of(held);
  core::note_input(status, path);
  const auto [at, is_new] = m_held.try_emplace({status.st_dev, status.st_ino}, std::move(held));
  return handle_of(at->second);
}

/// A hold on the file that is there already, if it may be written. Empty if there is none.
Descriptor RestrictedFiles::judged_to_write(const std::string& path) const {
  Descriptor held = look_at(path);
  if (!held) {
    struct stat link {};
    if (::lstat(path.c_str(), &link) == 0 && S_ISLNK(link.st_mode)) {
      refuse(path, would_lie(path).string(), "it is a link to a file that is not there");
    }
    return held;
  }
  const std::string place = real_path(held);
  const std::string rule = m_rules.against_writing(place);
  if (!rule.empty()) refuse(path, place, rule);
  const struct stat status = status_of(held);
  if (!S_ISDIR(status.st_mode)) refuse_special(path, place, status);
  if (S_ISREG(status.st_mode) && status.st_nlink > 1) {
    refuse(path, place, "it has another name (a hard link), perhaps where a scene may not write");
  }
  return held;
}

/// A hold on the folder that a new file may be made in. Empty if there is no such folder.
Descriptor RestrictedFiles::judged_folder(const std::string& path) const {
  const fs::path name(path);
  Descriptor folder = look_at(name.has_parent_path() ? name.parent_path().string() : ".");
  const fs::path place = folder ? fs::path(real_path(folder)) / name.filename() : would_lie(path);
  const std::string rule = m_rules.against_writing(place);
  if (!rule.empty()) refuse(path, place.string(), rule);
  return name.has_filename() ? std::move(folder) : Descriptor();
}

bool RestrictedFiles::may_write(const std::string& path) const {
  if (const Descriptor held = judged_to_write(path)) {
    return S_ISREG(status_of(held).st_mode) && ::access(handle_of(held).c_str(), W_OK) == 0;
  }
  const Descriptor folder = judged_folder(path);
  return folder && ::access(handle_of(folder).c_str(), W_OK | X_OK) == 0;
}

std::unique_ptr<FileWriter> RestrictedFiles::open(const std::string& path, bool append) {
  if (const Descriptor held = judged_to_write(path)) {
    return make_writer(reopen(held, O_WRONLY | (append ? O_APPEND : O_TRUNC)));
  }
  const Descriptor folder = judged_folder(path);
  if (!folder) return nullptr;
  const int flags =
      O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_NOCTTY | O_CLOEXEC | (append ? O_APPEND : 0);
  return make_writer(
      Descriptor(::openat(folder.number(), fs::path(path).filename().c_str(), flags, 0666)));
}

}  // namespace lentray::parser
