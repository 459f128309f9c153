// The SDL interpreter's face to the productions: tokens with directives already executed,
// expressions, symbols, messages. One Parser reads one scene, on one thread.
//
// How a scene becomes descriptions: sources -> tokens (each file and macro tokenised once) ->
// token stream (files, macros and loops replay tokens) -> directives executed on the way ->
// productions (parser/grammar) -> descriptions (parser/descriptions) -> compile (parser/compile).
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/transform.h"
#include "parser/options/animation.h"
#include "parser/options/picture_reads.h"
#include "parser/source/diagnostics.h"
#include "parser/source/limits.h"
#include "parser/source/source.h"
#include "parser/tokens/token.h"
#include "parser/values/value.h"

namespace lentray::parser {

class Parser;

/// The statements of the language, implemented in parser/grammar. Directives and expressions call
/// back through this, so that the interpreter does not depend on the statements.
class Productions {
 public:
  virtual ~Productions() = default;
  /// The right side of #declare/#local, an array element or a macro argument, when the next token
  /// starts something that is not an expression (`pigment {`, `sphere {`, `camera {` ...) or names
  /// such a value with modifiers to follow. Nothing consumed and nullopt if it is none of these.
  virtual std::optional<Value> rvalue(Parser& parser) = 0;
  /// The block of #default { ... }, braces included.
  virtual void set_default(Parser& parser) = 0;
  /// trace(), inside(), min_extent(), max_extent() of an object, compiled alone.
  virtual bool inside(const ObjectDesc& object, const core::Vec3& point) = 0;
  virtual bool trace(const ObjectDesc& object, const core::Vec3& origin,
                     const core::Vec3& direction, core::Vec3& point, core::Vec3& normal) = 0;
  virtual void extent(const ObjectDesc& object, core::Vec3& lo, core::Vec3& hi) = 0;
  /// A function of a pigment or pattern: colours or a number by point. Called at `pigment` or
  /// `pattern`; the function's own braces are not its business.
  virtual Ref<FunctionDesc> pattern_function(Parser& parser) = 0;
};

struct ParserOptions {
  std::vector<std::string> library_paths;  ///< +L, in order
  std::vector<std::pair<std::string, std::string>>
      declares;                ///< Declare=NAME=VALUE, VALUE float or string
  std::string include_header;  ///< read before the scene; empty: none
  std::string header_place;    ///< where an INI file names it, "a.ini:3"; empty: nowhere
  FrameClock frame;
  int image_width = 160, image_height = 120;
  int language_version = 0;  ///< Version=, x 100; 0: the scene decides
  Limits limits;
  /// The moment that the picture is of, as `now` says it; none: that at which the scene asks.
  std::optional<double> now{};
  /// The scene will not be rendered: of objects that cannot go wrong only the number is kept.
  bool only_check = false;
  /// A text of more than 64 bytes for each is made tokens in pieces of so many: what a processor's cache holds.
  std::size_t piece_tokens = 4096;
  bool plain_expressions = true;  ///< false: all of them as ScriptTokens, to compare the two
  /// Set from outside to stop soon: Cancelled is thrown. Null: nobody asks.
  const std::atomic<bool>* cancel = nullptr;
};

class Parser {
 public:
  Parser(SourceManager& sources, Diagnostics& diagnostics, const ParserOptions& options,
         Productions& productions);
  ~Parser();

  /// Makes the file the one being read. Throws ParseError if it is missing.
  void open(const std::string& path);

