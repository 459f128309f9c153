#include "tests/stability/polynomials/solvers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numeric/roots.h"
#include "tests/stability/polynomials/aberth.h"
#include "tests/stability/polynomials/closed_forms.h"
#include "tests/stability/polynomials/sturm.h"

namespace lentray::stability {
namespace {

int simultaneous(const Polynomial& p, double* roots) {
  constexpr double kClose = 1e-15, kReal = 1e-9;
  constexpr int kSteps = 60;
  int n = 0;
  for (const Complex<double>& z : aberth<double>(p, kClose, kSteps)) {
    if (std::fabs(z.im) <= kReal * std::fabs(z.re)) roots[n++] = z.re;
  }
  std::sort(roots, roots + n);
  return n;
}

int lentray(const Polynomial& p, double* roots) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return core::solve_between_bounds(p.c.data(), p.order, -kInf, kInf, roots);
}

}  // namespace

const std::vector<Solver>& solvers() {
  static const std::vector<Solver> kSolvers = {{"closed", 4, closed_form},
                                               {"polished", 4, polished_closed_form},
                                               {"sturm", kMaxOrder, sturm},
                                               {"simultaneous", kMaxOrder, simultaneous},
                                               {"lentray", kMaxOrder, lentray}};
  return kSolvers;
}

}  // namespace lentray::stability
