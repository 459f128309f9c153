#include "parser/files.h"

#include <cstdio>
#include <filesystem>

#include "parser/loose_path.h"

namespace lentray::parser {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

class DiskWriter final : public FileWriter {
 public:
  explicit DiskWriter(File file) : m_file(std::move(file)) {}
  void write(std::string_view bytes) override {
    std::fwrite(bytes.data(), 1, bytes.size(), m_file.get());
  }

 private:
  File m_file;
};

class Disk final : public Files {
 public:
  bool exists(const std::string& path) const override {
    std::error_code error;
    return std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error);
  }

  std::optional<std::string> find_loosely(const std::string& folder,
                                          const std::string& name) const override {
    return parser::find_loosely(folder, name);
  }

  std::optional<std::string> read(const std::string& path) const override {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return std::nullopt;
    const File file(std::fopen(path.c_str(), "rbe"), &std::fclose);
    if (!file) return std::nullopt;
    const auto size = std::filesystem::file_size(path, error);  // an error for pipes
    // One byte more than there is, so that the first piece is the last.
    std::size_t piece = error ? 0 : static_cast<std::size_t>(size) + 1;
    std::string bytes;
    bytes.reserve(piece);
    for (std::size_t end = 0;; piece = 0) {
      constexpr std::size_t kPiece = std::size_t{1} << 16;
      bytes.resize(end + (piece ? piece : kPiece));
      const std::size_t wanted = bytes.size() - end;
      const std::size_t got = std::fread(bytes.data() + end, 1, wanted, file.get());
      end += got;
      if (got == wanted) continue;
      bytes.resize(end);
      break;
    }
    if (std::ferror(file.get())) return std::nullopt;
    return bytes;
  }

  std::unique_ptr<FileWriter> open(const std::string& path, bool append) override {
    File file(std::fopen(path.c_str(), append ? "ab" : "wb"), &std::fclose);
    return file ? std::make_unique<DiskWriter>(std::move(file)) : nullptr;
  }
};

}  // namespace

Files& disk_files() {
  static Disk disk;
  return disk;
}

}  // namespace lentray::parser
