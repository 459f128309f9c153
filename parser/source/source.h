// Source texts and places in them. A SourceManager owns every file read in a run.
// A place is the number of a byte: only a message asks for the line and column. One thread.
//
// Texts are kept as bytes: a UTF-8 mark at the start is dropped, CR LF and a lone CR become LF,
// Latin-1 and UTF-8 pass through untouched (they can only matter in strings).
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/files/files.h"

namespace lentray::parser {

/// A place in a source: small, copied freely. file 0 is "nowhere" (built in, command line).
struct Location {
  std::uint32_t file = 0;
  std::uint32_t offset = 0;  ///< bytes from the start of the text; modulo 2^32
};

/// The same for people: both count from 1, columns in bytes. 0 is "nowhere".
struct Position {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

class SourceManager {
 public:
  /// `disk` is where files are looked for; it must outlive this.
  explicit SourceManager(Files& disk = disk_files()) : m_disk(disk) {}

  /// Where this scene's files are, those that it writes too.
  Files& disk() const { return m_disk; }

  /// Reads a file; its number, or nullopt if it cannot be read. Every call reads anew: a scene may
  /// write a file and include it again.
  std::optional<std::uint32_t> load(const std::string& path);
  /// A text that is no file (tests, Declare=); `name` appears in messages.
  std::uint32_t add(std::string name, std::string text);

  const std::string& name(std::uint32_t file) const;  ///< "" for file 0
  std::string_view text(std::uint32_t file) const;
  Position position(const Location& where) const;
  /// "name:line:column"; "" if it is nowhere.
  std::string place(const Location& where) const;
  /// The line of a place without its end; empty if there is none.
  std::string_view line(const Location& where) const;
  std::size_t files() const { return m_files.size(); }

 private:
  struct File {
    std::string name;
    std::string text;
    mutable std::vector<std::size_t> line_starts;  ///< found when a message first asks

    std::size_t line_at(std::size_t offset) const;  ///< counts from 0
  };
  const File* find(std::uint32_t file) const;
  Files& m_disk;
  std::deque<File> m_files;  // number - 1; views into texts stay valid
};

}  // namespace lentray::parser
