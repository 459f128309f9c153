// The files a scene opens for itself: #fopen, #fclose, #read, #write.
// Source: reference manual 3.7, "File I/O"; number formats measured on stock (%g).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "parser/files/files.h"
#include "parser/tokens/lexer.h"
#include "parser/values/value.h"

namespace lentray::parser {

struct Interpreter;
struct Symbol;
struct BinaryFormat;

/// A written file that could not be written whole, which was found where no message could be given.
struct LostFile {
  Location where;  ///< of its #fopen
  std::string message;
};

struct ScriptFile {
  ScriptFile() = default;
  ~ScriptFile();
  ScriptFile(const ScriptFile&) = delete;
  ScriptFile& operator=(const ScriptFile&) = delete;
  /// What went wrong, as a message; empty if nothing did.
  std::string close();

  std::string path;
  Location where;  ///< of its #fopen
  std::shared_ptr<std::vector<LostFile>> lost;
  std::unique_ptr<FileWriter> out;
  std::unique_ptr<TokenPieces> in;
  std::size_t position = 0;  ///< in the piece at hand
  bool ended = false;  ///< its end has been met, by a value without a comma behind it or by none
};

class ScriptFiles {
 public:
  explicit ScriptFiles(Interpreter& in) : m_in(in) {}
  void open();
  void close();
  void read();
  void write();
  /// At the end of the scene: closes what is still open. Fails if anything written was lost.
  void finish();

 private:
  std::shared_ptr<ScriptFile> file(bool closing);
  bool read_plain(ScriptFile& file, Value& value);
  bool read_value(ScriptFile& file, Value& value);
  double read_number(ScriptFile& file);
  Symbol* plain_target();
  void write_binary(std::string& text, const BinaryFormat& format);
  Interpreter& m_in;
  std::vector<std::weak_ptr<ScriptFile>> m_written;
  std::shared_ptr<std::vector<LostFile>> m_lost = std::make_shared<std::vector<LostFile>>();
};

}  // namespace lentray::parser
