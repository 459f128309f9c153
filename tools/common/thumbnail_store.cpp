#include "tools/common/thumbnail_store.h"

#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include "core/base/formed.h"
#include "tools/common/process.h"

namespace lentray::tool {
namespace {

namespace fs = std::filesystem;

/// FNV-1a of 64 bits.
std::uint64_t sum_of(std::string_view text, std::uint64_t sum) {
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return sum;
}

/// The name of what `recipe` makes of the picture; nothing where there is no such file.
std::optional<std::string> thumbnail_name(const fs::path& picture, const std::string& recipe) {
  std::error_code error;
  if (!fs::is_regular_file(picture, error)) return std::nullopt;
  const std::uintmax_t size = fs::file_size(picture, error);
  if (error) return std::nullopt;
  const auto modified = fs::last_write_time(picture, error).time_since_epoch().count();
  if (error) return std::nullopt;
  const std::string text = picture.string() + '\n' + std::to_string(size) + '\n' +
                           std::to_string(modified) + '\n' + recipe;
  return core::formed("%016llx%016llx.jpg",
                      static_cast<unsigned long long>(sum_of(text, 0xcbf29ce484222325u)),
                      static_cast<unsigned long long>(sum_of(text, 0x6c62272e07bb0142u)));
}

void keep_jpeg(const fs::path& whole, const std::string& jpeg) {
  std::error_code error;
  fs::create_directories(whole.parent_path(), error);
  const fs::path part = whole.string() + ".part";
  std::ofstream file(part, std::ios::binary);
  file.write(jpeg.data(), static_cast<std::streamsize>(jpeg.size()));
  file.close();
  if (file) fs::rename(part, whole, error);
  if (!file || error) fs::remove(part, error);
}

}  // namespace

std::string ThumbnailStore::kept(const fs::path& picture, const std::string& recipe,
                                 const std::function<std::string()>& make) {
  const auto name = thumbnail_name(picture, recipe);
  if (!name) return make();
  m_asked_for.insert(*name);
  std::string jpeg = file_bytes(m_folder / *name);
  if (jpeg.starts_with("\xff\xd8") && jpeg.ends_with("\xff\xd9")) return jpeg;
  jpeg = make();
  if (!jpeg.empty()) keep_jpeg(m_folder / *name, jpeg);
  return jpeg;
}

void ThumbnailStore::delete_others() const {
  std::error_code error;
  for (fs::directory_iterator at(m_folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (m_asked_for.count(at->path().filename().string()) == 0) fs::remove(at->path(), ignored);
  }
}

}  // namespace lentray::tool
