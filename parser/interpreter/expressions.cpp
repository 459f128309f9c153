#include "parser/interpreter/expressions.h"

#include <numbers>

#include "parser/interpreter/interpreter.h"
#include "parser/tokens/keywords.h"

namespace lentray::parser {

Expressions::Expressions(Interpreter& in)
    : m_in(in), m_plain_tokens(in), m_script_tokens(in), m_plain(m_plain_tokens),
      m_script(m_script_tokens) {}

// The expression at `first`, a token of raw()'s list. An `end` must follow it; a bracket is read too.
template <typename Read>
bool Expressions::read_plain(PlainTokens::Kind kind, const Token* first, Punct end, Read read) {
  if (!first || !m_in.has_arithmetic() || !m_in.options.plain_expressions ||
      !m_plain_tokens.begin(m_in.tokens.raw_list(), first, kind) ||
      !m_plain_tokens.finish(read(m_plain), end)) {
    return false;
  }
  m_in.tokens.go_on_at(m_plain_tokens.at() + (end == Punct::kRightParen ? 1 : 0));
  return true;
}

bool Expressions::read_plain(const Token* first, Number& n, Precedence least, Punct end) {
  return read_plain(PlainTokens::Kind::kNumber, first, end,
                    [&](auto& grammar) { return grammar.read(n, least); });
}

bool Expressions::read_plain(const Token* first, std::string& text, Punct end) {
  const std::size_t before = text.size();
  const bool read = read_plain(PlainTokens::Kind::kString, first, end,
                               [&](auto& grammar) { return grammar.string(text); });
  if (!read) text.resize(before);
  return read;
}

bool Expressions::read_plain_condition(double& x) {
  const Token* open = m_in.tokens.raw();
  return open && open->is(Punct::kLeftParen) &&
         read_plain(PlainTokens::Kind::kNumber, open + 1, Punct::kRightParen,
                    [&](auto& grammar) { return grammar.scalar(x, Precedence::kLogical); });
}

Expressions::Item Expressions::read_plain_item(const Token* first, Number& n, std::string& text,
                                               Punct end) {
  if (read_plain(first, n, Precedence::kSum, end)) return Item::kNumber;
  return read_plain(first, text, end) ? Item::kString : Item::kNone;
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

bool Expressions::at_string() {
  const Token& t = m_in.tokens.peek_operand();
  switch (t.kind) {
    case TokenKind::kString: return true;
    case TokenKind::kKeyword: return function_kind(t.keyword) == FunctionKind::kString;
    case TokenKind::kIdentifier: {
      const Value* value = m_in.tokens.value();
      return value && std::holds_alternative<std::string>(*value);
    }
    default: return false;
  }
}

double Expressions::parse_float() {
  double x = 0.0;
  m_script.scalar(x);
  return x;
}

double Expressions::parse_scalar_expression() {
  double x = 0.0;
  m_script.scalar(x, Precedence::kLogical);
  return x;
}

core::Vec3 Expressions::parse_vector() {
  core::Vec3 v;
  m_script.vector(v);
  return v;
}

Number Expressions::parse_number(int min_size, int max_size) {
  Number n;
  Location where;
  m_script.located(n, Precedence::kSum, where);
  if (n.size > max_size) {
    m_in.fail(where, "expected at most " + std::to_string(max_size) + " components but found " +
                         std::to_string(n.size));
  }
  promote(n, min_size);
  return n;
}

Number Expressions::parse_expression() {
  Number n;
  m_script.read(n, Precedence::kLogical);
  return n;
}

Number Expressions::parse_additive() {
  Number n;
  m_script.read(n, Precedence::kSum);
  return n;
}

Number Expressions::parse_operand() {
  Number n;
  m_script.operand(n);
  return n;
}

Number Expressions::parse_vector_literal() {
  Number n;
  m_script.vector_literal(n);
  return n;
}

void Expressions::append_string(std::string& text) { m_script.string(text); }

std::string Expressions::parse_string() {
  std::string text;
  m_script.string(text);
  return text;
}

std::string Expressions::parse_path() {
  std::string text;
  m_script.string(text, true);
  return text;
}

bool Expressions::keyword_float(Keyword keyword, double& value) {
  switch (keyword) {
    case Keyword::kPi: value = std::numbers::pi; return true;
    case Keyword::kTrue:
    case Keyword::kYes:
    case Keyword::kOn: value = 1.0; return true;
    case Keyword::kFalse:
    case Keyword::kNo:
    case Keyword::kOff: value = 0.0; return true;
    case Keyword::kClock:
      m_in.reads.clock = true;
      value = m_in.options.frame.clock;
      return true;
    case Keyword::kClockOn:
      m_in.reads.clock = true;
      value = m_in.options.frame.clock_on ? 1.0 : 0.0;
      return true;
    case Keyword::kVersion: value = m_in.version / 100.0; return true;
    case Keyword::kNow: value = m_in.now(); return true;
    default: return false;
  }
}

}  // namespace lentray::parser
