#include "parser/interpreter/function_parser.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/function/internal.h"
#include "parser/interpreter/interpreter.h"

namespace lentray::parser {
namespace {

using core::FunctionNodePtr;
using core::FunctionOp;
using core::make_node;

// .gray is no component but a mixture of three.
constexpr int kGrayComponent = 5;

// .hf too: red as the coarse, green as the fine part of a height.
constexpr int kHeightComponent = 6;

using Weights = std::array<double, 3>;
constexpr Weights kGray = {0.297, 0.589, 0.114};
constexpr Weights kHeight = {0.996093, 0.996093 / 255.0, 0.0};

// .gray or .hf of a function of colours.
class MixtureOf final : public core::Function {
 public:
  MixtureOf(std::shared_ptr<const core::Function> colour, const Weights& weights)
      : m_colour(std::move(colour)), m_weights(weights) {}
  std::size_t parameters() const override { return m_colour->parameters(); }
  double evaluate(std::span<const double> arguments) const override {
    std::array<double, core::kMostResults> c{};
    m_colour->evaluate_all(arguments, c);
    return m_weights[0] * c[0] + m_weights[1] * c[1] + m_weights[2] * c[2];
  }
  std::string not_yet() const override { return m_colour->not_yet(); }

 private:
  std::shared_ptr<const core::Function> m_colour;
  Weights m_weights;
};

/// A number with its sign.
std::optional<double> literal(const core::FunctionNode& node) {
  if (node.op == FunctionOp::kConstant) return node.value;
  if (node.op != FunctionOp::kNegate) return std::nullopt;
  const auto number = literal(*node.operands[0]);
  return number ? std::optional(-*number) : std::nullopt;
}

}  // namespace

Ref<FunctionDesc> FunctionParser::parse_body() {
  TokenReader& tokens = m_in.tokens;
  if (tokens.peek_operand().kind == TokenKind::kIdentifier) return named();
  // A function may be read while the arguments of another are (in a macro): each has its scope.
  const Scope outer = std::exchange(m_scope, {});
  m_scope.parameters = parameters();
  const Location where = tokens.peek().where;
  tokens.expect(Punct::kLeftCurly);
  Ref<FunctionDesc> result;
  const Token& first = tokens.peek_operand();
  if (first.is(Keyword::kPigment) || first.is(Keyword::kPattern)) {
    result = m_in.productions.pattern_function(m_in.parser);
  } else if (first.is(Keyword::kTransform)) {
    result = transform_function(m_in.expressions.parse_transform_statement());
  } else if (first.is(Keyword::kSpline)) {
    tokens.skip();
    result = spline_function(m_in.expressions.parse_spline());
  } else if (tokens.accept(Keyword::kInternal)) {
    auto desc = std::make_shared<FunctionDesc>();
    tokens.expect(Punct::kLeftParen);
    const int number = to_int(m_in.expressions.parse_float());
    tokens.expect(Punct::kRightParen);
    desc->function = core::internal_function(number, m_in.noise_generator);
    if (!desc->function)
      m_in.fail(where, "there is no internal function " + std::to_string(number));
    result = desc;
  } else {
    result = compiled(*choice(), where);
  }
  tokens.expect(Punct::kRightCurly);
  m_scope = outer;
  return result;
}

Ref<FunctionDesc> FunctionParser::compiled(const core::FunctionNode& root, const Location& where) {
  const Limits& limits = m_in.options.limits;
  if (m_scope.depth > limits.function_depth) {
    m_in.fail(where, "functions call functions more than " + std::to_string(limits.function_depth) +
                         " deep");
  }
  if (m_scope.calls > limits.function_calls) {
    m_in.fail(where, "the function makes too many calls of others for one value");
  }
  auto desc = std::make_shared<FunctionDesc>();
  desc->depth = m_scope.depth;
  desc->calls = m_scope.calls;
  try {
    desc->function = core::compile_function(root, m_scope.parameters.size(), m_scope.most_locals,
                                            limits.function_terms);
  } catch (const std::length_error& error) {
    m_in.fail(where, error.what());
  }
  return desc;
}

Ref<FunctionDesc> FunctionParser::named() {
  TokenReader& tokens = m_in.tokens;
  const Value* value = tokens.value();
  const auto* function = value ? std::get_if<Ref<FunctionDesc>>(value) : nullptr;
  if (!function) tokens.fail_expected("a function");
  const Ref<FunctionDesc> copy = *function;
  tokens.skip();
  return copy;
}

std::vector<NameId> FunctionParser::parameters() {
  TokenReader& tokens = m_in.tokens;
  std::vector<NameId> names;
  if (!tokens.accept(Punct::kLeftParen)) {
    m_scope.standard = true;
    for (const char* name : {"x", "y", "z"}) names.push_back(m_in.names.intern(name));
    return names;
  }
  const bool before = tokens.plain_names;
  tokens.plain_names = true;
  while (!tokens.accept(Punct::kRightParen)) {
    const Token& t = tokens.peek();
    const bool letter = t.is(Keyword::kX) || t.is(Keyword::kY) || t.is(Keyword::kZ) ||
                        t.is(Keyword::kT) || t.is(Keyword::kU) || t.is(Keyword::kV);
    if (t.kind != TokenKind::kIdentifier && !letter) {
      tokens.fail_expected("the name of a function parameter");
    }
    if (names.size() == core::kMostParameters) {
      m_in.fail(t.where,
                "a function has at most " + std::to_string(core::kMostParameters) + " parameters");
    }
    names.push_back(t.name);
    tokens.skip();
    tokens.comma();
  }
  tokens.plain_names = before;
  return names;
}

FunctionNodePtr FunctionParser::choice() {
  FunctionNodePtr condition = binary(Precedence::kLogical);
  if (!m_in.tokens.accept(Punct::kQuestion)) return condition;
  FunctionNodePtr yes = choice();
  m_in.tokens.expect(Punct::kColon);
  FunctionNodePtr no = choice();
  return make_node(FunctionOp::kChoose, std::move(condition), std::move(yes), std::move(no));
}

// An operand and the operators behind it, those that bind at least so closely.
FunctionNodePtr FunctionParser::binary(Precedence least) {
  FunctionNodePtr left = unary();
  for (;;) {
    const FunctionOperator here = function_operator(m_in.tokens.peek());
    if (here.precedence < least) return left;
    m_in.tokens.skip();
    left = here.op == FunctionOp::kDivide
               ? quotient(std::move(left))
               : make_node(here.op, std::move(left), binary(closer(here.precedence)));
  }
}

// As stock: what is divided by a number is multiplied by its inverse, which is another last bit; by
// a number in parentheses it is divided, and numbers are divided by each other at once.
FunctionNodePtr FunctionParser::quotient(FunctionNodePtr left) {
  const Token first = m_in.tokens.peek_operand();
  FunctionNodePtr right = unary();
  const std::optional<double> divisor =
      first.is(Punct::kLeftParen) ? std::nullopt : literal(*right);
  if (!divisor) return make_node(FunctionOp::kDivide, std::move(left), std::move(right));
  if (const auto dividend = literal(*left)) return core::constant_node(*dividend / *divisor);
  if (*divisor == 0.0) m_in.fail(first.where, "the function divides by zero");
  return make_node(FunctionOp::kMultiply, std::move(left), core::constant_node(1.0 / *divisor));
}

FunctionNodePtr FunctionParser::unary() {
  if (++m_depth % 64 == 0) m_in.guard_stack();
  // The compiler goes down a long sum as deep as it has terms.
  if (++m_scope.operands > m_in.options.limits.function_operands) {
    m_in.fail(m_in.tokens.location(), "a function has at most " +
                                          std::to_string(m_in.options.limits.function_operands) +
                                          " operands");
  }
  FunctionNodePtr node;
  const Token& t = m_in.tokens.peek_operand();
  if (t.is(Punct::kMinus) || t.is(Punct::kExclamation)) {
    const bool minus = t.is(Punct::kMinus);
    m_in.tokens.skip();
    node = make_node(minus ? FunctionOp::kNegate : FunctionOp::kNot, unary());
  } else if (t.is(Punct::kPlus)) {
    m_in.tokens.skip();
    node = unary();
  } else {
    node = primary();
  }
  --m_depth;
  return node;
}

FunctionNodePtr FunctionParser::primary() {
  TokenReader& tokens = m_in.tokens;
  const Token token = tokens.peek_operand();
  if (token.kind == TokenKind::kNumber) {
    tokens.skip();
    return core::constant_node(token.number);
  }
  if (token.is(Punct::kLeftParen)) {
    tokens.skip();
    FunctionNodePtr inner = choice();
    tokens.expect(Punct::kRightParen);
    return inner;
  }
  if (token.is(Punct::kLess)) return constant(token, m_in.expressions.parse_vector_literal());
  if (FunctionNodePtr own = own_variable(token)) return own;
  if (token.kind == TokenKind::kKeyword) return keyword(token);
  if (token.kind == TokenKind::kIdentifier) return identifier(token);
  tokens.fail_expected("an operand of the function");
}

// A parameter or the variable of a sum; consumed if it is one.
FunctionNodePtr FunctionParser::own_variable(const Token& token) {
  if (token.kind != TokenKind::kIdentifier && token.kind != TokenKind::kKeyword) return nullptr;
  auto node = std::make_unique<core::FunctionNode>();
  const auto found_local = std::find(m_scope.locals.rbegin(), m_scope.locals.rend(), token.name);
  if (found_local != m_scope.locals.rend()) {
    node->op = FunctionOp::kLocal;
    node->index = static_cast<std::size_t>(m_scope.locals.rend() - found_local - 1);
  } else {
    const auto& all = m_scope.parameters;
    auto found = std::find(all.begin(), all.end(), token.name);
    if (found == all.end() && m_scope.standard) {
      if (token.is(Keyword::kU)) found = all.begin();
      if (token.is(Keyword::kV)) found = all.begin() + 1;
    }
    if (found == all.end()) return nullptr;
    node->op = FunctionOp::kParameter;
    node->index = static_cast<std::size_t>(found - all.begin());
  }
  m_in.tokens.skip();
  return node;
}

FunctionNodePtr FunctionParser::keyword(const Token& token) {
  TokenReader& tokens = m_in.tokens;
  double value = 0.0;
  if (m_in.expressions.keyword_float(token.keyword, value)) {
    tokens.skip();
    return core::constant_node(value);
  }
  if (const FunctionWord& word = function_word(token.keyword); word.in_functions) {
    tokens.skip();
    return float_function(word);
  }
  switch (token.keyword) {
    case Keyword::kSelect: tokens.skip(); return select();
    case Keyword::kSum: tokens.skip(); return series(FunctionOp::kSum);
    case Keyword::kProd: tokens.skip(); return series(FunctionOp::kProd);
    default: break;
  }
  // x, y, z ... that are no parameters, and functions of constants, have their value now.
  if (m_in.expressions.at_expression()) return constant(token, m_in.expressions.parse_operand());
  tokens.fail_expected("an operand of the function");
}

// Behind its keyword.
FunctionNodePtr FunctionParser::float_function(const FunctionWord& word) {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Punct::kLeftParen);
  FunctionNodePtr value = choice();
  if (word.kind == FunctionKind::kTwoFloats) {
    tokens.comma();
    value = make_node(word.op, std::move(value), choice());
  } else if (word.kind == FunctionKind::kFold) {
    if (!tokens.at(Punct::kComma)) tokens.fail_expected("at least two arguments");
    while (tokens.accept(Punct::kComma)) value = make_node(word.op, std::move(value), choice());
  } else {
    value = make_node(word.op, std::move(value));
  }
  tokens.expect(Punct::kRightParen);
  return value;
}

