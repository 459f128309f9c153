// Most expressions are made of floats alone: those are read without the room that vectors need.
// What holds a vector is given up at once, and read by the general functions.
#include "parser/interpreter/interpreter.h"
#include "parser/interpreter/raw_expressions.h"
#include "parser/interpreter/raw_operators.h"

namespace lentray::parser {

// Most arguments are numbers or names as they stand.
inline bool RawExpressions::alone(double& x) {
  const bool is_number = m_at->kind == TokenKind::kNumber;
  if ((!is_number && m_at->kind != TokenKind::kIdentifier) || m_at[1].kind != TokenKind::kPunct)
    return false;
  const Punct next = m_at[1].punct;
  if (next != Punct::kComma && next != Punct::kRightParen && next != Punct::kGreater) return false;
  if (is_number) {
    x = m_at++->number;
    return true;
  }
  const Number* number = held<Number>(*m_at);
  if (!number || number->size != 1) return false;
  x = number->v[0];
  ++m_at;
  return true;
}

bool RawExpressions::scalar(double& x, Level level) {
  if (alone(x) || only_floats(level, true, x)) return true;
  Number n;
  if (m_operands_left > 0 && (level == Level::kAdditive ? additive(n) : expression(n)) &&
      n.size == 1) {
    x = n.v[0];
    return true;
  }
  m_operands_left = 0;
  return false;
}

// False, and nothing read, if it is not made of floats. Members (V.x) are floats only where
// `members` says so.
bool RawExpressions::only_floats(Level level, bool members, double& x) {
  const Token* const first = m_at;
  const int depth = m_depth;
  const std::size_t random = m_random.size();
  const bool outer = m_members;
  m_members = members;
  const bool read = level == Level::kAdditive ? binary(x, Precedence::kSum) : whole(x);
  m_members = outer;
  if (read) return true;
  m_at = first;
  m_depth = depth;
  if (m_random.size() > random) undo_random(random);
  return false;
}

// A choice is left to the general functions.
bool RawExpressions::whole(double& x) {
  return binary(x, Precedence::kLogical) && !is(Punct::kQuestion);
}

bool RawExpressions::operand(double& x) {
  if (--m_operands_left < 0) return false;
  switch (m_at->kind) {
    case TokenKind::kNumber: x = m_at++->number; break;
    case TokenKind::kIdentifier: {
      const Symbol* symbol = m_in.symbols.find(m_at->name);
      if (!symbol || symbol->alias || symbol->extras || m_at[1].is(Punct::kDot))
        return identifier(x);
      const Number* number = std::get_if<Number>(&symbol->value);
      if (!number) return identifier(x);
      x = number->v[0];
      ++m_at;
      return number->size == 1;
    }
    case TokenKind::kKeyword:
      if (!float_function(x)) return false;
      break;
    case TokenKind::kPunct:
      if (++m_depth > kDeepest) return false;
      if (accept(Punct::kLeftParen)) {
        if (!whole(x) || !accept(Punct::kRightParen)) return false;
      } else if (accept(Punct::kMinus)) {
        if (!operand(x)) return false;
        x = -x;
      } else {
        return false;
      }
      --m_depth;
      break;
    default: return false;
  }
  return !is(Punct::kDot);
}

bool RawExpressions::identifier(double& x) {
  const Value* value = identifier_value();
  const Number* number = value ? std::get_if<Number>(value) : nullptr;
  if (!number) return false;
  if (!is(Punct::kDot)) {
    x = number->v[0];
    return number->size == 1;
  }
  if (!m_members || m_at[1].kind != TokenKind::kKeyword) return false;
  const int i = component_of(m_at[1].keyword);
  if (i < 0 || i >= number->size) return false;
  x = number->v[static_cast<std::size_t>(i)];
  m_at += 2;
  return true;
}

}  // namespace lentray::parser
