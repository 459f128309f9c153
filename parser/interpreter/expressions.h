// Expressions: floats, vectors of 2 to 5 components, colours, strings, transforms, splines.
// They are evaluated while they are read, as PlainTokens where that will do. Components promote as
// stock does: a float fills all of them, a shorter vector is padded with zeros.
// Source: reference manual 3.7, "Float Expressions", "Vector Expressions", "Specifying Colors",
// "Strings"; precision, promotion and error cases as measured on stock.
#pragma once

#include <optional>
#include <string>

#include "core/base/transform.h"
#include "parser/interpreter/expression_grammar.h"
#include "parser/interpreter/plain_tokens.h"
#include "parser/interpreter/script_tokens.h"
#include "parser/tokens/token.h"
#include "parser/values/value.h"

namespace lentray::parser {

struct ColourWord;
struct Interpreter;

class Expressions {
 public:
  explicit Expressions(Interpreter& in);

  Number parse_expression();         ///< everything: ?:, logic, comparison, arithmetic
  Number parse_additive();           ///< arithmetic only: what stands where no parentheses do
  double parse_float();              ///< arithmetic, one component
  double parse_scalar_expression();  ///< everything, one component
  core::Vec3 parse_vector();
  Number parse_number(int min_size, int max_size);
  bool at_expression();
  Number parse_operand();  ///< one operand with its .member
  Number parse_vector_literal();
  /// A keyword that is a float by itself (pi, on, clock ...); nothing is consumed.
  bool keyword_float(Keyword keyword, double& value);

  // expressions_colour.cpp
  Number parse_colour();
  bool at_colour_keyword();
  bool at_colour();

  bool at_string();
  std::string parse_string();
  std::string parse_path();               ///< a file name: backslashes stay
  void append_string(std::string& text);  ///< behind `text`

  // expressions_transform.cpp
  std::optional<core::Transform> accept_transform();
  core::Transform parse_transform_statement();  ///< at `transform`

  // expressions_call.cpp
  Ref<SplineDesc> parse_spline();  ///< after `spline`

  // Of PlainTokens. Nothing is read where these are false.
  /// The expression at `first`: TokenReader::raw(), a token behind it, or null. An `end` must follow.
  bool read_plain(const Token* first, Number& n, Precedence least, Punct end = Punct::kNone);
  /// Put behind `text`.
  bool read_plain(const Token* first, std::string& text, Punct end = Punct::kNone);
  enum class Item { kNone, kNumber, kString };
  Item read_plain_item(const Token* first, Number& n, std::string& text, Punct end = Punct::kNone);
  /// `( EXPRESSION )` of one component comes next.
  bool read_plain_condition(double& x);
  /// Within an expression of PlainTokens.
  bool plain_subscript(double& x) { return m_plain.scalar(x); }

 private:
  template <typename Read>
  bool read_plain(PlainTokens::Kind kind, const Token* first, Punct end, Read read);
  void trailing_components(Number& colour);
  Number colour_from(const ColourWord& word);
  core::Transform transform_block();
  core::Matrix matrix_rows();

  Interpreter& m_in;
  PlainTokens m_plain_tokens;
  ScriptTokens m_script_tokens;
  ExpressionGrammar<PlainTokens> m_plain;
  ExpressionGrammar<ScriptTokens> m_script;
};

}  // namespace lentray::parser
