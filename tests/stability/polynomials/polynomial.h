// A polynomial as the solvers are given it, and what a solver says of it.
#pragma once

#include <array>
#include <vector>

namespace lentray::stability {

constexpr int kMaxOrder = 15;

/// c[0] x^order + ... + c[order].
struct Polynomial {
  int order = 0;
  std::array<double, kMaxOrder + 1> c{};
};

/// All real roots, ascending; a double root once or twice.
using Roots = std::vector<double>;

}  // namespace lentray::stability
