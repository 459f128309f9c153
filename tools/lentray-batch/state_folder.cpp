#include "tools/lentray-batch/state_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "core/base/ignored_error.h"
#include "tools/common/companion.h"

namespace lentray::batch {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostReserved = 4 << 20;  ///< bytes: some thousand rows
constexpr std::size_t kFrame = 96 << 10;        ///< bytes of a page without pictures
constexpr std::size_t kPicture = 60 << 10;  ///< of a row and a small picture, which is there twice

}  // namespace

void StateFolder::reserve(std::size_t pictures) const {
  const int file = ::open((path() / "reserve").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return;
  // Where there is no room for it there may be room for pictures all the same.
  (void)::posix_fallocate(
      file, 0, static_cast<off_t>(std::min(kMostReserved, kFrame + pictures * kPicture)));
  ::close(file);
}

void StateFolder::forget_radiosity() const {
  fs::remove_all(radiosity_folder(), core::ignored_error());
}

StateFolder::~StateFolder() {
  if (is_alone()) free_reserve();
}

/// Of the files of a picture's runs. Names of scenes may be as long as names can be.
fs::path StateFolder::begin_of(const std::string& name) const {
  const std::string whole = (path() / "runs" / name).string();
  const std::string longest_end(48, '.');  // key and kind
  const std::string with_end = tool::companion_path(whole, longest_end);
  return with_end.substr(0, with_end.size() - longest_end.size());
}

fs::path StateFolder::file(const std::string& name, const std::string& key,
                           const std::string& kind) const {
  const fs::path place = begin_of(name).string() + "." + key + "." + kind;
  tool::make_folder(place.parent_path(), place.parent_path());
  return place;
}

void StateFolder::forget_others(const std::string& name, const std::string& key) const {
  const fs::path place = begin_of(name);
  const std::string begin = place.filename().string() + ".", ours = begin + key;
  std::error_code error;
  for (fs::directory_iterator at(place.parent_path(), error), end; !error && at != end;
       at.increment(error)) {
    const std::string file = at->path().filename().string();
    // "<name>.<16 digits>.<kind>", of frames and views "<name>.<16 digits><number>.<kind>"
    const std::size_t end_of_key = file.find_first_not_of("0123456789abcdef", begin.size());
    if (!file.starts_with(begin) || file.starts_with(ours) || end_of_key == std::string::npos ||
        file[end_of_key] != '.' || end_of_key < begin.size() + 16)
      continue;
    fs::remove(at->path(), core::ignored_error());
  }
}

bool StateFolder::free_reserve() const {
  return fs::remove(path() / "reserve", core::ignored_error());
}

}  // namespace lentray::batch
