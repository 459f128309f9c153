#include "core/image/run_files.h"

#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "core/base/ignored_error.h"
#include "core/image/file_swap.h"
#include "core/image/writer.h"

namespace lentray::core {
namespace {

namespace fs = std::filesystem;

using FileNumber = std::pair<dev_t, ino_t>;

/// Process-wide: an output must not take the place of a file that any other part of the program reads or writes.
struct RunFiles {
  std::mutex mutex;
  std::map<FileNumber, fs::path> inputs;
  std::map<FileNumber, fs::path> made;
  std::map<fs::path, std::string> outputs;  ///< by the real path
};

RunFiles& run_files() {
  static auto* const all = new RunFiles;  // outlives whoever ends last
  return *all;
}

FileNumber number_of(const struct stat& status) { return {status.st_dev, status.st_ino}; }

std::optional<FileNumber> plain_file(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return number_of(status);
}

/// What there is under the name is a plain file, or will be.
bool may_be_plain(const fs::path& path) {
  const fs::file_status status = fs::status(path, ignored_error());
  return !fs::exists(status) || fs::is_regular_file(status);
}

/// The name of the file of that number; empty: there is none. The number of a file that was removed since
/// may have become another's.
fs::path name_of(const FileNumber& number, const std::map<FileNumber, fs::path>& files) {
  const auto found = files.find(number);
  return found != files.end() && plain_file(found->second) == number ? found->second : fs::path();
}

/// The name under which the run read the file that is there; empty: it did not.
fs::path input_at(const fs::path& place) {
  const auto number = plain_file(place);
  if (!number) return {};
  RunFiles& files = run_files();
  const std::lock_guard lock(files.mutex);
  return name_of(*number, files.inputs);
}

}  // namespace

void note_input(const struct stat& status, const fs::path& path) {
  if (!S_ISREG(status.st_mode)) return;
  RunFiles& files = run_files();
  const std::lock_guard lock(files.mutex);
  if (!name_of(number_of(status), files.made).empty()) return;
  files.inputs.insert_or_assign(number_of(status), fs::absolute(path, ignored_error()));
}

void note_input(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) note_input(status, path);
}

void note_made(const fs::path& path) {
  const auto number = plain_file(path);
  if (!number) return;
  RunFiles& files = run_files();
  const std::lock_guard lock(files.mutex);
  files.made.insert_or_assign(*number, fs::absolute(path, ignored_error()));
  files.inputs.erase(*number);
}

bool is_made(const fs::path& path) {
  const auto number = plain_file(path);
  if (!number) return false;
  RunFiles& files = run_files();
  const std::lock_guard lock(files.mutex);
  return !name_of(*number, files.made).empty();
}

bool is_input(const fs::path& place) { return !input_at(place).empty(); }

void check_not_input(const fs::path& place) {
  const fs::path input = input_at(place);
  if (input.empty()) return;
  const bool other_name =
      fs::absolute(place, ignored_error()).lexically_normal() != input.lexically_normal();
  throw ImageError("cannot write " + shown_place(place) + ": this run reads that file" +
                   (other_name ? ", as '" + input.string() + "'" : "") +
                   "; give the output another name");
}

void claim_output(const fs::path& place, std::string_view what) {
  if (place.empty() || place == "-" || !may_be_plain(place)) return;
  check_not_input(place);
  std::error_code error;
  fs::path real = fs::weakly_canonical(fs::absolute(place, error), error);
  if (error) real = place;
  RunFiles& files = run_files();
  const std::lock_guard lock(files.mutex);
  const auto number = plain_file(real);
  for (const auto& [other, owner] : files.outputs) {
    if (owner == what) continue;
    if (other != real && !(number && plain_file(other) == number)) continue;
    throw ImageError("cannot write " + shown_place(place) + ": it is the file of both " + owner +
                     " and " + std::string(what));
  }
  files.outputs.insert_or_assign(std::move(real), std::string(what));
}

void claim_writable(const fs::path& place, std::string_view what) {
  if (place.empty() || place == "-") return;
  check_writable(place);
  claim_output(place, what);
}

void forget_run_files() {
  RunFiles& files = run_files();
  const std::lock_guard lock(files.mutex);
  files.inputs.clear();
  files.made.clear();
  files.outputs.clear();
}

}  // namespace lentray::core