FunctionNodePtr FunctionParser::select() {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Punct::kLeftParen);
  auto node = std::make_unique<core::FunctionNode>();
  node->op = FunctionOp::kSelect;
  do {
    node->operands.push_back(choice());
  } while (tokens.accept(Punct::kComma));
  if (node->operands.size() < 3 || node->operands.size() > 4) {
    tokens.fail_expected("select() with 3 or 4 arguments");
  }
  tokens.expect(Punct::kRightParen);
  return node;
}

// sum (variable, first, last, expression)
FunctionNodePtr FunctionParser::series(FunctionOp op) {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Punct::kLeftParen);
  const Token variable = tokens.read_name("the variable of the sum");
  tokens.skip();
  tokens.comma();
  FunctionNodePtr first = choice();
  tokens.comma();
  FunctionNodePtr last = choice();
  tokens.comma();
  m_scope.locals.push_back(variable.name);
  m_scope.most_locals = std::max(m_scope.most_locals, m_scope.locals.size());
  FunctionNodePtr term = choice();
  m_scope.locals.pop_back();
  tokens.expect(Punct::kRightParen);
  FunctionNodePtr node = make_node(op, std::move(first), std::move(last), std::move(term));
  node->index = m_scope.locals.size();
  return node;
}

// After '.': which component; -1 if none follows.
int FunctionParser::component(std::size_t size) {
  TokenReader& tokens = m_in.tokens;
  if (!tokens.accept(Punct::kDot)) return -1;
  const Token name = tokens.next();
  int i = name.kind == TokenKind::kKeyword ? component_of(name.keyword) : -1;
  const std::string_view word =
      name.kind == TokenKind::kIdentifier ? m_in.names.text(name.name) : std::string_view();
  if (name.is(Keyword::kGray) || word == "grey") i = kGrayComponent;
  if (word == "hf") i = kHeightComponent;
  if (i < 0) {
    m_in.fail(name.where, "expected a component of a value with " + std::to_string(size) +
                              " components after '.' but found " + tokens.describe(name));
  }
  return i;
}

