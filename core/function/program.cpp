#include "core/function/program.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <type_traits>

#include "core/noise/noise.h"

namespace lentray::core {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

double apply(FunctionOp op, double a, double b) {
  switch (op) {
    case FunctionOp::kAdd: return a + b;
    case FunctionOp::kSubtract: return a - b;
    case FunctionOp::kMultiply: return a * b;
    case FunctionOp::kDivide: return a / b;
    case FunctionOp::kNegate: return -a;
    case FunctionOp::kNot: return a == 0.0;
    case FunctionOp::kLess: return a < b;
    case FunctionOp::kLessEqual: return a <= b;
    case FunctionOp::kEqual: return a == b;
    case FunctionOp::kNotEqual: return a != b;
    case FunctionOp::kGreaterEqual: return a >= b;
    case FunctionOp::kGreater: return a > b;
    case FunctionOp::kAnd: return a != 0.0 && b != 0.0;
    case FunctionOp::kOr: return a != 0.0 || b != 0.0;
#define LENTRAY_FLOAT_FUNCTION(name, arity, in_functions, undefined, value) \
  case FunctionOp::name:                                                    \
    return value;
#include "core/function/float_functions.def"
#undef LENTRAY_FLOAT_FUNCTION
    default: return 0.0;
  }
}

namespace {

Pair apply(FunctionOp op, Pair a, Pair b) {
  const double first = apply(op, a[0], b[0]);
  return Pair{first, apply(op, a[1], b[1])};
}

}  // namespace

Program::Program(ProgramParts parts)
    : m_code(std::move(parts.code)), m_constants(std::move(parts.constants)),
      m_callees(std::move(parts.callees)), m_noises(std::move(parts.noises)),
      m_parameters(parts.parameters), m_frame(parts.frame) {
  for (const auto& callee : m_callees) {
    m_calls.push_back({callee.get(), callee->parameters(), callee->results() == 1});
  }
  std::reverse(m_constants.begin(), m_constants.end());
  m_code.push_back({ProgramOp::kEnd, FunctionOp::kConstant, 0, parts.result, 0, 0});
  for (Instruction& i : m_code) {
    if (i.kind >= ProgramOp::kJump && i.kind < ProgramOp::kCall) m_is_straight = false;
    if (i.kind == ProgramOp::kCall && !m_callees[i.jump]->takes_pairs()) m_is_straight = false;
    if (i.kind != ProgramOp::kArithmetic) continue;
    if (i.op == FunctionOp::kAdd) i.kind = ProgramOp::kAdd;
    if (i.op == FunctionOp::kSubtract) i.kind = ProgramOp::kSubtract;
    if (i.op == FunctionOp::kMultiply) i.kind = ProgramOp::kMultiply;
  }
}

double Program::evaluate(std::span<const double> arguments) const {
  if (m_constants.size() + m_frame > kSmallFrame) return evaluate_large(arguments);
  // Not initialised: a program writes every register before it reads it.
  std::array<double, kSmallFrame> memory;
  return run(memory.data(), arguments);
}

// A frame of its own: functions that call functions would take the largest one's at each level.
[[gnu::noinline]] double Program::evaluate_large(std::span<const double> arguments) const {
  if (m_constants.size() + m_frame > kLargestFrame) {
    const auto memory = std::make_unique_for_overwrite<double[]>(m_constants.size() + m_frame);
    return run(memory.get(), arguments);
  }
  std::array<double, kLargestFrame> memory;
  return run(memory.data(), arguments);
}

double Program::run(double* memory, std::span<const double> arguments) const {
  std::copy(m_constants.begin(), m_constants.end(), memory);
  double* const frame = memory + m_constants.size();
  std::copy_n(arguments.data(), m_parameters, frame);
  return execute(frame);
}

bool Program::Frame::prepare(const Program& program) {
  const std::size_t constants = program.m_constants.size();
  if (program.m_parameters != 3 || constants + program.m_frame > kSmallFrame) return false;
  m_program = &program;
  m_arguments = m_memory.data() + constants;
  std::copy(program.m_constants.begin(), program.m_constants.end(), m_memory.begin());
  return true;
}

template <class Number>
[[gnu::always_inline]] inline Number Program::noise_of(const Instruction& i,
                                                       const Number* frame) const {
  const NoiseTerm& term = m_noises[i.jump];
  const auto at = [&](std::size_t k) -> Number {
    return frame[term.number[k]] * frame[term.factor[k]];
  };
  if (term.plane >= 0) return noise_in_plane(term.plane, at(0), at(1), *term.generator);
  return noise(at(0), at(1), at(2), *term.generator);
}

bool Program::WideFrame::prepare(const Program& program) {
  const std::size_t constants = program.m_constants.size();
  if (!program.m_is_straight || program.m_parameters != 3 ||
      constants + program.m_frame > kSmallFrame)
    return false;
  m_program = &program;
  m_arguments = m_memory.data() + constants;
  for (std::size_t i = 0; i < constants; ++i)
    m_memory[i] = Lanes{program.m_constants[i], program.m_constants[i]};
  for (std::size_t i = 0; i < 3; ++i) m_arguments[i] = Lanes{};
  return true;
}

void Program::call(const Instruction& i, double* frame) const {
  const Callee& callee = m_calls[i.jump];
  const std::span<const double> given(frame + i.b, callee.parameters);
  if (callee.has_one_result) {
    frame[i.target] = callee.function->evaluate(given);
    return;
  }
  std::array<double, kMostResults> result{};
  callee.function->evaluate_all(given, result);
  frame[i.target] = result[static_cast<std::size_t>(i.a)];
}

void Program::call(const Instruction& i, Lanes* frame) const {
  const Callee& callee = m_calls[i.jump];
  frame[i.target] = callee.function->evaluate_pair({frame + i.b, callee.parameters});
}

template <class Number>
Number Program::execute(Number* frame) const {
  const auto value = [frame](std::int16_t i) -> const Number& { return frame[i]; };
  // Of pairs nothing is asked: where they are registers, no program jumps.
  const auto asked = [frame](std::int16_t i) -> double {
    if constexpr (std::is_same_v<Number, double>)
      return frame[i];
    else
      return frame[i][0];
  };
  const Instruction* const code = m_code.data();
  for (const Instruction* next = code;;) {
    const Instruction& i = *next++;
    switch (i.kind) {
      case ProgramOp::kAdd: frame[i.target] = value(i.a) + value(i.b); break;
      case ProgramOp::kSubtract: frame[i.target] = value(i.a) - value(i.b); break;
      case ProgramOp::kMultiply: frame[i.target] = value(i.a) * value(i.b); break;
      case ProgramOp::kArithmetic: frame[i.target] = apply(i.op, value(i.a), value(i.b)); break;
      case ProgramOp::kAddProduct: frame[i.target] = value(i.a) + value(i.b) * value(i.c()); break;
      case ProgramOp::kSubtractProduct:
        frame[i.target] = value(i.a) - value(i.b) * value(i.c());
        break;
      case ProgramOp::kMove: frame[i.target] = value(i.a); break;
      case ProgramOp::kJump: next = code + i.jump; break;
      case ProgramOp::kJumpFalse:
        if (asked(i.a) == 0.0) next = code + i.jump;
        break;
      case ProgramOp::kJumpNotNegative:
        if (!(asked(i.a) < 0.0)) next = code + i.jump;
        break;
      case ProgramOp::kJumpNotZero:
        if (asked(i.a) != 0.0) next = code + i.jump;
        break;
      case ProgramOp::kJumpPast:
        if (!(asked(i.a) <= asked(i.b))) next = code + i.jump;
        break;
      case ProgramOp::kCall: call(i, frame); break;
      case ProgramOp::kNoise: frame[i.target] = noise_of(i, frame); break;
      case ProgramOp::kAddNoise:
        frame[i.target] = value(i.a) + value(i.b) * noise_of(i, frame);
        break;
      case ProgramOp::kSubtractNoise:
        frame[i.target] = value(i.a) - value(i.b) * noise_of(i, frame);
        break;
      case ProgramOp::kEnd: return value(i.a);
      default: __builtin_unreachable();
    }
  }
}

template double Program::execute(double* frame) const;
template Program::Lanes Program::execute(Lanes* frame) const;

std::string Program::not_yet() const {
  std::string all;
  for (const auto& callee : m_callees) {
    const std::string one = callee->not_yet();
    if (!one.empty() && all.find(one) == std::string::npos) all += (all.empty() ? "" : ", ") + one;
  }
  return all;
}

}  // namespace lentray::core
