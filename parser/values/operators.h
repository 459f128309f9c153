// The binary operators of SDL: how closely they bind, and what they do to floats and vectors. Each
// is a row of operators.def. Pure; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "core/function/operation.h"
#include "parser/tokens/token.h"
#include "parser/values/arithmetic.h"
#include "parser/values/value.h"

namespace lentray::parser {

/// What binds closest comes last. Expressions have no kAnd: & and | bind alike there.
enum class Precedence : std::uint8_t { kNone, kLogical, kAnd, kComparison, kSum, kProduct };

inline Precedence closer(Precedence p) { return static_cast<Precedence>(static_cast<int>(p) + 1); }

/// An operator as user-defined functions have it.
struct FunctionOperator {
  Precedence precedence = Precedence::kNone;
  core::FunctionOp op = core::FunctionOp::kConstant;
};

struct Operators {
  std::array<Precedence, 256> precedence{};  ///< in expressions; kNone of what is no operator
  std::array<FunctionOperator, 256> in_functions{};

  constexpr Operators() {
#define LENTRAY_OPERATOR(symbol, binds, binds_in_functions, op, undefined, value)          \
  precedence[static_cast<std::size_t>(Punct::symbol)] = Precedence::binds;                 \
  in_functions[static_cast<std::size_t>(Punct::symbol)] = {Precedence::binds_in_functions, \
                                                           core::FunctionOp::op};
#include "parser/values/operators.def"
#undef LENTRAY_OPERATOR
  }
};
inline constexpr Operators kOperators;

inline Precedence precedence(const Token& token) {
  return token.kind == TokenKind::kPunct
             ? kOperators.precedence[static_cast<std::size_t>(token.punct)]
             : Precedence::kNone;
}
inline FunctionOperator function_operator(const Token& token) {
  return token.kind == TokenKind::kPunct
             ? kOperators.in_functions[static_cast<std::size_t>(token.punct)]
             : FunctionOperator{};
}

/// left = left op right. False if it is not defined: something has to be said then.
inline bool operate(Punct op, double& left, double right) {
  const double a = left, b = right;
  switch (op) {
#define LENTRAY_OPERATOR(symbol, binds, binds_in_functions, op, undefined, value) \
  case Punct::symbol:                                                             \
    left = value;                                                                 \
    return !(undefined);
#include "parser/values/operators.def"
#undef LENTRAY_OPERATOR
    default: return true;
  }
}

/// The same for each component.
template <typename Op>
void each(Number& left, Number& right, Op op) {
  promote(right, left.size);
  promote(left, right.size);
  left.keeps_rest = false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(left.size); ++i) {
    left.v[i] = op(left.v[i], right.v[i]);
  }
}

/// `right` grows to as many components as `left` has.
inline bool operate(Punct op, Number& left, Number& right) {
  if (left.size == 1 && right.size == 1) return operate(op, left.v[0], right.v[0]);
  if (kOperators.precedence[static_cast<std::size_t>(op)] >= Precedence::kSum)
    left.is_colour = false;
  bool defined = true;
  switch (op) {
#define LENTRAY_OPERATOR(symbol, binds, binds_in_functions, op, undefined, value) \
  case Punct::symbol:                                                             \
    each(left, right, [&defined](double a, double b) -> double {                  \
      if (undefined) defined = false;                                             \
      return value;                                                               \
    });                                                                           \
    return defined;
#include "parser/values/operators.def"
#undef LENTRAY_OPERATOR
    default: return true;
  }
}

}  // namespace lentray::parser
