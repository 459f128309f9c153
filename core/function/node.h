// The expression of a user-defined function as a tree, before it is compiled. Owned by whoever
// builds it; one thread.
#pragma once

#include <memory>
#include <vector>

#include "core/function/function.h"
#include "core/function/operation.h"

namespace lentray::core {

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
