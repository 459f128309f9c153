// A compiled function: instructions on registers, run by a loop. Constant after construction, so
// any thread may run it; registers live on the caller's stack.
//
// An operand is a register if it is not negative (arguments first, then variables and intermediate
// values), else the constant number -operand-1.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/function/node.h"

namespace lentray::core {

/// What one instruction does: the arithmetic of FunctionOp, and control.
enum class ProgramOp : std::uint8_t {
  kArithmetic,   ///< target = op(a, b)
  kMove,         ///< target = a
  kJump,         ///< to `jump`
  kJumpFalse,    ///< to `jump` if a is 0
  kJumpNotNegative,
  kJumpNotZero,
  kJumpPast,     ///< to `jump` unless a <= b, so with nan too
  kCall,         ///< target = component `a` of callee number `jump` called with registers from b
  kAdd,          ///< what functions do most: Program makes these of kArithmetic
  kSubtract,
  kMultiply,
};

struct Instruction {
  ProgramOp kind = ProgramOp::kMove;
  FunctionOp op = FunctionOp::kConstant;
  std::int16_t target = 0, a = 0, b = 0;
  std::uint16_t jump = 0;
};

class Program final : public Function {
 public:
  static constexpr std::size_t kSmallFrame = 48;
  static constexpr std::size_t kLargestFrame = 2048;
  static constexpr std::size_t kMostConstants = 32000;

  Program(std::vector<Instruction> code, std::vector<double> constants,
          std::vector<std::shared_ptr<const Function>> callees, std::size_t parameters,
          std::size_t frame, std::int16_t result);

  std::size_t parameters() const override { return m_parameters; }
  double evaluate(std::span<const double> arguments) const override;
  std::string not_yet() const override;

 private:
  /// Of more constants and registers than kSmallFrame; beyond kLargestFrame they are allocated.
  double evaluate_large(std::span<const double> arguments) const;
  double run(double* memory, std::span<const double> arguments) const;

  std::vector<Instruction> m_code;
  std::vector<double> m_constants;  ///< last first: they lie before the registers
  std::vector<std::shared_ptr<const Function>> m_callees;
  /// The same, with what a call needs to know.
  struct Callee {
    const Function* function;
    std::size_t parameters;
    bool has_one_result;
  };
  std::vector<Callee> m_calls;
  std::size_t m_parameters, m_frame;
  std::int16_t m_result;
};

/// The arithmetic of one operation; b is ignored by those of one operand.
double apply(FunctionOp op, double a, double b);

}  // namespace lentray::core
