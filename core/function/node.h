// The expression of a user-defined function as a tree, before it is compiled. Owned by whoever
// builds it; one thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/function/function.h"

namespace lentray::core {

enum class FunctionOp : std::uint8_t {
  // Leaves.
  kConstant,   ///< value
  kParameter,  ///< index
  kLocal,      ///< index: the variable of an enclosing sum or prod
  // One operand.
  kNegate, kNot, kAbs, kAcos, kAcosh, kAsin, kAsinh, kAtan, kAtanh, kCeil, kCos, kCosh, kDegrees,
  kExp, kFloor, kInt, kLn, kLog, kRadians, kSin, kSinh, kSqr, kSqrt, kTan, kTanh,
  // Two operands; comparisons give 1 or 0.
  kAdd, kSubtract, kMultiply, kDivide, kLess, kLessEqual, kEqual, kNotEqual, kGreaterEqual,
  kGreater, kAnd, kOr, kAtan2, kMod, kPow, kMax, kMin,
  // Others.
  kSelect,     ///< 3 or 4 operands, as select()
  kChoose,     ///< c ? a : b
  kCall,       ///< callee, operands its arguments, index the component of the result
  kSum, kProd, ///< index the variable; operands first, last, expression
};

struct FunctionNode {
  FunctionOp op = FunctionOp::kConstant;
  double value = 0.0;
  std::size_t index = 0;
  std::vector<std::unique_ptr<FunctionNode>> operands;
  std::shared_ptr<const Function> callee;
};

using FunctionNodePtr = std::unique_ptr<FunctionNode>;

FunctionNodePtr constant_node(double value);
FunctionNodePtr make_node(FunctionOp op, FunctionNodePtr a, FunctionNodePtr b = nullptr,
                          FunctionNodePtr c = nullptr);

/// Compiles a tree for `parameters` parameters and `locals` variables of sums, which end after `most_terms`. Throws
/// std::length_error if it needs more intermediate values than a program may have.
std::shared_ptr<const Function> compile_function(const FunctionNode& root, std::size_t parameters,
                                                 std::size_t locals, double most_terms);

}  // namespace lentray::core
