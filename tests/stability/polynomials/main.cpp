// lentray-polynomials COUNT ROUNDS: every solver on COUNT polynomials of each order and kind, as CSV
// on standard output. Times are the least of ROUNDS rounds in which the solvers take turns.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/stability/polynomials/measure.h"
#include "tests/stability/polynomials/samples.h"

namespace {

using namespace lentray::stability;

void report(int order, const std::string& kind, const std::vector<Case>& cases, int rounds) {
  std::vector<double> least(solvers().size(), 1e9);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < solvers().size(); ++i) {
      if (order <= solvers()[i].max_order)
        least[i] = std::min(least[i], seconds(solvers()[i], cases));
    }
  }
  for (std::size_t i = 0; i < solvers().size(); ++i) {
    const Solver& solver = solvers()[i];
    if (order > solver.max_order) continue;
    const Figures f = figures(solver, cases);
    std::printf("%s,%d,%s,%d,%d,%d,%d,%d,%d,%.3g,%.3g,%.3g,%.3g,%.1f\n", solver.name.data(), order,
                kind.c_str(), f.polynomials, f.roots, f.missed, f.missed_hidden, f.invented,
                f.invented_hidden, f.median, f.percentile_99, f.largest, f.excess,
                1e9 * least[i] / static_cast<double>(cases.size()));
  }
}

}  // namespace

int main(int count_of_arguments, char** arguments) {
  if (count_of_arguments != 3 || std::atoi(arguments[1]) < 1 || std::atoi(arguments[2]) < 1) {
    std::fputs("usage: lentray-polynomials COUNT ROUNDS\n", stderr);
    return 1;
  }
  std::puts(
      "solver,order,kind,polynomials,roots,missed,missed_hidden,invented,invented_hidden,"
      "median,percentile_99,largest,excess,ns");
  for (int order = 2; order <= kMaxOrder; ++order) {
    for (const std::string& kind : kinds()) {
      std::vector<Case> cases;
      for (const Polynomial& p : samples(kind, order, std::atoi(arguments[1]))) {
        cases.push_back({p, Truth(p)});
      }
      report(order, kind, cases, std::atoi(arguments[2]));
    }
  }
}
