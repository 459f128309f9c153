// Files in memory: a scene reads what it is given and what it has written itself, and the disk
// stays as it was. Not thread-safe.
#pragma once

#include <map>

#include "parser/files/files.h"

namespace lentray::test {

class MemoryFiles final : public parser::Files {
 public:
  /// Texts that many scenes share: read, never written.
  using Library = std::map<std::string, std::string>;

  explicit MemoryFiles(const Library& library) : m_library(library) {}
  void add(std::string path, std::string text) { m_own[std::move(path)] = std::move(text); }

  bool exists(const std::string& path) const override;
  std::optional<std::string> find_loosely(const std::string& folder,
                                          const std::string& name) const override;
  std::optional<std::string> read(const std::string& path) const override;
  bool may_write(const std::string& path) const override { return !path.empty(); }
  std::unique_ptr<parser::FileWriter> open(const std::string& path, bool append) override;

 private:
  const Library& m_library;
  std::map<std::string, std::string> m_own;
};

}  // namespace lentray::test
