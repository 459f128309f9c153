// The files a scene opens for itself: #fopen, #fclose, #read, #write.
// Source: reference manual 3.7, "File I/O"; number formats measured on stock (%g).
#pragma once

#include <memory>
#include <string>

#include "parser/files.h"
#include "parser/lexer.h"
#include "parser/value.h"

namespace lentray::parser {

struct Interpreter;
struct Symbol;
struct BinaryFormat;

struct ScriptFile {
  std::string path;
  std::unique_ptr<FileWriter> out;
  std::unique_ptr<TokenPieces> in;
  std::size_t position = 0;   ///< in the piece at hand
  bool ended = false;         ///< its end has been met, by a value without a comma behind it or by none
};

class ScriptFiles {
 public:
  explicit ScriptFiles(Interpreter& in) : m_in(in) {}
  void open();
  void close();
  void read();
  void write();

 private:
  std::shared_ptr<ScriptFile> file(bool closing);
  bool read_plain(ScriptFile& file, Value& value);
  bool read_value(ScriptFile& file, Value& value);
  double read_number(ScriptFile& file);
  Symbol* plain_target();
  void write_binary(std::string& text, const BinaryFormat& format);
  Interpreter& m_in;
};

}  // namespace lentray::parser
