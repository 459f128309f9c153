// The solvers that are compared: the one that lentray uses, and the ways that others take, written
// for this comparison alone. Any thread.
#pragma once

#include <string_view>
#include <vector>

#include "tests/stability/polynomials/polynomial.h"

namespace lentray::stability {

struct Solver {
  std::string_view name;
  int max_order;
  /// Writes the roots to `roots` (room for the order), returns how many.
  int (*solve)(const Polynomial& p, double* roots);
};

/// closed: the school's formula, Cardano's with cosines, Ferrari's (orders 2 to 4).
/// polished: the same, each root bettered by up to four Newton steps.
/// sturm: a Sturm chain counts the roots between bisections, each is then bracketed.
/// simultaneous: all complex roots at once by Aberth's iteration, those on the real axis kept.
/// lentray: core::solve_between_bounds on the whole axis.
const std::vector<Solver>& solvers();

}  // namespace lentray::stability
