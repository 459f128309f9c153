// The operations that functions and expressions are made of. Pure; any thread.
#pragma once

#include <cstdint>
#include <limits>

namespace lentray::core {

enum class FunctionOp : std::uint8_t {
  // Leaves.
  kConstant,   ///< value
  kParameter,  ///< index
  kLocal,      ///< index: the variable of an enclosing sum or prod
  // One operand.
  kNegate,
  kNot,
  // Two operands; comparisons give 1 or 0.
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kLess,
  kLessEqual,
  kEqual,
  kNotEqual,
  kGreaterEqual,
  kGreater,
  kAnd,
  kOr,
// One or two operands.
#define LENTRAY_FLOAT_FUNCTION(name, arity, in_functions, undefined, value) name,
#include "core/function/float_functions.def"
#undef LENTRAY_FLOAT_FUNCTION
  // Others.
  kSelect,  ///< 3 or 4 operands, as select()
  kChoose,  ///< c ? a : b
  kCall,    ///< callee, operands its arguments, index the component of the result
  kSum,
  kProd,  ///< index the variable; operands first, last, expression
};

/// apply() has it.
constexpr bool is_arithmetic(FunctionOp op) {
  return op >= FunctionOp::kNegate && op < FunctionOp::kSelect;
}

/// The arithmetic of one operation; b is ignored by those of one operand. Exact: of expressions'
/// operators, those that allow for rounding are not among them.
double apply(FunctionOp op, double a, double b);

/// To a whole number of 32 bits, towards zero; what does not fit, infinities and
/// nan become the smallest.
inline int to_int(double x) {
  constexpr int kSmallest = std::numeric_limits<int>::min();
  return x > kSmallest - 1.0 && x < 2147483648.0 ? static_cast<int>(x) : kSmallest;
}

}  // namespace lentray::core
