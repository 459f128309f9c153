// Counts the files that a scene opens, to read or to write, and opens no more than it may. The scene itself does not
// count; a file counts each time that it is opened. Errors: FileRefused, besides those of the files below. One thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "parser/files/files.h"

namespace lentray::parser {

class CountedFiles final : public Files {
 public:
  CountedFiles(Files& below, std::uint64_t most) : m_below(below), m_most(most) {}

  bool exists(const std::string& path) const override { return m_below.exists(path); }
  std::optional<std::string> find_loosely(const std::string& folder,
                                          const std::string& name) const override {
    return m_below.find_loosely(folder, name);
  }
  std::optional<std::string> read(const std::string& path) const override;
  std::optional<std::string> read_scene(const std::string& path) const override {
    return m_below.read_scene(path);
  }
  std::string hold(const std::string& path) override;
  bool may_write(const std::string& path) const override { return m_below.may_write(path); }
  std::unique_ptr<FileWriter> open(const std::string& path, bool append) override;

 private:
  void count(const std::string& path) const;

  Files& m_below;
  const std::uint64_t m_most;
  mutable std::uint64_t m_count = 0;
};

}  // namespace lentray::parser
