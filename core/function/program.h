// A compiled function: instructions on registers, run by a loop. Constant after construction, so
// any thread may run it; registers live on the caller's stack.
//
// An operand is a register if it is not negative (arguments first, then variables and intermediate
// values), else the constant number -operand-1.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/vec3.h"
#include "core/function/node.h"

namespace lentray::core {

/// What one instruction does: the arithmetic of FunctionOp, and control.
enum class ProgramOp : std::uint8_t {
  kArithmetic,  ///< target = op(a, b)
  kMove,        ///< target = a
  kJump,        ///< to `jump`
  kJumpFalse,   ///< to `jump` if a is 0
  kJumpNotNegative,
  kJumpNotZero,
  kJumpPast,  ///< to `jump` unless a <= b, so with nan too
  kCall,      ///< target = component `a` of callee number `jump` called with registers from b
  // What functions do most: Program makes these of the others.
  kAdd,
  kSubtract,
  kMultiply,
  kAddProduct,       ///< target = a + b * c, rounded twice
  kSubtractProduct,  ///< target = a - b * c, rounded twice
  kNoise,            ///< target = noise, term number `jump`
  kAddNoise,         ///< target = a + b * noise, rounded twice
  kSubtractNoise,    ///< target = a - b * noise, rounded twice
  kEnd,              ///< the result is a
};

struct alignas(16) Instruction {
  ProgramOp kind = ProgramOp::kMove;
  FunctionOp op = FunctionOp::kConstant;
  std::int16_t target = 0, a = 0, b = 0;
  std::uint16_t jump = 0;
  std::int16_t c() const {
    return static_cast<std::int16_t>(jump);
  }  ///< of those with three operands
};

/// Noise at a point whose coordinates are products, as in f_noise3d(x*2, y*2, z*2): number * factor.
struct NoiseTerm {
  const int* generator;  ///< of a callee
  int plane = -1;        ///< the coordinate that is 0 whatever x, y, z are, if there is one
  std::array<std::int16_t, 3> number{}, factor{};  ///< in a plane: of the two others, then 0
};

/// What the compiler makes.
struct ProgramParts {
  std::vector<Instruction> code;
  std::vector<double> constants;
  std::vector<std::shared_ptr<const Function>> callees;
  std::vector<NoiseTerm> noises;
  std::size_t parameters = 0, frame = 0;
  std::int16_t result = 0;
};

class Program final : public Function {
 public:
  static constexpr std::size_t kSmallFrame = 48;
  static constexpr std::size_t kLargestFrame = 2048;
  static constexpr std::size_t kMostConstants = 32000;

  explicit Program(ProgramParts parts);

  std::size_t parameters() const override { return m_parameters; }
  double evaluate(std::span<const double> arguments) const override;
  std::string not_yet() const override;

  /// A register of two points.
  using Lanes = Pair;

  /// For who asks often: memory of a run whose constants lie in place already.
  class Frame {
   public:
    /// False if the program has another number of parameters or does not fit.
    bool prepare(const Program& program);
    double operator()(const Vec3& p) {
      m_arguments[0] = p.x;
      m_arguments[1] = p.y;
      m_arguments[2] = p.z;
      return m_program->execute(m_arguments);
    }

   private:
    const Program* m_program = nullptr;
    double* m_arguments = nullptr;
    std::array<double, kSmallFrame> m_memory;
  };

  /// For who can use the values at several points at once: they are computed side by side, in little
  /// more time than one, which waits for itself. Bits are those of one after the other.
  class WideFrame {
   public:
    /// False if the program has another number of parameters, does not fit, or holds jumps or calls
    /// but of functions that take pairs.
    bool prepare(const Program& program);
    Lanes operator()(Lanes x, Lanes y, Lanes z) {
      m_arguments[0] = x;
      m_arguments[1] = y;
      m_arguments[2] = z;
      return m_program->execute(m_arguments);
    }

   private:
    const Program* m_program = nullptr;
    Lanes* m_arguments = nullptr;
    std::array<Lanes, kSmallFrame> m_memory;
  };

 private:
  /// Of more constants and registers than kSmallFrame; beyond kLargestFrame they are allocated.
  double evaluate_large(std::span<const double> arguments) const;
  double run(double* memory, std::span<const double> arguments) const;
  template <class Number>
  Number execute(Number* frame) const;
  void call(const Instruction& i, double* frame) const;
  void call(const Instruction& i, Lanes* frame) const;
  template <class Number>
  Number noise_of(const Instruction& i, const Number* frame) const;

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
  std::vector<NoiseTerm> m_noises;
  std::size_t m_parameters, m_frame;
  bool m_is_straight = true;  ///< no jumps, no calls but of what takes pairs
};

}  // namespace lentray::core
