// Tokens read straight from their list, for ExpressionGrammar: numbers, strings, operators, and
// identifiers and array elements that hold a number or a string. Reading is given up at anything else
// (a directive, a macro, a call of a function, the end of a file or macro) and wherever a message is
// due. Nothing has changed then, and the same tokens are read again as ScriptTokens.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/tokens/lexer.h"
#include "parser/values/float_functions.h"
#include "parser/values/operators.h"
#include "parser/values/symbols.h"

namespace lentray::parser {

struct Interpreter;

class PlainTokens {
 public:
  explicit PlainTokens(Interpreter& in);

  // Expressions calls begin() before it reads an expression and finish() behind it.
  enum class Kind { kNumber, kString };
  /// False if it is known that what begins there will be given up.
  bool begin(const TokenList& list, const Token* first, Kind kind) {
    m_list = &list;
    m_first = m_at = first;
    m_depth = 0;
    m_failure = &m_failed[static_cast<std::size_t>(kind)];
    return (first < m_failure->from || first > m_failure->at) &&
           (kind == Kind::kString || !starts_string());
  }
  /// With `read`: the expression was read, and `at()` is behind it. False if it is given up, or if
  /// what follows might be part of it; with `end`, if that does not follow.
  bool finish(bool read, Punct end) {
    // What follows a string can be no part of it.
    const bool is_string = m_failure != m_failed;
    if (!read || !(end == Punct::kNone ? is_string || ends_here() : at(end))) return give_up();
    if (!m_random.empty()) m_random.clear();
    return true;
  }
  const Token* at() const { return m_at; }

  // Of ExpressionGrammar.
  const Token& peek() const { return *m_at; }
  const Token& peek_operand() const { return *m_at; }
  const Token& next() { return *m_at++; }
  void skip() { ++m_at; }
  bool at(Punct p) const { return m_at->is(p); }
  bool accept(Punct p) {
    if (!at(p)) return false;
    ++m_at;
    return true;
  }
  bool expect(Punct p) { return accept(p); }
  Precedence precedence() const { return parser::precedence(*m_at); }
  Location location() const { return m_at[-1].where; }
  std::string describe(const Token&) const { return {}; }
  std::string_view name(const Token&) const { return {}; }
  static bool fail_expected(std::string_view) { return false; }
  static bool fail(const Location&, const std::string&) { return false; }
  static bool warn(const Location&, const std::string&) { return false; }
  bool enter() { return ++m_depth <= kDeepest; }
  void leave() { --m_depth; }

  bool quick(Number& n, Precedence least) {
    if (m_at->kind == TokenKind::kNumber && ends_operand(least)) {
      n.v[0] = m_at->number;
    } else if (m_at->kind == TokenKind::kIdentifier && ends_operand(least)) {
      const Number* number = held<Number>(*m_at);
      if (!number) return false;
      n = *number;
    } else {
      return m_at->is_literal_vector() && ends_operand(least) && literal_vector(n);
    }
    ++m_at;
    return true;
  }
  bool quick(double& x, Precedence least) {
    if (m_at->kind == TokenKind::kNumber && ends_operand(least)) {
      x = m_at->number;
    } else if (m_at->kind == TokenKind::kIdentifier && ends_operand(least)) {
      const Number* number = held<Number>(*m_at);
      if (!number || number->size != 1) return false;
      x = number->v[0];
    } else {
      return false;
    }
    ++m_at;
    return true;
  }
  bool quick(Number& n, Precedence least, Location&) { return quick(n, least); }
  static bool quick(std::string&) { return false; }
  bool literal_vector(Number& n);
  void open_vector() {}
  void close_vector() {}
  bool at_string() const {
    return starts_string() || (m_at->kind == TokenKind::kIdentifier && held<std::string>(*m_at));
  }
  bool literal(std::string& text, bool path);
  bool identifier(Number& n) {
    const Symbol* symbol = m_symbols.find(m_at->name);
    if (symbol && !symbol->alias && !symbol->extras) {
      if (const Number* number = std::get_if<Number>(&symbol->value)) {
        n = *number;
        ++m_at;
        return true;
      }
    }
    return resolved(n);
  }
  bool identifier(std::string& text);
  bool keyword_float(Keyword keyword, double& x);
  bool old_dialect() const;
  std::size_t most_bytes() const;
  bool random(double stream, double& x);
  bool function(Keyword word, Number& n);

 private:
  static constexpr int kDeepest = 100;  ///< brackets and functions, one in the other

  // Whether the token here, which is not the list's kEnd, is the whole expression.
  bool ends_operand(Precedence least) const {
    const Token& next = m_at[1];
    if (next.kind != TokenKind::kPunct) return false;
    return next.punct == Punct::kComma || next.punct == Punct::kRightParen ||
           next.punct == Punct::kRightCurly || next.punct == Punct::kSemicolon ||
           (next.punct == Punct::kGreater && least > Precedence::kComparison);
  }
  // The value of a name, if it is of that kind and reading the name has no other effect; or null.
  template <typename T>
  const T* held(const Token& name) const {
    const Symbol* symbol = m_symbols.find(name.name);
    if (!symbol) return nullptr;
    while (symbol->alias) symbol = symbol->alias.get();
    return symbol->extras ? nullptr : std::get_if<T>(&symbol->value);
  }
  bool starts_string() const {
    return m_at->kind == TokenKind::kString ||
           (m_at->kind == TokenKind::kKeyword &&
            function_kind(m_at->keyword) == FunctionKind::kString);
  }
  bool resolved(Number& n);
  const Value* value();
  bool element(const Value*& value);
  bool ends_here() const { return m_at->passive || ends_at_name(); }
  bool ends_at_name() const;
  bool give_up();

  Interpreter& m_in;
  const SymbolTable& m_symbols;
  const TokenList* m_list = nullptr;
  const Token* m_first = nullptr;
  const Token* m_at = nullptr;
  int m_depth = 0;
  /// The expression of each kind that was given up last: where it began, and where it could not be
  /// read further. An expression that begins in between is given up there too.
  struct Failure {
    const Token* from = nullptr;
    const Token* at = nullptr;
  };
  Failure m_failed[2];
  Failure* m_failure = m_failed;  ///< of the kind being read
  /// Streams of rand() advanced, and their states before.
  std::vector<std::pair<std::size_t, std::uint32_t>> m_random;
};

}  // namespace lentray::parser
