#include "parser/expressions.h"

#include <cmath>
#include <limits>

#include "core/base/color.h"
#include "parser/interpreter.h"
#include "parser/keywords.h"

namespace lentray::parser {
namespace {

constexpr std::size_t kComponents = 5;

bool is_true(double x) { return std::fabs(x) > kCompareEpsilon; }

void promote_both(Number& a, Number& b) {
  if (a.size == b.size) return;
  if (b.size > a.size) promote(a, b.size);
  else if (a.size > b.size) promote(b, a.size);
}

// Applies op to the components; both have the same number.
template <typename Op>
void each(Number& a, const Number& b, Op op) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.size); ++i) a.v[i] = op(a.v[i], b.v[i]);
}

bool starts_operand(Keyword k) {
  switch (k) {
    case Keyword::kAbs: case Keyword::kAcos: case Keyword::kAcosh: case Keyword::kAsc:
    case Keyword::kAsin: case Keyword::kAsinh: case Keyword::kAtan: case Keyword::kAtan2:
    case Keyword::kAtanh: case Keyword::kBitwiseAnd: case Keyword::kBitwiseOr:
    case Keyword::kBitwiseXor: case Keyword::kCeil: case Keyword::kClock: case Keyword::kClockOn:
    case Keyword::kCos: case Keyword::kCosh: case Keyword::kDefined: case Keyword::kDegrees:
    case Keyword::kDimensionSize: case Keyword::kDimensions: case Keyword::kDiv: case Keyword::kExp:
    case Keyword::kFalse: case Keyword::kFileExists: case Keyword::kFloor: case Keyword::kInside:
    case Keyword::kInt: case Keyword::kLn: case Keyword::kLog: case Keyword::kMax:
    case Keyword::kMaxExtent: case Keyword::kMin: case Keyword::kMinExtent: case Keyword::kMod:
    case Keyword::kNo: case Keyword::kNow: case Keyword::kOff: case Keyword::kOn: case Keyword::kPi:
    case Keyword::kPow: case Keyword::kRadians: case Keyword::kRand: case Keyword::kSeed:
    case Keyword::kSelect: case Keyword::kSin: case Keyword::kSinh: case Keyword::kSqr:
    case Keyword::kSqrt: case Keyword::kStrcmp: case Keyword::kStrlen: case Keyword::kT:
    case Keyword::kTan: case Keyword::kTanh: case Keyword::kTrace: case Keyword::kTrue:
    case Keyword::kU: case Keyword::kV: case Keyword::kVal: case Keyword::kVaxisRotate:
    case Keyword::kVcross: case Keyword::kVdot: case Keyword::kVersion: case Keyword::kVlength:
    case Keyword::kVnormalize: case Keyword::kVrotate: case Keyword::kVturbulence: case Keyword::kX:
    case Keyword::kY: case Keyword::kYes: case Keyword::kZ:
      return true;
    default: return false;
  }
}

}  // namespace

void promote(Number& n, int size) {
  if (n.size >= size) return;
  const double fill = n.size == 1 ? n.v[0] : 0.0;
  for (int i = n.size; i < size; ++i) n.v[static_cast<std::size_t>(i)] = fill;
  n.size = size;
}

Number stored(Number n) {
  if (n.size != 5) return n;
  n.is_colour = true;
  for (double& x : n.v) x = static_cast<double>(static_cast<float>(x));
  return n;
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
      return v && (std::holds_alternative<Number>(*v) ||
                   std::holds_alternative<Ref<FunctionDesc>>(*v) ||
                   std::holds_alternative<Ref<SplineDesc>>(*v));
    }
    default: return false;
  }
}

double Expressions::parse_float() {
  const Location where = m_in.tokens.peek_operand().where;
  const Number n = parse_additive();
  if (n.size > 1) m_in.fail(where, "expected a float but found a vector or colour");
  return n.v[0];
}

double Expressions::parse_scalar_expression() {
  const Location where = m_in.tokens.peek_operand().where;
  const Number n = parse_expression();
  if (n.size > 1) m_in.fail(where, "expected a float but found a vector or colour");
  return n.v[0];
}

core::Vec3 Expressions::parse_vector() {
  const Location where = m_in.tokens.peek_operand().where;
  Number n = parse_additive();
  if (n.size > 3) {
    m_in.fail(where, "expected a vector of 3 components but found one of " +
                         std::to_string(n.size) + (n.size == 5 ? " (a colour)" : ""));
  }
  promote(n, 3);
  return {n.v[0], n.v[1], n.v[2]};
}

Number Expressions::parse_number(int min_size, int max_size) {
  const Location where = m_in.tokens.peek_operand().where;
  Number n = parse_additive();
  if (n.size > max_size) {
    m_in.fail(where, "expected at most " + std::to_string(max_size) + " components but found " +
                         std::to_string(n.size));
  }
  promote(n, min_size);
  return n;
}

Number Expressions::parse_expression() {
  const Location where = m_in.tokens.peek_operand().where;
  const Number condition = parse_logical();
  if (!m_in.tokens.accept(Punct::kQuestion)) return condition;
  if (condition.size != 1) m_in.fail(where, "the condition of ?: must be a float");
  m_in.guard_stack();
  const Number yes = parse_expression();
  m_in.tokens.expect(Punct::kColon);
  const Number no = parse_expression();
  return is_true(condition.v[0]) ? yes : no;
}

