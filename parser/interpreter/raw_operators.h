// The operators of RawExpressions: one loop for floats and for vectors. Private to its sources.
#pragma once

#include "parser/interpreter/raw_expressions.h"
#include "parser/values/operators.h"

namespace lentray::parser {

// An operand and the operators behind it, those that bind at least so closely.
template <typename N>
bool RawExpressions::binary(N& left, Precedence least) {
  return operand(left) && (precedence(*m_at) < least || rest(left, least));
}

template <typename N>
bool RawExpressions::rest(N& left, Precedence least) {
  for (;;) {
    const Precedence here = precedence(*m_at);
    if (here < least) return true;
    const Punct op = m_at++->punct;
    N right{};
    if (!operand(right)) return false;
    if (precedence(*m_at) > here && !rest(right, closer(here))) return false;
    if (!operate(op, left, right)) return false;
  }
}

}  // namespace lentray::parser
