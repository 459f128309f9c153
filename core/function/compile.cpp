// From the tree of a function to its program. Registers of intermediate values are used as a stack:
// what an operand needed is free again once the operation is done.
#include <algorithm>
#include <stdexcept>

#include "core/function/noise_function.h"
#include "core/function/program.h"

namespace lentray::core {
namespace {

constexpr double kFarthest = 9e15;  // beyond, steps of one do not move a number

class Compiler {
 public:
  Compiler(std::size_t parameters, std::size_t locals, double most_terms)
      : m_parameters(parameters), m_most_terms(most_terms), m_first_between(parameters + locals),
        m_next(m_first_between), m_used(m_next) {}

  std::shared_ptr<const Function> run(const FunctionNode& root) {
    const std::int16_t result = operand(root);
    return std::make_shared<Program>(ProgramParts{std::move(m_code), std::move(m_constants),
                                                  std::move(m_callees), std::move(m_noises),
                                                  m_parameters, m_used, result});
  }

 private:
  std::int16_t allocate() {
    const std::size_t r = m_next++;
    m_used = std::max(m_used, m_next);
    if (m_used > Program::kLargestFrame) throw std::length_error("function too complex");
    return static_cast<std::int16_t>(r);
  }

  std::int16_t constant(double value) {
    // Compared as bits would be: 0 and -0 stay apart.
    for (std::size_t i = 0; i < m_constants.size(); ++i) {
      if (m_constants[i] == value && 1.0 / m_constants[i] == 1.0 / value) {
        return static_cast<std::int16_t>(-static_cast<int>(i) - 1);
      }
    }
    if (m_constants.size() >= Program::kMostConstants)
      throw std::length_error("function too complex");
    m_constants.push_back(value);
    return static_cast<std::int16_t>(-static_cast<int>(m_constants.size()));
  }

  std::size_t emit(ProgramOp kind, std::int16_t target, std::int16_t a, std::int16_t b = 0,
                   FunctionOp op = FunctionOp::kConstant) {
    if (m_code.size() >= 65000) throw std::length_error("function too complex");
    m_code.push_back({kind, op, target, a, b, 0});
    return m_code.size() - 1;
  }

  void land(std::size_t jump) {
    m_code[jump].jump = static_cast<std::uint16_t>(m_code.size());
    m_landed = m_code.size();
  }

  // Where the value of a node can be read: its own place if it is a leaf, else a new register.
  std::int16_t operand(const FunctionNode& node) {
    switch (node.op) {
      case FunctionOp::kConstant: return constant(node.value);
      case FunctionOp::kParameter: return static_cast<std::int16_t>(node.index);
      case FunctionOp::kLocal: return local(node.index);
      default: {
        double value = 0.0;
        if (fold(node, value)) return constant(value);
        const std::int16_t target = allocate();
        into(node, target);
        return target;
      }
    }
  }

  std::int16_t local(std::size_t index) const {
    return static_cast<std::int16_t>(m_parameters + index);
  }

  /// What a node's arithmetic begins with, and the operations upon it, the last one first. A sum of
  /// thousands of terms is as deep to the left: nothing calls itself for that.
  struct Chain {
    const FunctionNode* first;
    std::vector<const FunctionNode*> operations;

    explicit Chain(const FunctionNode& node) : first(&node) {
      for (; is_arithmetic(first->op); first = first->operands[0].get())
        operations.push_back(first);
    }
    /// Takes off what can be computed now; true if `value` is then what the rest begins with.
    bool fold(double& value) {
      if (first->op != FunctionOp::kConstant) return false;
      value = first->value;
      for (; !operations.empty(); operations.pop_back()) {
        const FunctionNode& node = *operations.back();
        double right = 0.0;
        if (node.operands.size() > 1 && !Compiler::fold(*node.operands[1], right)) break;
        value = apply(node.op, value, right);
      }
      return true;
    }
  };

  static bool fold(const FunctionNode& node, double& value) {
    Chain chain(node);
    return chain.fold(value) && chain.operations.empty();
  }

