// Expressions read straight from the token list: the road that most of them can take, several times
// faster than the grammar's. It knows numbers, vectors and strings, identifiers and array elements
// that hold them, operators and pure functions. Where anything else stands (a directive, a macro, a call of a
// function, the end of a file or macro) or something would have to be said, it gives up without a
// trace, and the grammar (Expressions) reads the same tokens again. One thread.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "parser/tokens/lexer.h"
#include "parser/values/arithmetic.h"
#include "parser/values/float_functions.h"
#include "parser/values/number_text.h"
#include "parser/values/operators.h"
#include "parser/values/symbols.h"

namespace lentray::parser {

struct Interpreter;

class RawExpressions {
 public:
  explicit RawExpressions(Interpreter& in);

  enum class Level {
    kAdditive,
    kEverything
  };  ///< as Expressions::parse_additive, parse_expression

  /// The expression that begins with `first` in `list`. True if it was read to its end: `first` is
  /// then the token behind it, which is of the same list and can be no part of it. With `end`, only
  /// if that token is the one behind it.
  bool read(const TokenList& list, const Token*& first, Level level, Number& value,
            Punct end = Punct::kNone) {
    return read_alone(first, value, end) || read_whole(list, first, level, value, end);
  }

  /// The string that begins there, put behind `text`; otherwise likewise.
  bool read(const TokenList& list, const Token*& first, std::string& text,
            Punct end = Punct::kNone) {
    return read_alone(first, text, end) || read_whole(list, first, text, end);
  }

  /// Either of them.
  enum class Item { kNone, kNumber, kString };
  Item read_item(const TokenList& list, const Token*& first, Number& value, std::string& text);

 private:
  static constexpr int kDeepest = 100;  ///< brackets and functions, one in the other
  static constexpr int kMostOperands = 5000;

  // Of one token, if it is the whole: most are.
  static bool ends_operand(const Token& next, Punct end) {
    if (next.kind != TokenKind::kPunct) return false;
    return end == Punct::kNone ? next.punct == Punct::kComma || next.punct == Punct::kRightParen ||
                                     next.punct == Punct::kRightCurly
                               : next.punct == end;
  }
  bool read_alone(const Token*& first, Number& value, Punct end) const {
    // Behind both there is another token.
    if (first->kind == TokenKind::kNumber && ends_operand(first[1], end)) {
      value.v[0] = first->number;
    } else if (first->kind == TokenKind::kIdentifier && ends_operand(first[1], end)) {
      const Number* number = held<Number>(*first);
      if (!number) return false;
      value = *number;
    } else {
      return false;
    }
    ++first;
    return true;
  }
  bool read_alone(const Token*& first, std::string& text, Punct end) const {
    const std::string* string = nullptr;
    // What follows a literal can be no part of it. One with a wrong escape is the grammar's.
    if (first->kind == TokenKind::kString && first->keyword == Keyword::kNone) {
      if (end == Punct::kNone || first[1].is(end)) string = m_names.ascii_alone(first->name);
    } else if (first->kind == TokenKind::kIdentifier && ends_operand(first[1], end)) {
      string = held<std::string>(*first);
    }
    if (!string) return false;
    text += *string;
    ++first;
    return true;
  }
  // What a name stands for, if it is of that kind and nothing happens when it is read; or null.
  template <typename T>
  const T* held(const Token& name) const {
    const Symbol* symbol = m_symbols.find(name.name);
    if (!symbol) return nullptr;
    while (symbol->alias) symbol = symbol->alias.get();
    return symbol->extras ? nullptr : std::get_if<T>(&symbol->value);
  }
  bool read_whole(const TokenList& list, const Token*& first, Level level, Number& value,
                  Punct end);
  bool read_whole(const TokenList& list, const Token*& first, std::string& text, Punct end);

  // raw_operators.h
  template <typename N>
  bool binary(N& left, Precedence least);
  template <typename N>
  bool rest(N& left, Precedence least);

  bool additive(Number& n);
  bool expression(Number& n);
  bool operand(Number& n);
  bool primary(Number& n);
  void literal_vector(const Token& token, Number& n) const;
  bool vector_literal(Number& n);
  const Value* identifier_value();
  bool identifier(Number& n);
  bool element(const Value*& value);
  bool member(Number& n);

  // raw_scalars.cpp
  bool only_floats(Level level, bool members, double& x);
  bool whole(double& x);
  bool operand(double& x);
  bool identifier(double& x);
  bool alone(double& x);

  // raw_functions.cpp
  bool float_function(double& x);
  bool float_value(Keyword function, double& x);
  bool vector_function(Number& n);
  bool defined(double& x);

  // raw_strings.cpp
  bool string(std::string& text);
  bool string_literal(std::string& text);
  bool string_identifier(std::string& text);
  bool string_function(Keyword function, std::string& text);
  bool vector_text(std::string& text);
  bool part_of_string(std::string& text);
  bool number_format(NumberFormat& format);

  bool is(Punct p) const { return m_at->kind == TokenKind::kPunct && m_at->punct == p; }
  bool accept(Punct p) {
    if (!is(p)) return false;
    ++m_at;
    return true;
  }
  bool scalar(double& x, Level level = Level::kAdditive);  ///< one component
  bool argument(double& x) { return scalar(x, Level::kEverything); }
  bool vector(core::Vec3& v);  ///< additive, up to three components
  bool ends_here() const;
  bool lone_operand(Number& n);
  void undo_random(std::size_t kept = 0);

  Interpreter& m_in;
  const SymbolTable& m_symbols;
  const NameTable& m_names;
  const TokenList* m_list = nullptr;
  const Token* m_at = nullptr;
  int m_depth = 0;
  /// Operands that may be read yet: some are read as floats and then once more as vectors may be,
  /// which must not multiply where functions nest. None once it is known that all is in vain.
  int m_operands_left = 0;
  bool m_members = false;  ///< V.x may stand where only floats may
  /// Of the last expression given up: where it began, and where it could not go on.
  struct Failure {
    const Token* from = nullptr;
    const Token* at = nullptr;
    bool within(const Token* token) const { return token >= from && token <= at; }
  };
  Failure m_failed_number, m_failed_string;
  /// Streams of rand() advanced, and their states before.
  std::vector<std::pair<std::size_t, std::uint32_t>> m_random;
};

}  // namespace lentray::parser
