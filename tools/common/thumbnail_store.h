// JPEG files that are kept from one page to the next, in a folder of their own. A name stands for a picture file as
// it is now and for what is made of it. What was not asked for is deleted at the end.
// Errors: none; where nothing can be kept, it is made again. Threads: one at a time.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>

namespace lentray::tool {

class ThumbnailStore {
 public:
  /// The folder is made when there is something to keep.
  explicit ThumbnailStore(std::filesystem::path folder) : m_folder(std::move(folder)) {}

  /// The one that is kept, or else what `make` makes of the picture, which is kept unless it is empty.
  std::string kept(const std::filesystem::path& picture, const std::string& recipe,
                   const std::function<std::string()>& make);
  void delete_others() const;

 private:
  std::filesystem::path m_folder;
  std::set<std::string> m_asked_for{};
};

}  // namespace lentray::tool
