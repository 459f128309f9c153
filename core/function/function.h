// A user-defined SDL function, compiled: evaluated without allocation, by any thread.
// Source: reference manual 3.7, "Function" and "Float Expressions"; angles in radians.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace lentray::core {

class Function {
 public:
  virtual ~Function() = default;
  /// Number of parameters; `function { x + y }` has three: x, y, z.
  virtual std::size_t parameters() const = 0;
  /// Arguments in order; exactly parameters() of them.
  virtual double evaluate(std::span<const double> arguments) const = 0;
  /// Names what makes it impossible to evaluate yet (an internal f_* function, say); empty if it can be.
  virtual std::string not_yet() const = 0;
};

}  // namespace lentray::core
