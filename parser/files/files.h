// The files a scene reads and writes: on the disk, below the folders that rules permit, or kept in
// memory where a scene must not touch the disk. Names are paths as scenes write them.
// Errors: FileRefused for what is there and may not be opened; what is missing is "not found".
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lentray::parser {

/// A file that may not be opened. what() names the file and the rule, ready for a message.
class FileRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file open for writing; closed when it goes.
class FileWriter {
 public:
  virtual ~FileWriter() = default;
  /// Both: what went wrong ("No space left on device"); empty if nothing did.
  virtual std::string write(std::string_view bytes) = 0;
  virtual std::string close() { return {}; }
};

/// A file that others than the parser open: what messages call it, and the name that opens it.
struct FoundFile {
  std::string path;
  std::string handle;
};

class Files {
 public:
  virtual ~Files() = default;
  /// There is such a file, it is no folder, and it may be read.
  virtual bool exists(const std::string& path) const = 0;
  /// The file below `folder` ("": the current one) that Windows would mean by `name`; not judged.
  virtual std::optional<std::string> find_loosely(const std::string& folder,
                                                  const std::string& name) const;
  virtual std::optional<std::string> read(const std::string& path) const = 0;
  /// The scene itself, which the user named: it may come through a pipe.
  virtual std::optional<std::string> read_scene(const std::string& path) const {
    return read(path);
  }
  /// A name that opens this very file, whatever becomes of `path`, as long as this object lives.
  virtual std::string hold(const std::string& path) { return path; }
  /// Whether open() would do; nothing is made.
  virtual bool may_write(const std::string& path) const = 0;
  /// Null if it cannot be opened.
  virtual std::unique_ptr<FileWriter> open(const std::string& path, bool append) = 0;
};

/// The disk; one for all, safe from any thread. Pipes can be
/// written, not read; of devices those that do nothing.
Files& disk_files();

}  // namespace lentray::parser
