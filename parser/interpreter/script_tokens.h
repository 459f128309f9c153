// TokenReader's tokens for ExpressionGrammar. Directives are executed, macros are invoked, and a fault
// throws with its message: nothing is given up.
#pragma once

#include <string>
#include <string_view>

#include "parser/tokens/token.h"
#include "parser/values/operators.h"
#include "parser/values/value.h"

namespace lentray::parser {

struct Interpreter;
class TokenReader;

class ScriptTokens {
 public:
  explicit ScriptTokens(Interpreter& in);

  const Token& peek();
  const Token& peek_operand();
  Token next();
  void skip();
  bool at(Punct p);
  bool accept(Punct p);
  bool expect(Punct p);
  Precedence precedence();
  Location location() const;
  std::string describe(const Token& token) const;
  std::string_view name(const Token& token) const;
  [[noreturn]] bool fail_expected(std::string_view what);
  [[noreturn]] bool fail(const Location& where, const std::string& message);
  bool warn(const Location& where, const std::string& message);
  bool enter();
  void leave() { --m_depth; }

  // Read the whole expression, if it consists of PlainTokens.
  bool quick(Number& n, Precedence least);
  bool quick(Number& n, Precedence least, Location& where);
  bool quick(std::string& text);
  static bool quick(double&, Precedence) { return false; }

  bool literal_vector(Number& n);
  void open_vector();
  void close_vector();
  bool at_string();
  bool literal(std::string& text, bool path);
  bool identifier(Number& n);
  bool identifier(std::string& text);
  bool keyword_float(Keyword keyword, double& x);
  bool old_dialect() const;
  std::size_t most_bytes() const;
  bool random(double stream, double& x);
  bool function(Keyword word, Number& n);  ///< script_functions.cpp

 private:
  template <typename T>
  T named(const char* what);
  double dimension_size();
  core::Vec3 trace();
  core::Vec3 extent(bool upper);
  core::Vec3 turbulence();
  // expressions_call.cpp
  Number call_function(const Ref<FunctionDesc>& function, std::string_view name);
  Number call_spline(const Ref<SplineDesc>& spline);

  Interpreter& m_in;
  TokenReader& m_tokens;
  int m_depth = 0;
};

}  // namespace lentray::parser
