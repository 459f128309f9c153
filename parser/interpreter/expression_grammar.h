// The grammar of expressions, for two kinds of tokens. Most expressions consist of PlainTokens, which
// are several times faster to read. ScriptTokens execute directives and invoke macros. Every function
// reads what its name says and returns false where it gives up. PlainTokens give up at what they do
// not know and wherever a message is due; ScriptTokens throw instead. A Number to be filled is a new
// one. One thread.
// Source: reference manual 3.7, "Float Expressions", "Vector Expressions", "Strings"; precision,
// promotion and error cases as measured on stock.
#pragma once

#include <string>

#include "core/base/vec3.h"
#include "parser/values/number_text.h"
#include "parser/values/operators.h"
#include "parser/values/value.h"

namespace lentray::parser {

template <typename Tokens>
class ExpressionGrammar {
 public:
  explicit ExpressionGrammar(Tokens& tokens) : m_tokens(tokens) {}

  /// Operators that bind at least so closely: kLogical for everything, the choice ?: too, kSum for
  /// what stands where no parentheses do.
  bool read(Number& n, Precedence least);
  /// One component; `least` as above.
  bool scalar(double& x, Precedence least = Precedence::kSum);
  bool vector(core::Vec3& v);  ///< up to three components
  /// If there are more than so many components, `where` is the place a message points to.
  bool located(Number& n, Precedence least, Location& where);
  bool operand(Number& n);  ///< with its .member
  bool vector_literal(Number& n);
  /// Put behind `text`; in a file name (`path`) backslashes stay.
  bool string(std::string& text, bool path = false);

 private:
  bool choice(Number& n);
  bool binary(Number& left, Precedence least);
  bool operators(Number& left, Precedence next, Precedence least);
  [[gnu::always_inline]] inline bool next_operand(Number& n);  ///< operand(), where it costs most
  // Rare; within what is common they would cost each call.
  [[gnu::cold]] [[gnu::noinline]] bool chosen(Number& n, const Location& where);
  [[gnu::cold]] [[gnu::noinline]] bool string_comparison(double& x);
  bool primary(Number& n);
  bool prefixed(Number& n, Punct sign);
  bool keyword(Number& n);
  bool function(Keyword word, Number& n);
  bool float_function(Keyword word, Number& n);
  bool vector_function(Keyword word, Number& n);
  bool text_measure(Keyword word, double& x);
  bool outside_domain(Keyword function, double& x, const Location& where);
  bool member(Number& n);
  bool string_function(Keyword word, std::string& text, bool path);
  bool number_format(NumberFormat& format);

  bool argument(double& x) { return scalar(x, Precedence::kLogical); }
  bool two_vectors(core::Vec3& a, core::Vec3& b) { return vector(a) && comma() && vector(b); }
  bool comma() {
    m_tokens.accept(Punct::kComma);
    return true;
  }
  bool open() { return m_tokens.expect(Punct::kLeftParen); }
  bool close() { return m_tokens.expect(Punct::kRightParen); }

  Tokens& m_tokens;
};

}  // namespace lentray::parser