Number Expressions::parse_logical() {
  Number left = parse_relational();
  for (;;) {
    const bool both = m_in.tokens.accept(Punct::kAmpersand);
    if (!both && !m_in.tokens.accept(Punct::kBar)) return left;
    Number right = parse_relational();
    promote_both(left, right);
    if (both) each(left, right, [](double a, double b) { return is_true(a) && is_true(b); });
    else each(left, right, [](double a, double b) { return is_true(a) || is_true(b); });
  }
}

Number Expressions::parse_relational() {
  if (at_string()) return Number::scalar(string_comparison());
  Number left = parse_additive();
  for (;;) {
    const Token& t = m_in.tokens.peek();
    if (t.kind != TokenKind::kPunct) return left;
    const Punct op = t.punct;
    switch (op) {
      case Punct::kLess: case Punct::kLessEqual: case Punct::kEqual: case Punct::kNotEqual:
      case Punct::kGreater: case Punct::kGreaterEqual: break;
      default: return left;
    }
    m_in.tokens.skip();
    Number right = parse_additive();
    promote_both(left, right);
    const auto same = [](double a, double b) { return !is_true(a - b); };
    switch (op) {
      case Punct::kLess: each(left, right, [](double a, double b) { return a < b; }); break;
      case Punct::kGreater: each(left, right, [](double a, double b) { return a > b; }); break;
      case Punct::kLessEqual:
        each(left, right, [&](double a, double b) { return a <= b || same(a, b); });
        break;
      case Punct::kGreaterEqual:
        each(left, right, [&](double a, double b) { return a >= b || same(a, b); });
        break;
      case Punct::kEqual: each(left, right, same); break;
      default: each(left, right, [&](double a, double b) { return !same(a, b); }); break;
    }
  }
}

double Expressions::string_comparison() {
  const std::string left = parse_string();
  const Token op = m_in.tokens.next();
  const auto compare = [&] { return left.compare(parse_string()); };
  if (op.is(Punct::kLess)) return compare() < 0;
  if (op.is(Punct::kLessEqual)) return compare() <= 0;
  if (op.is(Punct::kEqual)) return compare() == 0;
  if (op.is(Punct::kNotEqual)) return compare() != 0;
  if (op.is(Punct::kGreater)) return compare() > 0;
  if (op.is(Punct::kGreaterEqual)) return compare() >= 0;
  m_in.fail(op.where, "expected a comparison (<, <=, =, !=, >=, >) after a string");
}

Number Expressions::parse_additive() {
  if (m_in.version < 150) return parse_factor();  // the first dialect had no operators
  Number left = parse_term();
  for (;;) {
    const Token& t = m_in.tokens.peek();
    const bool plus = t.is(Punct::kPlus);
    if (!plus && !t.is(Punct::kMinus)) return left;
    m_in.tokens.skip();
    Number right = parse_term();
    if (left.size == 1 && right.size == 1) {
      left.v[0] = plus ? left.v[0] + right.v[0] : left.v[0] - right.v[0];
      continue;
    }
    promote_both(left, right);
    if (plus) each(left, right, [](double a, double b) { return a + b; });
    else each(left, right, [](double a, double b) { return a - b; });
    left.is_colour = false;
  }
}

void Expressions::warn_division() { m_in.warn(m_in.tokens.location(), "division by zero"); }

Number Expressions::parse_term() {
  Number left = parse_factor();
  for (;;) {
    const Token& t = m_in.tokens.peek();
    const bool times = t.is(Punct::kStar);
    if (!times && !t.is(Punct::kSlash)) return left;
    m_in.tokens.skip();
    Number right = parse_factor();
    if (times && left.size == 1 && right.size == 1) {
      left.v[0] *= right.v[0];
      continue;
    }
    promote_both(left, right);
    if (times) {
      each(left, right, [](double a, double b) { return a * b; });
    } else {
      each(left, right, [&](double a, double b) {
        if (b != 0.0) return a / b;
        warn_division();
        return std::numeric_limits<double>::infinity();  // whatever the sign, as in stock
      });
    }
    left.is_colour = false;
  }
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
        const Number n = parse_expression();
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
        for (double& x : n.v) x = punct == Punct::kMinus ? -x : is_true(x) ? 0.0 : 1.0;
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
    if (const Symbol* symbol = tokens.symbol(); symbol && !symbol->macro && !symbol->file) {
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
  int i = -1;
  switch (name.kind == TokenKind::kKeyword ? name.keyword : Keyword::kNone) {
    case Keyword::kX: case Keyword::kU: case Keyword::kRed: i = 0; break;
    case Keyword::kY: case Keyword::kV: case Keyword::kGreen: i = 1; break;
    case Keyword::kZ: case Keyword::kBlue: i = 2; break;
    case Keyword::kT: case Keyword::kFilter: i = 3; break;
    case Keyword::kTransmit: i = 4; break;
    default:
      m_in.fail(name.where, "expected x, y, z, t, u, v or a colour component after '.' but found " +
                                m_in.tokens.describe(name));
  }
  if (i >= n.size) {
    m_in.fail(name.where, "." + std::string(m_in.names.text(name.name)) + " of something with " +
                              std::to_string(n.size) + (n.size == 1 ? " component" : " components"));
  }
  n = Number::scalar(n.v[static_cast<std::size_t>(i)]);
}

}  // namespace lentray::parser