FunctionNodePtr FunctionParser::constant(const Token& name, const Number& number) {
  const int i = component(static_cast<std::size_t>(number.size));
  if (i == kGrayComponent || i == kHeightComponent) {
    const Weights& w = i == kGrayComponent ? kGray : kHeight;
    return core::constant_node(w[0] * number.v[0] + w[1] * number.v[1] + w[2] * number.v[2]);
  }
  if (i >= number.size) m_in.fail(name.where, "this value has no such component");
  if (i < 0 && number.size > 1) {
    m_in.fail(name.where,
              "a function is made of floats: take a component of this vector or colour");
  }
  return core::constant_node(number.v[static_cast<std::size_t>(std::max(i, 0))]);
}

FunctionNodePtr FunctionParser::identifier(const Token& token) {
  TokenReader& tokens = m_in.tokens;
  const std::string name(m_in.names.text(token.name));
  const Value* value = tokens.value();
  if (!value) {
    if (tokens.symbol()) m_in.fail(token.where, "'" + name + "' has no value yet");
    m_in.fail(token.where,
              "undeclared identifier '" + name + "' in a function" + m_in.suggestion(name));
  }
  if (const Number* number = std::get_if<Number>(value)) {
    const Number copy = *number;
    tokens.skip();
    return constant(token, copy);
  }
  if (const auto* function = std::get_if<Ref<FunctionDesc>>(value)) {
    const Ref<FunctionDesc> callee = *function;
    tokens.skip();
    return call(callee, name, token.where);
  }
  if (const auto* spline = std::get_if<Ref<SplineDesc>>(value)) {
    const Ref<FunctionDesc> callee = spline_function(*spline);
    tokens.skip();
    return call(callee, name, token.where);
  }
  tokens.fail_expected("an operand of the function");
}