  void arithmetic(const FunctionNode& node, std::int16_t target) {
    Chain chain(node);
    double value = 0.0;
    std::int16_t a = chain.fold(value) ? constant(value) : operand(*chain.first);
    if (chain.operations.empty()) emit(ProgramOp::kMove, target, a);
    const std::int16_t between = chain.operations.size() > 1 ? allocate() : target;
    const std::size_t mark = m_next;
    for (; !chain.operations.empty(); chain.operations.pop_back()) {
      const FunctionNode& step = *chain.operations.back();
      const std::int16_t b = step.operands.size() > 1 ? operand(*step.operands[1]) : a;
      const std::int16_t result = chain.operations.size() > 1 ? between : target;
      if (!emit_with_product(step.op, result, a, b))
        emit(ProgramOp::kArithmetic, result, a, b, step.op);
      a = result;
      m_next = mark;
    }
  }

  /// A sum or difference whose right side is the product that was computed last: both at once.
  bool emit_with_product(FunctionOp op, std::int16_t target, std::int16_t a, std::int16_t b) {
    if (op != FunctionOp::kAdd && op != FunctionOp::kSubtract) return false;
    // Registers above the variables are read once. Jumps may lead to what comes next.
    if (b < static_cast<std::int16_t>(m_first_between) || m_code.empty() ||
        m_landed == m_code.size())
      return false;
    const Instruction product = m_code.back();
    if (product.kind != ProgramOp::kArithmetic || product.op != FunctionOp::kMultiply ||
        product.target != b) {
      return false;
    }
    m_code.pop_back();
    if (emit_with_noise(op, target, a, product)) return true;
    emit(op == FunctionOp::kAdd ? ProgramOp::kAddProduct : ProgramOp::kSubtractProduct, target, a,
         product.a);
    m_code.back().jump = static_cast<std::uint16_t>(product.b);
    return true;
  }

  /// The same, where a side of the product is the noise that was computed last.
  bool emit_with_noise(FunctionOp op, std::int16_t target, std::int16_t a,
                       const Instruction& product) {
    if (m_code.empty() || m_landed >= m_code.size() || product.a == product.b) return false;
    const Instruction noise = m_code.back();
    const std::int16_t at = noise.target;
    if (noise.kind != ProgramOp::kNoise || at < static_cast<std::int16_t>(m_first_between))
      return false;
    if (product.a != at && product.b != at) return false;
    m_code.pop_back();
    emit(op == FunctionOp::kAdd ? ProgramOp::kAddNoise : ProgramOp::kSubtractNoise, target, a,
         product.a == at ? product.b : product.a);
    m_code.back().jump = noise.jump;
    return true;
  }

  void into(const FunctionNode& node, std::int16_t target) {
    const std::size_t mark = m_next;
    if (is_arithmetic(node.op)) {
      arithmetic(node, target);
    } else if (node.op == FunctionOp::kSelect) {
      select(node, target);
    } else if (node.op == FunctionOp::kChoose) {
      const std::size_t no = emit(ProgramOp::kJumpFalse, 0, operand(*node.operands[0]));
      into(*node.operands[1], target);
      const std::size_t end = emit(ProgramOp::kJump, 0, 0);
      land(no);
      into(*node.operands[2], target);
      land(end);
    } else if (node.op == FunctionOp::kCall) {
      call(node, target);
    } else if (node.op == FunctionOp::kSum || node.op == FunctionOp::kProd) {
      series(node, target);
    } else {
      emit(ProgramOp::kMove, target, operand(node));
    }
    m_next = mark;
  }

  void select(const FunctionNode& node, std::int16_t target) {
    const std::int16_t x = operand(*node.operands[0]);
    const bool three = node.operands.size() > 3;
    std::vector<std::size_t> ends;
    const std::size_t not_negative = emit(ProgramOp::kJumpNotNegative, 0, x);
    into(*node.operands[1], target);
    ends.push_back(emit(ProgramOp::kJump, 0, 0));
    land(not_negative);
    if (three) {
      const std::size_t not_zero = emit(ProgramOp::kJumpNotZero, 0, x);
      into(*node.operands[2], target);
      ends.push_back(emit(ProgramOp::kJump, 0, 0));
      land(not_zero);
    }
    into(*node.operands[three ? 3 : 2], target);
    for (const std::size_t end : ends) land(end);
  }

