#include "tests/stability/polynomials/measure.h"

#include <time.h>

#include <algorithm>
#include <cmath>

namespace lentray::stability {
namespace {

constexpr double kNear = 1e-3;

struct Match {
  double distance;
  std::size_t root, answer;
};

/// Which answer each root has (-1: none), nearest pairs first.
std::vector<int> matches(const std::vector<TrueRoot>& roots, const Roots& answers) {
  std::vector<Match> near;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    for (std::size_t j = 0; j < answers.size(); ++j) {
      const double distance = std::fabs(answers[j] - roots[i].x) / std::fabs(roots[i].x);
      if (distance <= kNear) near.push_back({distance, i, j});
    }
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const Match& a, const Match& b) { return a.distance < b.distance; });
  std::vector<int> answer_of(roots.size(), -1);
  std::vector<bool> taken(answers.size(), false);
  for (const Match& m : near) {
    if (answer_of[m.root] >= 0 || taken[m.answer]) continue;
    answer_of[m.root] = static_cast<int>(m.answer);
    taken[m.answer] = true;
  }
  return answer_of;
}

double percentile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0.0;
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

Figures figures(const Solver& solver, const std::vector<Case>& cases) {
  constexpr double kEpsilon = 1.1e-16;
  Figures f;
  std::vector<double> errors, excess;
  for (const Case& c : cases) {
    double found[kMaxOrder + 1];
    const Roots answers(found, found + solver.solve(c.polynomial, found));
    const std::vector<TrueRoot>& roots = c.truth.roots();
    const std::vector<int> answer_of = matches(roots, answers);
    ++f.polynomials;
    f.roots += static_cast<int>(roots.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
      if (answer_of[i] < 0) {
        ++(roots[i].is_hidden ? f.missed_hidden : f.missed);
        continue;
      }
      const double answer = answers[static_cast<std::size_t>(answer_of[i])];
      const double error = std::fabs(answer - roots[i].x) / std::fabs(roots[i].x);
      errors.push_back(error);
      if (!roots[i].is_hidden) excess.push_back(error / (kEpsilon * (1.0 + roots[i].condition)));
    }
    for (std::size_t j = 0; j < answers.size(); ++j) {
      if (std::find(answer_of.begin(), answer_of.end(), static_cast<int>(j)) != answer_of.end())
        continue;
      ++(c.truth.is_zero_within_rounding(answers[j]) ? f.invented_hidden : f.invented);
    }
  }
  std::sort(errors.begin(), errors.end());
  std::sort(excess.begin(), excess.end());
  f.median = percentile(errors, 0.5);
  f.percentile_99 = percentile(errors, 0.99);
  f.largest = errors.empty() ? 0.0 : errors.back();
  f.excess = percentile(excess, 0.99);
  return f;
}

double seconds(const Solver& solver, const std::vector<Case>& cases) {
  const auto now = [] {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double start = now();
  volatile double keep = 0.0;
  for (const Case& c : cases) {
    double found[kMaxOrder + 1];
    found[0] = 0.0;
    const int n = solver.solve(c.polynomial, found);
    keep = keep + found[0] + n;
  }
  return now() - start;
}

}  // namespace lentray::stability
