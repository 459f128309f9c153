#include "shadow/search_samples.h"

namespace lentray::shadow {
namespace {

/// Of pairs where the blocker changes: those that the neighbourhood has a hit for all the same, as it
/// looks around, and its probes in vain. (On the SPD scenes 0.15 to 0.5 and 1.7 to 2.8.)
constexpr double kChangeHits = 0.3, kChangeMisses = 2.3;
constexpr double kGridHits = 0.85, kGridMisses = 1.9;  ///< of blocked rays
constexpr double kGuessed = 2.0;    ///< searches for a blocker, as long as others, before any was seen
constexpr double kGuessedTest = 6.0, kGuessedSearch = 50.0;  ///< costs, before any was seen
constexpr double kOlder = 0.85;    ///< what counts of the period before

}  // namespace

void SearchSamples::add_cost(double search, const core::Object* blocker) {
  m_sums.count += 1.0;
  m_sums.searched += search;
  if (!blocker) return;
  m_sums.blocked += 1.0;
  m_sums.searched_blocked += search;
  m_sums.tests += blocker->test_cost();
}

void SearchSamples::grow_old() {
  for (double* sum : {&m_sums.count, &m_sums.searched, &m_sums.blocked,
                      &m_sums.searched_blocked, &m_sums.tests, &m_sums.pairs, &m_sums.repeats, &m_sums.changes,
                      &m_sums.vain}) {
    *sum *= kOlder;
  }
}

double SearchSamples::search() const {
  return kSearchCost + (m_sums.count > 0.0 ? m_sums.searched / m_sums.count : kGuessedSearch);
}

double SearchSamples::hit() const {
  const double seen = m_sums.blocked + kGuessed;
  const double tests = (m_sums.tests + kGuessed * kGuessedTest) / seen;
  const double found = (m_sums.searched_blocked + kGuessed * (search() - kSearchCost)) / seen;
  return kSearchCost + found - kProbeCost - tests;
}

double SearchSamples::saved_by_neighbourhood() const {
  const double dark = m_sums.repeats + m_sums.changes;
  if (dark == 0.0) return -kLookCost;
  // One more change than was seen: few samples promise little.
  const double changes = m_sums.changes + 1.0;
  const double hits = m_sums.repeats + kChangeHits * changes;
  const double vain = kChangeMisses * (changes * kProbeCost + m_sums.vain + kGuessedTest);
  return m_blocked * (hits * hit() - vain) / (dark + 1.0) - kLookCost;
}

double SearchSamples::saved_by_grid() const {
  if (m_sums.count == 0.0) return -kKeysCost;
  const double vain = m_sums.changes > 0.0 ? m_sums.vain / m_sums.changes : kGuessedTest;
  return m_sums.blocked / m_sums.count * (kGridHits * hit() - kGridMisses * (kProbeCost + vain)) -
         kKeysCost;
}

}  // namespace lentray::shadow