  void call(const FunctionNode& node, std::int16_t target) {
    if (const auto* noise = dynamic_cast<const NoiseFunction*>(node.callee.get())) {
      call_noise(node, *noise, target);
      return;
    }
    const std::size_t first = m_next;
    for (std::size_t i = 0; i < node.operands.size(); ++i) allocate();
    for (std::size_t i = 0; i < node.operands.size(); ++i) {
      into(*node.operands[i], static_cast<std::int16_t>(first + i));
    }
    const std::size_t at = emit(ProgramOp::kCall, target, static_cast<std::int16_t>(node.index),
                                static_cast<std::int16_t>(first));
    m_callees.push_back(node.callee);
    m_code[at].jump = static_cast<std::uint16_t>(m_callees.size() - 1);
  }

  void call_noise(const FunctionNode& node, const NoiseFunction& noise, std::int16_t target) {
    NoiseTerm term{&noise.generator()};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const FunctionNode& coordinate = *node.operands[i];
      double value = 0.0;
      const bool is_known = fold(coordinate, value);
      if (is_known && value == 0.0 && term.plane < 0) {
        term.plane = static_cast<int>(i);
        continue;
      }
      const bool is_product = !is_known && coordinate.op == FunctionOp::kMultiply;
      term.number[count] = operand(is_product ? *coordinate.operands[0] : coordinate);
      term.factor[count++] = is_product ? operand(*coordinate.operands[1]) : constant(1.0);
    }
    m_callees.push_back(node.callee);
    m_noises.push_back(term);
    emit(ProgramOp::kNoise, target, 0);
    m_code.back().jump = static_cast<std::uint16_t>(m_noises.size() - 1);
  }

  // From the first to the last value in steps of one, as long as it is not beyond the last. Never
  // more than m_most_terms, and only where steps of one move on: else it would not end.
  void series(const FunctionNode& node, std::int16_t target) {
    const bool sum = node.op == FunctionOp::kSum;
    const std::int16_t variable = local(node.index);
    into(*node.operands[0], variable);
    const std::int16_t last = allocate();
    emit(ProgramOp::kArithmetic, variable, variable, constant(-kFarthest), FunctionOp::kMax);
    into(*node.operands[1], last);
    emit(ProgramOp::kArithmetic, last, last, constant(kFarthest), FunctionOp::kMin);
    const std::int16_t limit = allocate();
    emit(ProgramOp::kArithmetic, limit, variable, constant(m_most_terms), FunctionOp::kAdd);
    emit(ProgramOp::kArithmetic, last, last, limit, FunctionOp::kMin);
    const std::int16_t total = allocate();
    emit(ProgramOp::kMove, total, constant(sum ? 0.0 : 1.0));
    const std::size_t loop = m_landed = m_code.size();
    const std::size_t end = emit(ProgramOp::kJumpPast, 0, variable, last);
    const std::int16_t term = operand(*node.operands[2]);
    emit(ProgramOp::kArithmetic, total, total, term,
         sum ? FunctionOp::kAdd : FunctionOp::kMultiply);
    emit(ProgramOp::kArithmetic, variable, variable, constant(1.0), FunctionOp::kAdd);
    const std::size_t back = emit(ProgramOp::kJump, 0, 0);
    m_code[back].jump = static_cast<std::uint16_t>(loop);
    land(end);
    emit(ProgramOp::kMove, target, total);
  }

  const std::size_t m_parameters;
  const double m_most_terms;
  const std::size_t m_first_between;
  std::size_t m_next, m_used;
  std::size_t m_landed = 0;  ///< where jumps led last
  std::vector<Instruction> m_code;
  std::vector<double> m_constants;
  std::vector<std::shared_ptr<const Function>> m_callees;
  std::vector<NoiseTerm> m_noises;
};

}  // namespace

FunctionNodePtr constant_node(double value) {
  auto node = std::make_unique<FunctionNode>();
  node->value = value;
  return node;
}

FunctionNodePtr make_node(FunctionOp op, FunctionNodePtr a, FunctionNodePtr b, FunctionNodePtr c) {
  auto node = std::make_unique<FunctionNode>();
  node->op = op;
  for (FunctionNodePtr* operand : {&a, &b, &c}) {
    if (*operand) node->operands.push_back(std::move(*operand));
  }
  return node;
}

std::shared_ptr<const Function> compile_function(const FunctionNode& root, std::size_t parameters,
                                                 std::size_t locals, double most_terms) {
  return Compiler(parameters, locals, most_terms).run(root);
}

}  // namespace lentray::core
