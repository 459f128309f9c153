// What starts with #: conditions, loops, macros, declarations, includes, messages, files. Executed
// while tokens are fetched, in the middle of any statement.
// Source: reference manual 3.7, "Language Directives"; corners as measured on stock.
#pragma once

#include <memory>
#include <vector>

#include "parser/tokens/token.h"
#include "parser/values/symbols.h"

namespace lentray::parser {

struct Interpreter;

class Directives {
 public:
  explicit Directives(Interpreter& in) : m_in(in) {}

  void execute(const Token& directive);
  /// `declare`, `include`, `default` without their #, as in scenes of the first versions.
  void execute_unmarked(const Token& word);
  /// Reads the arguments and goes on in the macro's body.
  void invoke(const Macro& macro, const Token& name);
  /// At the end of a file or macro: back to what was read before; of a piece of a file, on to the next.
  /// False at the scene's end.
  bool leave_frame();

  /// The condition of #ifdef and defined(): a name in parentheses. Reserved words and numbers are
  /// not defined, strings are, as in stock.
  bool parse_defined();
  /// The value of an identifier, an expression or a description, as #declare takes it.
  Value parse_rvalue();
  /// Whether a keyword is a directive's.
  static bool has(Keyword keyword);
  /// Replays a file; fails if it is not found.
  void include(const std::string& name, const Location& where);

 private:
  enum class BlockKind : std::uint8_t { kIf, kSwitch, kWhile, kFor };
  struct Block {
    BlockKind kind;
    const Token* opener;
    const Token* body = nullptr;  // of #for: the first token after the head
    NameId variable = 0;
    double last = 0.0, step = 1.0;
  };
  // directives.cpp
  void message(const Token& directive);
  void version();
  void include_directive();

  // directives_flow.cpp
  void if_directive(const Token& directive);
  void else_part(const Token& directive);
  void end_part(const Token& directive);
  void switch_directive(const Token& directive);
  void case_part(const Token& directive);
  void while_directive(const Token& directive);
  void for_directive(const Token& directive);
  void break_directive(const Token& directive);
  bool choose_case(const Token& part, double value);
  bool condition();
  void advance_for(Block& block);
  bool for_is_over(const Block& block, double value) const;
  Block* open_block();
  const Token* part_after(const Token& part) const;
  const Token* end_of(const Token& opener) const;
  void go_to(const Token* token);
  void go_past(const Token* token);
  [[noreturn]] void missing_end(const Token& opener);

  // directives_macro.cpp
  void define_macro(const Token& directive);
  std::vector<MacroParameter> macro_parameters();
  SymbolPtr argument(const Macro& macro, std::size_t index);  ///< null: left out
  SymbolPtr plain_argument();

  // directives_declare.cpp
  void declare(Location directive, bool local);
  bool declare_plain(const Location& directive, bool local);
  void deprecation(std::string& text, bool& once);
  void undef();
  void end_of_declaration(const Value& value, const Location& where);
  Value array_value();
  Value copy_value(const Value& value);  ///< an array's elements are copied too
  void array_initialiser(ArrayValue& array, std::size_t dimension, std::size_t base);

  Interpreter& m_in;
  std::vector<Block> m_blocks;
  std::vector<SymbolPtr>
      m_arguments;  ///< of the calls whose arguments are being read, innermost last
};

}  // namespace lentray::parser
