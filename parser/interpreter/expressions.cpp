#include "parser/interpreter/expressions.h"

#include "core/base/color.h"
#include "parser/interpreter/interpreter.h"
#include "parser/tokens/keywords.h"

namespace lentray::parser {
namespace {

constexpr std::size_t kComponents = 5;

// The first dialect had no operators.
constexpr int kHasOperators = 150;

}  // namespace

bool Expressions::allows_raw() const {
  return m_in.version >= kHasOperators && m_in.options.raw_expressions;
}

bool Expressions::read_raw(RawExpressions::Level level, Number& n) {
  const TokenList* list = nullptr;
  const Token* at = m_in.tokens.raw(list);
  if (!at || !allows_raw() || !m_raw.read(*list, at, level, n)) return false;
  m_in.tokens.go_on_at(at);
  return true;
}

bool Expressions::read_raw_string(std::string& text) {
  const TokenList* list = nullptr;
  const Token* at = m_in.tokens.raw(list);
  if (!at || !allows_raw() || !m_raw.read(*list, at, text)) return false;
  m_in.tokens.go_on_at(at);
  return true;
}

RawExpressions::Item Expressions::read_raw_item(Number& n, std::string& text) {
  const TokenList* list = nullptr;
  const Token* at = m_in.tokens.raw(list);
  if (!at || !allows_raw()) return RawExpressions::Item::kNone;
  if (at->is(Punct::kComma)) ++at;
  const RawExpressions::Item item = m_raw.read_item(*list, at, n, text);
  if (item != RawExpressions::Item::kNone) m_in.tokens.go_on_at(at);
  return item;
}

// The name of `NAME = ...`, if that is what comes next.
const Token* Expressions::raw_assignment(const TokenList*& list) const {
  const Token* name = m_in.tokens.raw(list);
  const bool assignment =
      name && allows_raw() && name->kind == TokenKind::kIdentifier && name[1].is(Punct::kEqual);
  return assignment ? name : nullptr;
}

const Token* Expressions::read_raw_assignment(Number& n) {
  const TokenList* list = nullptr;
  const Token* name = raw_assignment(list);
  if (!name) return nullptr;
  const Token* at = name + 2;
  if (!m_raw.read(*list, at, RawExpressions::Level::kAdditive, n, Punct::kSemicolon))
    return nullptr;
  m_in.tokens.go_on_at(at);
  return name;
}

const Token* Expressions::read_raw_assignment(std::string& text) {
  const TokenList* list = nullptr;
  const Token* name = raw_assignment(list);
  if (!name) return nullptr;
  const Token* at = name + 2;
  if (!m_raw.read(*list, at, text, Punct::kSemicolon)) return nullptr;
  m_in.tokens.go_on_at(at);
  return name;
}

bool Expressions::read_raw_condition(Number& n) {
  const TokenList* list = nullptr;
  const Token* open = m_in.tokens.raw(list);
  if (!open || !allows_raw() || !open->is(Punct::kLeftParen)) return false;
  const Token* at = open + 1;
  if (!m_raw.read(*list, at, RawExpressions::Level::kEverything, n, Punct::kRightParen) ||
      n.size > 1) {
    return false;
  }
  m_in.tokens.go_on_at(at + 1);
  return true;
}

bool Expressions::at_expression() {
  const Token& t = m_in.tokens.peek();
  switch (t.kind) {
    case TokenKind::kNumber: return true;
    case TokenKind::kKeyword: return starts_operand(t.keyword);
    case TokenKind::kPunct:
      return t.punct == Punct::kLess || t.punct == Punct::kLeftParen || t.punct == Punct::kMinus ||
             t.punct == Punct::kPlus || t.punct == Punct::kExclamation;
    case TokenKind::kIdentifier: {
      const Value* v = m_in.tokens.value();
      return v &&
             (std::holds_alternative<Number>(*v) || std::holds_alternative<Ref<FunctionDesc>>(*v) ||
              std::holds_alternative<Ref<SplineDesc>>(*v));
    }
    default: return false;
  }
}

// What comes next, of at most so many components: if there are more, `where` is the
// place a message points to. It is looked for only then, if the token stands in the list.
Number Expressions::parse_located(RawExpressions::Level level, int most, Location& where) {
  const TokenList* list = nullptr;
  const Token* raw = m_in.tokens.raw(list);
  Number n;
  if (raw && read_raw(level, n)) {
    if (n.size > most) where = raw->where;
    return n;
  }
  where = raw && raw->passive ? raw->where : m_in.tokens.peek_operand().where;
  return level == RawExpressions::Level::kAdditive ? parse_additive() : parse_expression();
}

double Expressions::parse_one(RawExpressions::Level level) {
  Location where;
  const Number n = parse_located(level, 1, where);
  if (n.size > 1) m_in.fail(where, "expected a float but found a vector or colour");
  return n.v[0];
}

double Expressions::parse_float() { return parse_one(RawExpressions::Level::kAdditive); }
double Expressions::parse_scalar_expression() {
  return parse_one(RawExpressions::Level::kEverything);
}

core::Vec3 Expressions::parse_vector() {
  Location where;
  const Number n = parse_located(RawExpressions::Level::kAdditive, 3, where);
  if (n.size > 3) {
    m_in.fail(where, "expected a vector of 3 components but found one of " +
                         std::to_string(n.size) + (n.size == 5 ? " (a colour)" : ""));
  }
  return to_vector(n);
}

Number Expressions::parse_number(int min_size, int max_size) {
  Location where;
  Number n = parse_located(RawExpressions::Level::kAdditive, max_size, where);
  if (n.size > max_size) {
    m_in.fail(where, "expected at most " + std::to_string(max_size) + " components but found " +
                         std::to_string(n.size));
  }
  promote(n, min_size);
  return n;
}

Number Expressions::parse_expression() {
  if (Number n; read_raw(RawExpressions::Level::kEverything, n)) return n;
  const Location where = m_in.tokens.peek_operand().where;
  const Number condition = parse_binary(Precedence::kLogical);
  if (!m_in.tokens.accept(Punct::kQuestion)) return condition;
  if (condition.size != 1) m_in.fail(where, "the condition of ?: must be a float");
  m_in.guard_stack();
  const Number yes = parse_expression();
  m_in.tokens.expect(Punct::kColon);
  const Number no = parse_expression();
  return is_true(condition.v[0]) ? yes : no;
}

// Operators that bind as `here` says, and what stands between them.
Number Expressions::parse_binary(Precedence here) {
  Number left = parse_closer(here);
  for (;;) {
    const Token& t = m_in.tokens.peek();
    if (precedence(t) != here) return left;
    const Punct op = t.punct;
    m_in.tokens.skip();
    if (!operate(op, left, parse_closer(here))) {
      m_in.warn(m_in.tokens.location(), "division by zero");
    }
  }
}

// An operand of these: what binds closer.
Number Expressions::parse_closer(Precedence here) {
  switch (here) {
    case Precedence::kLogical:
      return at_string() ? Number::scalar(string_comparison())
                         : parse_binary(Precedence::kComparison);
    case Precedence::kComparison: return parse_additive();
    case Precedence::kSum: return parse_binary(Precedence::kProduct);
    default: return parse_factor();
  }
}

double Expressions::string_comparison() {
  const std::string left = parse_string();
  const Token op = m_in.tokens.next();
  if (precedence(op) != Precedence::kComparison) {
    m_in.fail(op.where, "expected a comparison (<, <=, =, !=, >=, >) after a string");
  }
  double order = left.compare(parse_string());
  operate(op.punct, order, 0.0);
  return order;
}

Number Expressions::parse_additive() {
  if (m_in.version < kHasOperators) return parse_factor();
  if (Number n; read_raw(RawExpressions::Level::kAdditive, n)) return n;
  return parse_binary(Precedence::kSum);
}

Number Expressions::parse_factor() {
  if (++m_depth % 64 == 0) m_in.guard_stack();
  Number n = primary();
  --m_depth;
  const Token& t = m_in.tokens.peek();
  if (t.is(Punct::kDot)) member(n);
  return n;
}

Number Expressions::primary() {
  TokenReader& tokens = m_in.tokens;
  const Token& t = tokens.peek_operand();
  switch (t.kind) {
    case TokenKind::kNumber: {
      const double number = t.number;
      tokens.skip();
      return Number::scalar(number);
    }
    case TokenKind::kIdentifier: return identifier();
    case TokenKind::kPunct: {
      const Punct punct = t.punct;
      if (punct == Punct::kLess) return vector_literal();
      if (punct == Punct::kLeftParen) {
        tokens.skip();
        Number n = parse_expression();
        n.keeps_rest = false;
        tokens.expect(Punct::kRightParen);
        return n;
      }
      if (punct == Punct::kPlus) {
        tokens.skip();
        return primary();
      }
      if (punct == Punct::kMinus || punct == Punct::kExclamation) {
        tokens.skip();
        Number n = parse_factor();
        if (punct == Punct::kMinus)
          negate(n);
        else
          logical_not(n);
        return n;
      }
      break;
    }
    case TokenKind::kKeyword: {
      const Keyword keyword = t.keyword;
      double value = 0.0;
      Number number;
      if (keyword_float(keyword, value)) {
        tokens.skip();
        return Number::scalar(value);
      }
      if (!starts_operand(keyword)) break;
      tokens.skip();
      if (float_function(keyword, value)) return Number::scalar(value);
      if (vector_function(keyword, number)) return number;
      break;
    }
    default: break;
  }
  tokens.fail_expected("a number, vector or identifier of one");
}

Number Expressions::identifier() {
  TokenReader& tokens = m_in.tokens;
  Value* value = tokens.value();
  if (value) {
    if (const Number* n = std::get_if<Number>(value)) {
      const Number copy = *n;
      tokens.skip();
      return copy;
    }
    const Token name = tokens.peek_operand();
    if (const auto* f = std::get_if<Ref<FunctionDesc>>(value)) {
      const Ref<FunctionDesc> function = *f;
      tokens.skip();
      return call_function(function, m_in.names.text(name.name));
    }
    if (const auto* s = std::get_if<Ref<SplineDesc>>(value)) {
      const Ref<SplineDesc> spline = *s;
      tokens.skip();
      return call_spline(spline);
    }
  } else {
    const Token name = tokens.peek_operand();
    const std::string text(m_in.names.text(name.name));
    if (tokens.element_array()) {
      m_in.fail(name.where, "element " + std::to_string(tokens.element_index()) + " of array '" +
                                text + "' has no value yet");
    }
    if (const Symbol* symbol = tokens.symbol(); symbol && !symbol->macro() && !symbol->file()) {
      m_in.fail(name.where, "'" + text + "' has no value yet");
    }
    if (!tokens.symbol()) {
      m_in.fail(name.where, "undeclared identifier '" + text + "'" + m_in.suggestion(text));
    }
  }
  tokens.fail_expected("a number, vector or identifier of one");
}

Number Expressions::vector_literal() {
  TokenReader& tokens = m_in.tokens;
  Number n;
  if (tokens.accept_literal_vector(n)) return n;
  tokens.skip();
  tokens.enter();
  n = {};
  n.size = 0;
  while (!tokens.at(Punct::kGreater)) {
    if (n.size == static_cast<int>(kComponents)) {
      tokens.fail_expected("'>' after the 5 components of a vector");
    }
    n.v[static_cast<std::size_t>(n.size++)] = parse_float();
    tokens.comma();
  }
  if (n.size < 2) tokens.fail_expected("at least 2 components in a vector");
  tokens.leave();
  tokens.skip();
  return n;
}

// .x .y .z .t .u .v and the names of colour components.
void Expressions::member(Number& n) {
  m_in.tokens.skip();
  const Token name = m_in.tokens.next();
  if (name.is(Keyword::kGray)) {
    if (n.size < 2) m_in.fail(name.where, ".gray of a float");
    // The weights of stock.
    n = Number::scalar(0.297 * n.v[0] + 0.589 * n.v[1] + 0.114 * n.v[2]);
    return;
  }
  const int i = name.kind == TokenKind::kKeyword ? component_of(name.keyword) : -1;
  if (i < 0) {
    m_in.fail(name.where, "expected x, y, z, t, u, v or a colour component after '.' but found " +
                              m_in.tokens.describe(name));
  }
  if (i >= n.size) {
    m_in.fail(name.where, "." + std::string(m_in.names.text(name.name)) + " of something with " +
                              std::to_string(n.size) +
                              (n.size == 1 ? " component" : " components"));
  }
  take_component(n, i);
}

}  // namespace lentray::parser
