// The parts of the SDL interpreter and how they reach each other. Private to parser/*.cpp of the
// front end; productions see parser.h only. One Interpreter a scene, one thread.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "parser/interpreter/directives.h"
#include "parser/interpreter/expressions.h"
#include "parser/interpreter/function_parser.h"
#include "parser/interpreter/parser.h"
#include "parser/interpreter/script_files.h"
#include "parser/interpreter/token_reader.h"
#include "parser/source/build_error.h"
#include "parser/source/cancelled.h"
#include "parser/tokens/names.h"
#include "parser/tokens/token_stream.h"
#include "parser/values/symbols.h"

namespace lentray::parser {

struct Interpreter {
  Interpreter(SourceManager& sources_, Diagnostics& diagnostics_, const ParserOptions& options_,
              Productions& productions_, Parser& parser_);

  SourceManager& sources;
  Diagnostics& diagnostics;
  const ParserOptions options;
  Productions& productions;
  Parser& parser;
  PictureReads reads{};

  NameTable names;
  TokenStream stream;
  SymbolTable symbols;
  TokenReader tokens;
  Expressions expressions;
  FunctionParser functions;
  Directives directives;
  ScriptFiles files;

  int version = 370;  ///< x 100
  /// The first dialect has none.
  bool has_arithmetic() const { return version >= 150; }
  bool version_set = false;
  /// The scene's, as far as it is known; set by global_settings or by the version.
  std::shared_ptr<int> noise_generator = std::make_shared<int>(2);
  bool noise_generator_set = false;
  bool has_own_version = false;       ///< the scene's file has a #version, or an option said it
  bool is_version_late = false;       ///< the first one there stands behind something else
  std::vector<std::uint32_t> random;  ///< states of the streams of seed()

  /// What assumed_gamma has said so far; less than 0: sRGB.
  std::optional<double> working_gamma;
  bool utf8 = false;  ///< charset of string literals; else ASCII
  std::string scene_folder;
  std::uint32_t scene_file = 0;  ///< of its locations
  bool is_in_scene(const Location& where) const { return where.file == scene_file; }
  /// A file of the scene that has been read. A long one is made tokens each time that it is replayed.
  struct Text {
    std::uint32_t file = 0;
    std::shared_ptr<const TokenList> tokens;
  };
  std::map<std::string, Text> texts;  ///< by path

  [[noreturn]] void fail(const Location& where, const std::string& message,
                         const std::string& shown = "");
  void warn(const Location& where, const std::string& message);

  /// What `ask` finds out of an object that is made for it; what cannot be made is a mistake of the
  /// scene.
  template <typename Ask>
  auto ask_object(Ask ask) {
    try {
      return ask();
    } catch (const BuildError& error) {
      fail(error.where(), error.what());
    }
  }

  /// What `ask` asks of the scene's files; a file that is refused is a mistake of the scene at `where`.
  template <typename Ask>
  auto ask_files(const Location& where, Ask ask) {
    try {
      return ask(sources.disk());
    } catch (const FileRefused& refused) {
      fail(where, refused.what());
    }
  }

  /// A frame that replays the scene itself; null, and there is none, if it cannot be read.
  Frame* push_scene(const std::string& path);
  /// Likewise an include file, which is read once.
  Frame* push_file(const std::string& path, const Location& where);
  /// In the current folder, the scene's and the libraries'; then as Windows would, with a warning.
  /// Fails if there is only one that may not be read.
  std::optional<std::string> find_file(const std::string& name, const Location& where);
  /// The same without the Windows names.
  std::optional<std::string> find_exactly(const std::string& name, const Location& where);
  /// Fails if no file can have this name.
  void check_file_name(const std::string& name, const Location& where);

  std::size_t most_levels = 0;  ///< of objects and textures in each other
  std::size_t deepest = 1;      ///< of them that were read

  /// Defines what every scene finds declared, and the Declare= options.
  void declare_constants();
  /// Days since the year 2000 began: of a reading's first thousand questions one moment. Then time goes by, for a scene
  /// that waits for a later one.
  double now();

  /// The nearest known name, as the end of a message (", did you mean ...?") or "".
  std::string suggestion(std::string_view name) const;

  /// Fails when the program's own stack gets short: endless recursion through statements.
  void guard_stack() {
    if (stack_address() < m_stack_end) stack_exhausted();
  }
  void stop_if_asked() const {
    if (options.cancel && options.cancel->load(std::memory_order_relaxed)) throw Cancelled();
  }
  /// Counts a turn of a loop, a call of a macro or an include; fails when there were too many.
  void count_turn() {
    stop_if_asked();
    if (++m_turns > options.limits.turns) too_many_turns();
  }

 private:
  double m_first_asked = 0.0;  ///< `now` of the clock
  int m_asked = 0;             ///< for `now`
  Frame& push_text(Text& text);
  std::vector<std::string> search_folders() const;
  bool may_read(const std::string& path, std::string& refused) const;
  std::optional<std::string> search(const std::string& name, std::string& refused) const;
  std::optional<std::string> search_loosely(const std::string& name, std::string& refused);

  [[noreturn]] void too_many_turns();
  [[noreturn]] void stack_exhausted();

  /// Not the address of a variable: sanitizers may keep those elsewhere.
  static std::uintptr_t stack_address() {
    return reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
  }

  /// What lies below is recursion without an end, and a message beats a crash.
  std::uintptr_t m_stack_end;
  std::uint64_t m_turns = 0;
  bool m_warned_of_names = false;
};

}  // namespace lentray::parser