  // Tokens. Directives, macros, loops and includes have been dealt with; `#` is never seen here.
  const Token& peek();
  Token next();
  bool at_end();  ///< end of the scene
  /// Throws Cancelled. Between statements; turns of loops and calls of macros ask by themselves.
  void stop_if_asked() const;
  /// After the end: what the scene has written is on the disk, or this fails.
  void finish();
  bool at(Keyword keyword);
  bool at(Punct punct);
  bool accept(Keyword keyword);  ///< consume if it is next
  bool accept(Punct punct);
  /// The word and the number or vector behind it.
  template <typename T>
  bool accept(Keyword keyword, T& value) {
    const bool next = accept(keyword);
    if (next) value = parse<T>();
    return next;
  }
  template <typename T>
  bool accept(Keyword keyword, std::optional<T>& value) {
    const bool next = accept(keyword);
    if (next) value = parse<T>();
    return next;
  }
  /// Words that are no keywords, by their spelling, whatever the scene has declared by that name.
  bool at_word(std::string_view word);
  bool accept_word(std::string_view word);
  std::string_view spelling(const Token& token);  ///< of an identifier or keyword; "" for others
  void expect(Keyword keyword);                   ///< consume or fail naming what was expected
  void expect(Punct punct);
  /// If the next token names a symbol (or array element, or macro parameter) that holds a T,
  /// consumes the reference with its subscripts and returns the value.
  template <typename T>
  std::optional<T> accept_value();
  /// Looks without consuming: the value the next identifier token refers to, or null.
  const Value* peek_value();

  // Expressions, as the manual's sections of these names; each fails with a message.
  double parse_float();
  bool parse_bool();  ///< optional in SDL: `on`, `off`, a float; nothing means true
  int parse_int();
  core::Vec3 parse_vector();  ///< full expression; a float is promoted
  /// That of them which is meant.
  template <typename T>
  T parse() {
    if constexpr (std::is_same_v<T, core::Vec3>) {
      return parse_vector();
    } else if constexpr (std::is_same_v<T, int>) {
      return parse_int();
    } else {
      static_assert(std::is_floating_point_v<T>);
      return static_cast<T>(parse_float());
    }
  }
  Number parse_number(int min_size = 1, int max_size = 5);  ///< expression of any size
  Number parse_colour();  ///< colour expression incl. `rgb`, `color red 1 ...`
  bool at_colour();       ///< the next token can start a colour
  bool at_expression();   ///< the next token can start a float or vector expression
  std::string parse_string();
  std::string parse_path();  ///< a file name: its backslashes are no escapes
  void parse_comma();        ///< optional comma

  /// Reads transform statements (translate rotate scale matrix transform) while they last.
  /// nullopt if none is next.
  std::optional<core::Transform> accept_transforms();
  /// One such statement.
  std::optional<core::Transform> accept_transform();

  /// `function { ... }` or the name of one, body braces included; the keyword is consumed already.
  Ref<FunctionDesc> parse_function_body();

  // Messages.
  [[noreturn]] void fail(const std::string& message);      ///< at the next token
  [[noreturn]] void fail_expected(std::string_view what);  ///< "expected X but found Y"
  [[noreturn]] void fail_at(const Location& where, const std::string& message);
  void warn(const std::string& message);
  void warn_at(const Location& where, const std::string& message);
  Location location();  ///< of the next token

  int language_version() const;       ///< x 100: 370
  bool language_version_set() const;  ///< false: the scene has no #version yet
  bool has_own_version() const;       ///< not only its include files have one
  bool is_version_late() const;       ///< the scene's file says something before its #version
  const ParserOptions& options() const;
  const PictureReads& reads() const;  ///< so far
  /// How many objects or looks may be in each other: as the limits, the stack and the memory permit.
  std::size_t most_levels() const;
  void note_levels(std::size_t levels);
  std::size_t deepest() const;  ///< the most that were noted
  Diagnostics& diagnostics();
  SourceManager& sources();
  /// What srgb colours and pictures become, less than 0: sRGB; the statement that reads assumed_gamma sets it.
  void set_working_gamma(double gamma);
  std::optional<double> working_gamma() const;
  /// Whether string literals are UTF-8 rather than ASCII; the statement that reads charset sets it.
  void set_utf8(bool utf8);
  bool utf8() const;
  /// Which noise functions are made of; the statement that reads noise_generator sets it.
  void set_noise_generator(int generator);
  int noise_generator() const;
  /// Finds a file as `#include` does (current folder, folder of the scene, library paths).
  /// Fails at `where` if there is only one that may not be read.
  std::optional<std::string> find_file(const std::string& name, const Location& where);
  /// The same of a file that something else than the parser will open.
  std::optional<FoundFile> find_to_open(const std::string& name, const Location& where);
  /// Fails if a file that the scene will have written cannot be.
  void check_writable(const std::string& name, const Location& where);

 private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

}  // namespace lentray::parser
