// Remembers what was read of the files below it, so that it can be seen later whether they are still the same.
// What the scene itself writes is not remembered. Errors: those of the files below. One thread.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "parser/files/files.h"

namespace lentray::parser {

/// A checksum of contents, no protection against forgery.
std::uint64_t checksum(std::string_view bytes);
/// Of a file on the disk; empty if it cannot be read.
std::optional<std::uint64_t> file_checksum(const std::string& path);

class WatchedFiles final : public Files {
 public:
  explicit WatchedFiles(Files& below) : m_below(below) {}
  /// Checksums by path.
  const std::map<std::string, std::uint64_t>& seen() const { return m_seen; }
  /// Paths that were looked for in vain.
  const std::set<std::string>& missing() const { return m_missing; }
  /// Paths of files that were found and not read.
  const std::set<std::string>& there() const { return m_there; }
  /// Paths that the scene wrote.
  const std::set<std::string>& written() const { return m_written; }

  bool exists(const std::string& path) const override;
  std::optional<std::string> find_loosely(const std::string& folder,
                                          const std::string& name) const override {
    return m_below.find_loosely(folder, name);
  }
  std::optional<std::string> read(const std::string& path) const override;
  std::optional<std::string> read_scene(const std::string& path) const override;
  std::string hold(const std::string& path) override;
  bool may_write(const std::string& path) const override { return m_below.may_write(path); }
  std::unique_ptr<FileWriter> open(const std::string& path, bool append) override;

 private:
  void saw(const std::string& path, std::uint64_t sum) const;

  Files& m_below;
  mutable std::map<std::string, std::uint64_t> m_seen;
  mutable std::set<std::string> m_missing, m_there;
  std::set<std::string> m_written;
};

}  // namespace lentray::parser
