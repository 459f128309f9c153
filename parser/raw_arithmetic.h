// Expressions read straight from the token list: the road that most of them can take, several times
// faster than the grammar's. It knows numbers, vectors, identifiers and array elements that hold
// them, operators and pure functions. Where anything else stands (a directive, a macro, a call of a
// function, the end of a file or macro) or something would have to be said, it gives up without a
// trace, and the grammar (Expressions) reads the same tokens again. One thread.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "parser/arithmetic.h"
#include "parser/lexer.h"
#include "parser/symbols.h"

namespace lentray::parser {

struct Interpreter;

class RawArithmetic {
 public:
  explicit RawArithmetic(Interpreter& in) : m_in(in) {}

  enum class Level { kAdditive, kEverything };  ///< as Expressions::parse_additive, parse_expression

  /// The expression that begins with `first` in `list`. True if it was read to its end: `first` is
  /// then the token behind it, which is of the same list and can be no part of it. With `end`, only
  /// if that token is the one behind it.
  bool read(const TokenList& list, const Token*& first, Level level, Number& value,
            Punct end = Punct::kNone);

 private:
  bool expression(Number& n);
  bool logical_level(Number& n);
  bool relational(Number& n);
  bool additive(Number& n);
  bool term(Number& n);
  bool factor(Number& n);
  bool primary(Number& n);
  bool vector_literal(Number& n);
  bool identifier(Number& n);
  bool element(const Value*& value);
  bool keyword(Number& n);
  bool defined(Number& n);
  bool member(Number& n);

  bool is(Punct p) const { return m_at->kind == TokenKind::kPunct && m_at->punct == p; }
  bool accept(Punct p) {
    if (!is(p)) return false;
    ++m_at;
    return true;
  }
  bool scalar(double& x);      ///< additive, one component
  bool argument(double& x);    ///< everything, one component
  bool vector(core::Vec3& v);  ///< additive, up to three components
  bool ends_here() const;
  bool operand(const Token& token, Number& value) const;
  bool lone_operand(Number& n);
  void undo_random();

  Interpreter& m_in;
  const TokenList* m_list = nullptr;
  const Token* m_at = nullptr;
  int m_depth = 0;
  /// Of the last expression given up: where it began, and where it could not go on.
  const Token* m_failed_from = nullptr;
  const Token* m_failed_at = nullptr;
  /// Streams of rand() advanced, and their states before.
  std::vector<std::pair<std::size_t, std::uint32_t>> m_random;
};

}  // namespace lentray::parser
