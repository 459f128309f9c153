// A user-defined SDL function, compiled: evaluated without allocation, by any thread.
// Source: reference manual 3.7, "Function" and "Float Expressions"; angles in radians.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/base/pair_math.h"

namespace lentray::core {

class Function {
 public:
  virtual ~Function() = default;
  /// Number of parameters; `function { x + y }` has three: x, y, z.
  virtual std::size_t parameters() const = 0;
  /// Arguments in order; exactly parameters() of them.
  virtual double evaluate(std::span<const double> arguments) const = 0;
  /// Whether two points take little more time than one. Then evaluate_pair() gives both, to the bit.
  virtual bool takes_pairs() const { return false; }
  virtual Pair evaluate_pair(std::span<const Pair>) const { return Pair{}; }
  /// Names what makes it impossible to evaluate yet (an internal f_* function, say); empty if it can be.
  virtual std::string not_yet() const { return {}; }

  /// Components of the result: 1, or 2 to 5 for a function of a transform, spline or pigment.
  virtual std::size_t results() const { return 1; }
  /// All of them; `result` has at least results() elements. evaluate() gives the first.
  virtual void evaluate_all(std::span<const double> arguments, std::span<double> result) const {
    result[0] = evaluate(arguments);
  }
};

/// Most parameters a function has, and most components a result.
inline constexpr std::size_t kMostParameters = 56;
inline constexpr std::size_t kMostResults = 5;

}  // namespace lentray::core
