// A disk that is read and never written: what a scene writes stays in memory, where it finds it again
// in place of the file on the disk. For runs that must leave nothing behind (--parse-only, --dump).
// Errors: FileRefused of the files below it. One thread.
#pragma once

#include <map>
#include <vector>

#include "parser/files/files.h"
#include "parser/files/opened_file.h"

namespace lentray::parser {

class MemoryWrites final : public Files {
 public:
  explicit MemoryWrites(Files& below) : m_below(below) {}

  bool exists(const std::string& path) const override;
  std::optional<std::string> find_loosely(const std::string& folder,
                                          const std::string& name) const override;
  std::optional<std::string> read(const std::string& path) const override;
  std::optional<std::string> read_scene(const std::string& path) const override;
  std::string hold(const std::string& path) override;
  bool may_write(const std::string& path) const override;
  std::unique_ptr<FileWriter> open(const std::string& path, bool append) override;

 private:
  std::shared_ptr<std::string> find(const std::string& path) const;

  Files& m_below;
  std::map<std::string, std::shared_ptr<std::string>>
      m_texts;  ///< by the path without links and dots
  /// A text as it was when it was asked for.
  struct Held {
    std::shared_ptr<std::string> text;
    std::size_t size = 0;
    Descriptor file;
  };
  std::vector<Held> m_held;
};

}  // namespace lentray::parser
