// Expressions: floats, vectors of 2 to 5 components, colours, strings, transforms, splines.
// Evaluated while they are read. Components promote as stock does: a float fills all of them, a
// shorter vector is padded with zeros.
// Source: reference manual 3.7, "Float Expressions", "Vector Expressions", "Specifying Colors",
// "Strings"; precision, promotion and error cases as measured on stock.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/transform.h"
#include "parser/interpreter/raw_expressions.h"
#include "parser/tokens/token.h"
#include "parser/values/arithmetic.h"
#include "parser/values/float_functions.h"
#include "parser/values/number_text.h"
#include "parser/values/operators.h"
#include "parser/values/value.h"

namespace lentray::parser {

struct Interpreter;

class Expressions {
 public:
  explicit Expressions(Interpreter& in) : m_in(in), m_raw(in) {}

  // expressions.cpp: operators
  Number parse_expression();         ///< everything: ?:, logic, comparison, arithmetic
  Number parse_additive();           ///< arithmetic only: what stands where no parentheses do
  double parse_float();              ///< arithmetic, one component
  double parse_scalar_expression();  ///< everything, one component
  core::Vec3 parse_vector();
  Number parse_number(int min_size, int max_size);
  bool at_expression();
  Number parse_operand() { return parse_factor(); }  ///< one operand with its .member
  Number parse_vector_literal() { return vector_literal(); }
  /// A keyword that is a float by itself (pi, on, clock ...); nothing is consumed.
  bool keyword_float(Keyword keyword, double& value);

  // expressions_colour.cpp
  Number parse_colour();
  bool at_colour_keyword();
  bool at_colour();

  // expressions_string.cpp
  bool at_string();
  std::string parse_string();
  std::string parse_path();                                  ///< a file name: backslashes stay
  void append_string(std::string& text, bool path = false);  ///< the same behind `text`

  // expressions_transform.cpp
  std::optional<core::Transform> accept_transform();
  core::Transform parse_transform_statement();  ///< at `transform`

  // expressions_spline.cpp
  Ref<SplineDesc> parse_spline();  ///< after `spline`

  /// `NAME = EXPRESSION;`, where it stands so in the token list: the token of the name, and `;` comes
  /// next. Null, and nothing read, if anything else stands there.
  const Token* read_raw_assignment(Number& n);
  /// The same for a string.
  const Token* read_raw_assignment(std::string& text);
  /// `( EXPRESSION )` of one component, likewise.
  bool read_raw_condition(Number& n);
  /// The expression that comes next, if it can be read straight from the token list.
  bool read_raw(RawExpressions::Level level, Number& n);
  bool read_raw_string(std::string& text);  ///< the same, put behind `text`
  /// Either of them, with the comma before it.
  RawExpressions::Item read_raw_item(Number& n, std::string& text);

 private:
  bool allows_raw() const;
  const Token* raw_assignment(const TokenList*& list) const;
  Number parse_located(RawExpressions::Level level, int most, Location& where);
  double parse_one(RawExpressions::Level level);
  Number parse_binary(Precedence here);
  Number parse_closer(Precedence here);
  Number parse_factor();
  Number primary();
  Number vector_literal();
  Number identifier();
  void member(Number& n);
  double string_comparison();

  // expressions_float.cpp, expressions_vector.cpp: what keywords stand for
  bool float_function(Keyword keyword, double& value);
  double float_argument();
  std::array<double, 2> two_floats();
  double folded(core::FunctionOp op);
  double outside_domain(Keyword function, double x, const Location& where);
  double select();
  double random(double stream);
  double array_dimension(bool size);
  bool vector_function(Keyword keyword, Number& value);
  core::Vec3 vector_argument();
  core::Vec3 trace();
  core::Vec3 extent(bool upper);
  Ref<ObjectDesc> object_argument();
  core::Vec3 turbulence();

  // functions_call.cpp
  Number call_function(const Ref<FunctionDesc>& function, std::string_view name);
  Number call_spline(const Ref<SplineDesc>& spline);

  void trailing_components(Number& colour);
  Number colour_from(Keyword keyword);
  const std::string& literal(const Token& token);
  void append_function(std::string& text, Keyword keyword, bool path);
  std::string one_string(bool path);
  NumberFormat number_format();
  core::Transform transform_block();
  core::Matrix matrix_rows();

  Interpreter& m_in;
  RawExpressions m_raw;
  int m_depth = 0;
};

}  // namespace lentray::parser
