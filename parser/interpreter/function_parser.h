// Reads `function (params) { expression }` and compiles it. Identifiers of floats are constants by
// the time the function is read; functions may call functions declared before.
// Source: reference manual 3.7, "Function Statement", "User-Defined Functions".
#pragma once

#include <string>
#include <vector>

#include "core/function/node.h"
#include "parser/tokens/token.h"
#include "parser/values/float_functions.h"
#include "parser/values/operators.h"
#include "parser/values/value.h"

namespace lentray::parser {

struct Interpreter;

class FunctionParser {
 public:
  explicit FunctionParser(Interpreter& in) : m_in(in) {}

  /// After `function`: a body with its braces, or the name of a function.
  Ref<FunctionDesc> parse_body();

 private:
  struct Scope {
    std::vector<NameId> parameters;  // names of arguments, in order
    std::vector<NameId> locals;      // variables of the sums being read, innermost last
    std::size_t most_locals = 0;
    bool standard = false;  // x, y, z by default; u and v are the first two
    std::size_t depth = 1;  // see FunctionDesc
    double calls = 1.0;
    std::size_t operands = 0;
  };
  Ref<FunctionDesc> named();
  Ref<FunctionDesc> compiled(const core::FunctionNode& root, const Location& where);
  std::vector<NameId> parameters();

  core::FunctionNodePtr choice();
  core::FunctionNodePtr binary(Precedence least);
  core::FunctionNodePtr quotient(core::FunctionNodePtr left);
  core::FunctionNodePtr unary();
  core::FunctionNodePtr primary();
  core::FunctionNodePtr keyword(const Token& token);
  core::FunctionNodePtr identifier(const Token& token);
  core::FunctionNodePtr call(const Ref<FunctionDesc>& callee, const std::string& name,
                             const Location& where);
  core::FunctionNodePtr series(core::FunctionOp op);
  core::FunctionNodePtr select();
  core::FunctionNodePtr float_function(const FunctionWord& word);
  core::FunctionNodePtr constant(const Token& name, const Number& number);
  core::FunctionNodePtr own_variable(const Token& token);
  int component(std::size_t size);

  Interpreter& m_in;
  Scope m_scope;
  int m_depth = 0;
};

/// A spline or a transform as a function, with as many results as it has components.
Ref<FunctionDesc> spline_function(const Ref<SplineDesc>& spline);
Ref<FunctionDesc> transform_function(const core::Transform& transform);

}  // namespace lentray::parser
