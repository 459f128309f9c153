#include "core/function/internal.h"

#include <algorithm>
#include <utility>

#include "core/function/internal_formulas.h"
#include "core/function/noise_function.h"

namespace lentray::core {
namespace {

/// Null where there is none.
const InternalFormula* formula_of(int number) {
  for (const auto table :
       {algebraic_formulas(), curve_formulas(), solid_formulas(), noise_formulas()}) {
    const auto found = std::ranges::find(table, number, &InternalFormula::number);
    if (found != table.end()) return &*found;
  }
  return nullptr;
}

class Internal final : public Function {
 public:
  explicit Internal(const InternalFormula& formula) : m_formula(formula) {}
  std::size_t parameters() const override { return static_cast<std::size_t>(m_formula.extra) + 3; }
  double evaluate(std::span<const double> arguments) const override {
    return m_formula.evaluate(arguments.data());
  }
  bool takes_pairs() const override { return m_formula.evaluate_pair != nullptr; }
  Pair evaluate_pair(std::span<const Pair> arguments) const override {
    return m_formula.evaluate_pair(arguments.data());
  }

 private:
  const InternalFormula& m_formula;
};

}  // namespace

std::shared_ptr<const Function> internal_function(int number,
                                                  std::shared_ptr<const int> noise_generator) {
  const InternalFormula* formula = formula_of(number);
  if (!formula) return nullptr;
  if (noise_generator && formula->name == "f_noise3d") {
    return std::make_shared<NoiseFunction>(std::move(noise_generator));
  }
  return std::make_shared<Internal>(*formula);
}

}  // namespace lentray::core