FunctionNodePtr FunctionParser::call(const Ref<FunctionDesc>& callee, const std::string& name,
                                     const Location& where) {
  TokenReader& tokens = m_in.tokens;
  auto node = std::make_unique<core::FunctionNode>();
  node->op = FunctionOp::kCall;
  node->callee = callee->function;
  m_scope.depth = std::max(m_scope.depth, callee->depth + 1);
  m_scope.calls += callee->calls;
  tokens.expect(Punct::kLeftParen);
  while (!tokens.at(Punct::kRightParen)) {
    node->operands.push_back(choice());
    if (!tokens.accept(Punct::kComma)) break;
  }
  const std::size_t wanted = callee->function->parameters();
  if (node->operands.size() != wanted) {
    m_in.fail(where, "function " + name + " takes " + std::to_string(wanted) +
                         " arguments, found " + std::to_string(node->operands.size()));
  }
  tokens.expect(Punct::kRightParen);
  const std::size_t results = callee->function->results();
  const int i = component(results);
  const bool mixture = i == kGrayComponent || i == kHeightComponent;
  if (mixture) {
    node->callee = std::make_shared<MixtureOf>(node->callee, i == kGrayComponent ? kGray : kHeight);
  }
  if (results > 1 && i < 0) {
    m_in.fail(where, "function " + name + " gives " + std::to_string(results) +
                         " components: take one of them (.x, .red, ...)");
  }
  // A component that the result does not have is 0, as in stock.
  if (!mixture && i >= static_cast<int>(results)) return core::constant_node(0.0);
  node->index = mixture ? 0 : static_cast<std::size_t>(std::max(i, 0));
  return node;
}

}  // namespace lentray::parser
