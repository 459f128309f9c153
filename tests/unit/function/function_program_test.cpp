// Compiled functions against their trees: instructions that join two operations, and several points
// at once, give the bits of one operation after the other.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <random>

#include "core/function/internal.h"
#include "core/function/noise_function.h"
#include "core/function/program.h"
#include "core/object/leaf.h"

using namespace lentray::core;

namespace {

using Op = FunctionOp;
using Point = std::array<double, 3>;

double value_of(const FunctionNode& node, const Point& p) {
  const auto of = [&](std::size_t i) { return value_of(*node.operands[i], p); };
  switch (node.op) {
    case Op::kConstant: return node.value;
    case Op::kParameter: return p[node.index];
    case Op::kChoose: return of(0) != 0.0 ? of(1) : of(2);
    case Op::kCall: return node.callee->evaluate(Point{of(0), of(1), of(2)});
    default: return apply(node.op, of(0), node.operands.size() > 1 ? of(1) : 0.0);
  }
}

class Trees {
 public:
  explicit Trees(bool jumps) : m_jumps(jumps) {}

  FunctionNodePtr tree(int depth) {
    const int kind = depth == 0 ? pick(2) : pick(12);
    if (kind == 0) return constant();
    if (kind == 1) {
      auto leaf = std::make_unique<FunctionNode>();
      leaf->op = Op::kParameter;
      leaf->index = static_cast<std::size_t>(pick(3));
      return leaf;
    }
    if (kind == 2 && m_jumps)
      return make_node(Op::kChoose, less(depth), tree(depth - 1), tree(depth - 1));
    if (kind == 3) {
      auto call = make_node(Op::kCall, tree(depth - 1), tree(depth - 1), tree(depth - 1));
      call->callee =
          std::make_shared<const NoiseFunction>(std::make_shared<const int>(1 + pick(3)));
      return call;
    }
    static constexpr std::array kOps{Op::kAdd,      Op::kSubtract, Op::kMultiply,
                                     Op::kMultiply, Op::kMax,      Op::kLess};
    return make_node(kOps[static_cast<std::size_t>(pick(kOps.size()))], tree(depth - 1),
                     tree(depth - 1));
  }
  Point point() {
    std::uniform_real_distribution<double> at(-3.0, 3.0);
    return {at(m_random), at(m_random), at(m_random)};
  }

 private:
  FunctionNodePtr constant() {
    const int kind = pick(6);
    if (kind == 0) return constant_node(0.0);
    if (kind == 1) return constant_node(-0.0);
    return constant_node(std::uniform_real_distribution<double>(-2.0, 2.0)(m_random));
  }
  FunctionNodePtr less(int depth) { return make_node(Op::kLess, tree(depth - 1), tree(depth - 1)); }
  int pick(std::size_t count) { return static_cast<int>(m_random() % count); }

  bool m_jumps;
  std::mt19937 m_random{7};
};

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

TEST(UnitCoreFunctionProgram, IsItsTree) {
  Trees trees(true);
  for (int i = 0; i < 3000; ++i) {
    const FunctionNodePtr tree = trees.tree(5);
    const auto function = compile_function(*tree, 3, 0, 1e6);
    for (int k = 0; k < 4; ++k) {
      const Point p = trees.point();
      ASSERT_EQ(bits(function->evaluate(p)), bits(value_of(*tree, p))) << "tree " << i;
    }
  }
}

TEST(UnitCoreFunctionProgram, TwoPointsAtOnceAreEachAlone) {
  Trees trees(false);
  int wide = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto function = compile_function(*trees.tree(4), 3, 0, 1e6);
    Program::WideFrame frame;
    if (!frame.prepare(dynamic_cast<const Program&>(*function))) continue;
    ++wide;
    const Point a = trees.point(), b = trees.point();
    const auto values =
        frame(Program::Lanes{a[0], b[0]}, Program::Lanes{a[1], b[1]}, Program::Lanes{a[2], b[2]});
    ASSERT_EQ(bits(values[0]), bits(function->evaluate(a))) << "tree " << i;
    ASSERT_EQ(bits(values[1]), bits(function->evaluate(b))) << "tree " << i;
  }
  EXPECT_GT(wide, 2000);
}

// Formulas of noise: where the parameters of both points are the same, and where one differs.
TEST(UnitCoreFunctionProgram, FormulasOfTwoPointsAreEachAlone) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-20.0, 20.0), share(0.1, 2.0);
  int paired = 0;
  for (int number = 0; const auto function = internal_function(number); ++number) {
    if (!function->takes_pairs()) continue;
    ++paired;
    for (int i = 0; i < 300; ++i) {
      std::array<double, 9> one{}, other{};
      std::array<Pair, 9> both{};
      for (std::size_t k = 0; k < 9; ++k) {
        one[k] = k < 3    ? place(random)
                 : k == 8 ? i % 4
                 : k == 5 ? 1.0 + i % 5 + 0.25 * (i % 2)
                          : share(random);
        other[k] = k < 3 ? place(random) : one[k];
        if (i % 10 == 0 && k == static_cast<std::size_t>(3 + i / 10 % 6)) other[k] += 1.0;
        both[k] = Pair{one[k], other[k]};
      }
      const Pair value = function->evaluate_pair({both.data(), function->parameters()});
      EXPECT_EQ(
          std::bit_cast<std::uint64_t>(value[0]),
          std::bit_cast<std::uint64_t>(function->evaluate({one.data(), function->parameters()})));
      EXPECT_EQ(
          std::bit_cast<std::uint64_t>(value[1]),
          std::bit_cast<std::uint64_t>(function->evaluate({other.data(), function->parameters()})));
    }
  }
  EXPECT_EQ(paired, 5);
}

}  // namespace
