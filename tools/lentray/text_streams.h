// Where the texts of a run go: each of POV-Ray's five streams to the console, to a file of its own,
// or to both, and all of them to one file. Source: reference manual 3.7, "Directing Text Streams to
// Files"; what goes where measured on stock. One thread.
#pragma once

#include <array>
#include <cstdio>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "core/image/open_file.h"
#include "parser/options/options.h"
#include "parser/source/diagnostics.h"

namespace lentray::tool {

class TextStreams {
 public:
  /// Opens the files. Throws parser::OptionError if one cannot be written, core::ImageError if it is a file that the
  /// run reads. What stands in a file stays until keep(), for the scene may include it.
  explicit TextStreams(const parser::RenderOptions& options);

  /// The scene is read: what was said so far goes to its files, and what is said from now on at once. Throws
  /// core::ImageError if the run has read one of them, and leaves that one as it is.
  void keep();
  /// The same for a program that is ended in the middle of its work. Any thread.
  void keep_at_end();

  /// To the console as well, unless the stream is off there.
  void write(parser::Stream stream, std::string_view text);
  /// To the files alone.
  void log(parser::Stream stream, std::string_view text);
  /// Which file did not take all that was written to it, and why; empty: there is none.
  std::string trouble() const;

 private:
  /// A file on the disk; two streams may share it.
  struct File {
    std::string name;
    core::OpenFile file;
    bool waits = false;  ///< `file` is a temporary one, which keep() copies
  };
  File* open(const std::string& name);
  void keep(File& file);

  const bool m_append;
  std::array<bool, parser::kStreams> m_console{};
  std::array<File*, parser::kStreams> m_files{};
  File* m_all = nullptr;
  std::list<File> m_opened;
  std::mutex m_keeping;
  std::string m_limit;  ///< why files do not get more; empty: they do
};

}  // namespace lentray::tool
