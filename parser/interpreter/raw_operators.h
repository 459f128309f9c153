// The operators of RawExpressions: one loop for floats and for vectors. Private to its sources.
#pragma once

#include <array>

#include "parser/interpreter/raw_expressions.h"

namespace lentray::parser {

namespace raw {

constexpr std::array<Precedence, 256> precedences() {
  std::array<Precedence, 256> all{};
  const auto set = [&all](Punct p, Precedence of) { all[static_cast<std::size_t>(p)] = of; };
  set(Punct::kAmpersand, Precedence::kLogical);
  set(Punct::kBar, Precedence::kLogical);
  for (auto p = static_cast<std::size_t>(Punct::kLess); p <= static_cast<std::size_t>(Punct::kEqual); ++p) {
    all[p] = Precedence::kComparison;
  }
  set(Punct::kPlus, Precedence::kSum);
  set(Punct::kMinus, Precedence::kSum);
  set(Punct::kStar, Precedence::kProduct);
  set(Punct::kSlash, Precedence::kProduct);
  return all;
}
inline constexpr auto kPrecedences = precedences();

inline Precedence precedence(const Token& token) {
  return token.kind == TokenKind::kPunct ? kPrecedences[static_cast<std::size_t>(token.punct)]
                                         : Precedence::kNone;
}

inline Precedence closer(Precedence p) {
  return static_cast<Precedence>(static_cast<int>(p) + 1);
}

// False for a division by zero: something has to be said then.
inline bool apply(Punct op, double& left, double right) {
  switch (op) {
    case Punct::kPlus: left += right; return true;
    case Punct::kMinus: left -= right; return true;
    case Punct::kStar: left *= right; return true;
    case Punct::kSlash: left /= right; return right != 0.0;
    case Punct::kAmpersand: case Punct::kBar:
      left = logical(left, right, op == Punct::kAmpersand);
      return true;
    default: left = compare(left, right, op); return true;
  }
}

inline bool apply(Punct op, Number& left, const Number& right) {
  switch (op) {
    case Punct::kPlus: case Punct::kMinus: add(left, right, op == Punct::kPlus); return true;
    case Punct::kStar: multiply(left, right); return true;
    case Punct::kSlash: return divide(left, right);
    case Punct::kAmpersand: case Punct::kBar:
      logical(left, right, op == Punct::kAmpersand);
      return true;
    default: compare(left, right, op); return true;
  }
}

}  // namespace raw

// An operand and the operators behind it, those that bind at least so closely.
template <typename N>
bool RawExpressions::binary(N& left, Precedence least) {
  return operand(left) && (raw::precedence(*m_at) < least || rest(left, least));
}

template <typename N>
bool RawExpressions::rest(N& left, Precedence least) {
  for (;;) {
    const Precedence here = raw::precedence(*m_at);
    if (here < least) return true;
    const Punct op = m_at++->punct;
    N right{};
    if (!operand(right)) return false;
    if (raw::precedence(*m_at) > here && !rest(right, raw::closer(here))) return false;
    if (!raw::apply(op, left, right)) return false;
  }
}

}  // namespace lentray::parser
