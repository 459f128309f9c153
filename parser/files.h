// The files a scene reads and writes: on the disk, or kept in memory where a scene must not touch
// the disk (the fuzzer). Names are paths as scenes write them. Errors: none thrown, nothing found.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace lentray::parser {

/// A file open for writing; closed when it goes.
class FileWriter {
 public:
  virtual ~FileWriter() = default;
  virtual void write(std::string_view bytes) = 0;
};

class Files {
 public:
  virtual ~Files() = default;
  /// There is such a file, and it is no folder.
  virtual bool exists(const std::string& path) const = 0;
  /// The file below `folder` ("": the current one) that Windows would mean by `name`.
  virtual std::optional<std::string> find_loosely(const std::string& folder,
                                                  const std::string& name) const = 0;
  virtual std::optional<std::string> read(const std::string& path) const = 0;
  /// Null if it cannot be opened.
  virtual std::unique_ptr<FileWriter> open(const std::string& path, bool append) = 0;
};

/// The disk; one for all, safe from any thread.
Files& disk_files();

}  // namespace lentray::parser
