// The folder of a program in the folder that it writes into, such as DIR/.lentray-chart. One run of the program works
// there at a time. Errors: std::runtime_error, worded for the user. One thread.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace lentray::tool {

/// Makes the folder and those above it. `shown`: the folder that the message names.
void make_folder(const std::filesystem::path& folder, const std::filesystem::path& shown);

/// For outputs of strangers' scenes: throws where the folder holds links, or hard links among the files that programs write
/// to in place, a manifest and those of an OwnFolder. They may have come with the scenes.
void refuse_links(const std::filesystem::path& out);

/// Throws where a file of that name stands that has something in it and is not of the program, as `is_ours` says.
void refuse_foreign(const std::filesystem::path& file, const std::string& program,
                    const std::function<bool(const std::filesystem::path&)>& is_ours);
/// Of a page: one of the program says so in its head (PageParts::generator).
void refuse_foreign_page(const std::filesystem::path& page, const std::string& program);

class OwnFolder {
 public:
  /// Makes DIR/.PROGRAM. Throws where that cannot be done. `is_alone`: throws also while another run works there.
  OwnFolder(const std::filesystem::path& out, const std::string& program, bool is_alone = true);
  ~OwnFolder();
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  const std::filesystem::path& path() const { return m_path; }

 protected:
  bool is_alone() const { return m_lock >= 0; }

 private:
  std::filesystem::path m_path;
  int m_lock = -1;
};

}  // namespace lentray::tool
