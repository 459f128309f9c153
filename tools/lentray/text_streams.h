// Where the texts of a run go: each of POV-Ray's five streams to the console, to a file of its own,
// or to both, and all of them to one file. Source: reference manual 3.7, "Directing Text Streams to
// Files"; what goes where measured on stock. One thread.
#pragma once

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "parser/options/options.h"
#include "parser/source/diagnostics.h"

namespace lentray::tool {

class TextStreams {
 public:
  /// Opens the files. Throws parser::OptionError if one cannot be written.
  explicit TextStreams(const parser::RenderOptions& options);

  /// To the console as well, unless the stream is off there.
  void write(parser::Stream stream, std::string_view text);
  /// To the files alone.
  void log(parser::Stream stream, std::string_view text);
  /// Which file did not take all that was written to it, and why; empty: there is none.
  std::string trouble() const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  struct File {
    std::unique_ptr<std::FILE, Close> file;
    std::string name;
  };
  static File open(const std::string& name, bool append);

  std::array<bool, parser::kStreams> m_console{};
  std::array<File, parser::kStreams> m_files;
  File m_all;
};

}  // namespace lentray::tool
