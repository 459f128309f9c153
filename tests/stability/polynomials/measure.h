// How right and how fast a solver is on a set of polynomials. Any thread.
#pragma once

#include <vector>

#include "tests/stability/polynomials/solvers.h"
#include "tests/stability/polynomials/truth.h"

namespace lentray::stability {

/// A root counts as found if an answer lies within a thousandth of it that no other root has. Where
/// the polynomial stays within the rounding of its own evaluation, both answers count as right: two
/// roots or none ("hidden", counted apart).
struct Figures {
  int polynomials = 0, roots = 0;
  int missed = 0, missed_hidden = 0;                        ///< no answer is near
  int invented = 0, invented_hidden = 0;                    ///< an answer that no root is near
  double median = 0.0, percentile_99 = 0.0, largest = 0.0;  ///< relative errors of the found roots
  /// 99th percentile of the error in units of what one rounding of the coefficients would make.
  double excess = 0.0;
};

struct Case {
  Polynomial polynomial;
  Truth truth;
};

Figures figures(const Solver& solver, const std::vector<Case>& cases);

/// Seconds of the processor for all of the cases once.
double seconds(const Solver& solver, const std::vector<Case>& cases);

}  // namespace lentray::stability
