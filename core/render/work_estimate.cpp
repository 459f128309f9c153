#include "core/render/work_estimate.h"

#include <algorithm>
#include <cmath>

#include "core/render/pixel_lattice.h"

namespace lentray::core {
namespace {

/// A square's own probes count as these, and what is around it as one of them.
constexpr double kAround = 1.0;
/// So many pairs of probes weigh as much as those around. How many pixels are antialiased rises ever
/// slower with the share of pairs that differ: a share that is guessed from one probe foresees too few.
constexpr double kPairsAround = 8.0;
/// Pairs of neighbours that a cell needs to be believed.
constexpr double kPairs = 4.0;
/// So many differing pairs of probes weigh as much as the belief that all sides are alike.
constexpr double kDiffering = 30.0;
/// Visits that a cell needs before its own time is believed.
constexpr double kVisits = 16.0;
/// The share of all work that must be done before it says as much as the probes alone.
constexpr double kTrust = 0.1;
/// The side of what one thread traces at a time, in the pixel orders that are usual.
constexpr std::uint32_t kJob = 64;
/// Of a pixel that is looked at and not antialiased.
constexpr double kLookSeconds = 60e-9;

double visits(const WorkCells::Cell& cell, std::size_t stage) {
  return cell.visits[stage].load(std::memory_order_relaxed);
}

/// CPU seconds of stage 0.
double spent(const WorkCells::Cell& cell) {
  return 1e-9 * static_cast<double>(cell.nanoseconds.load(std::memory_order_relaxed));
}

/// How what was done compares with what was foreseen for it, `all` with all.
double ratio(double real, double foreseen, double all) {
  const double trust = kTrust * all;
  return foreseen + trust > 0.0 ? (real + trust) / (foreseen + trust) : 1.0;
}

}  // namespace

FinerWork FinerWork::of(const Antialiasing& antialiasing) {
  switch (antialiasing.method) {
    case 1: return {1.0 * antialiasing.depth * antialiasing.depth, 3.0, PixelLattice::kTile};
    case 2: {
      // Five samples cut a square; about half of its quarters are cut again and share some.
      double samples = 0.0, squares = 1.0;
      for (int i = 1; i < antialiasing.depth; ++i, squares *= 2.0)
        samples += squares * (i == 1 ? 5.0 : 4.0);
      return {samples, 2.0, kJob};
    }
    default: return {};
  }
}

WorkEstimate::WorkEstimate(const WorkCells& cells, const FinerWork& finer, double repeats)
    : m_cells(cells), m_finer(finer), m_repeats(repeats) {
  std::uint32_t columns = cells.columns(), rows = cells.rows();
  for (;;) {
    m_levels.push_back({columns, rows, std::vector<Sum>(std::size_t{columns} * rows)});
    if (columns <= 1 && rows <= 1) break;
    columns = (columns + 1) / 2;
    rows = (rows + 1) / 2;
  }
}

void WorkEstimate::probe(std::size_t cell, double seconds, int pairs, int differing) {
  std::size_t column = cell % m_cells.columns(), row = cell / m_cells.columns();
  for (Level& level : m_levels) {
    Sum& sum = level.sums[row * level.columns + column];
    sum.probes += 1.0;
    sum.seconds += seconds;
    sum.pairs += pairs;
    sum.differing += differing;
    column /= 2;
    row /= 2;
  }
}

bool WorkEstimate::is_traced(std::size_t cell) const {
  return visits(m_cells[cell], 0) >= m_cells.pixels(cell, 0);
}

/// From the whole picture down to the cells; the fewer probes a square has, the more it is like the
/// one it is in.
std::vector<WorkEstimate::Expected> WorkEstimate::expected() const {
  std::vector<Expected> outer(1), inner;
  for (std::size_t i = m_levels.size(); i-- > 0;) {
    const Level& level = m_levels[i];
    const std::uint32_t outer_columns = (level.columns + 1) / 2;
    inner.assign(level.sums.size(), {});
    for (std::size_t k = 0; k < inner.size(); ++k) {
      const std::size_t row = k / level.columns, column = k % level.columns;
      const bool is_top = i + 1 == m_levels.size();
      const Expected& around = outer[is_top ? 0 : row / 2 * outer_columns + column / 2];
      const double weight = is_top ? 1e-9 : kAround, pairs = is_top ? 1e-9 : kPairsAround;
      const Sum& sum = level.sums[k];
      inner[k].seconds = (sum.seconds + weight * around.seconds) / (sum.probes + weight);
      inner[k].differing = (sum.differing + pairs * around.differing) / (sum.pairs + pairs);
    }
    outer.swap(inner);
  }
  return outer;
}

WorkEstimate::Work WorkEstimate::work() const {
  const std::vector<Expected> foreseen = expected();
  Work out;
  const std::vector<double> seconds = sample_seconds(foreseen, out);
  if (m_finer.samples > 0.0) add_finer(foreseen, seconds, out);
  return out;
}

void WorkEstimate::add_left(const std::vector<double>& left, std::uint32_t job, Work& out) const {
  const std::uint32_t side = std::max(1u, job / m_cells.side());
  const std::uint32_t across = (m_cells.columns() + side - 1) / side,
                      down = (m_cells.rows() + side - 1) / side;
  std::vector<double> jobs(std::size_t{across} * down);
  for (std::size_t i = 0; i < left.size(); ++i) {
    out.left += left[i];
    jobs[i / m_cells.columns() / side * across + i % m_cells.columns() / side] += left[i];
  }
  for (const double one : jobs) out.longest = std::max(out.longest, one);
}

/// Adds stage 0; what a sample of each cell takes. What was foreseen is compared with what was
/// done in cells that were probed before they were traced: others were not foreseen well.
std::vector<double> WorkEstimate::sample_seconds(const std::vector<Expected>& foreseen,
                                                 Work& out) const {
  double left = 0.0, done = 0.0, real = 0.0;
  for (std::size_t i = 0; i < foreseen.size(); ++i) {
    const double pixels = m_repeats * m_cells.pixels(i, 0),
                 visited = std::min(visits(m_cells[i], 0), pixels);
    left += foreseen[i].seconds * (pixels - visited);
    if (m_levels.front().sums[i].probes == 0.0) continue;
    done += foreseen[i].seconds * visited;
    real += spent(m_cells[i]);
  }
  out.done += m_cells.seconds(0);
  const double times = ratio(real, done, left + m_cells.seconds(0));
  std::vector<double> seconds(foreseen.size()), rest(foreseen.size());
  for (std::size_t i = 0; i < foreseen.size(); ++i) {
    const double visited = visits(m_cells[i], 0);
    seconds[i] = (spent(m_cells[i]) + kVisits * times * foreseen[i].seconds) / (visited + kVisits);
    rest[i] = seconds[i] * std::max(0.0, m_repeats * m_cells.pixels(i, 0) - visited);
  }
  add_left(rest, kJob, out);
  return seconds;
}

/// Adds stage 1. Where samples were traced in turn, their differences say where pixels are
/// antialiased; how many these are, on the whole, probes say, which look to all sides alike.
void WorkEstimate::add_finer(const std::vector<Expected>& foreseen,
                             const std::vector<double>& seconds, Work& out) const {
  double from_probes = 0.0, from_threads = 0.0;
  for (std::size_t i = 0; i < foreseen.size(); ++i) {
    const double pairs = m_cells[i].pairs.load(std::memory_order_relaxed);
    if (pairs == 0.0) continue;
    from_probes += m_cells.pixels(i, 1) * foreseen[i].differing;
    from_threads +=
        m_cells.pixels(i, 1) * (m_cells[i].differing.load(std::memory_order_relaxed) / pairs);
  }
  const double known = m_levels.back().sums.front().differing;
  const double sides = from_threads > 0.0
                           ? 1.0 + (from_probes / from_threads - 1.0) * known / (known + kDiffering)
                           : 1.0;
  std::vector<double> pixel(foreseen.size());
  double all = 0.0, done = 0.0;
  for (std::size_t i = 0; i < foreseen.size(); ++i) {
    const double pairs = m_cells[i].pairs.load(std::memory_order_relaxed);
    const double differing = sides * m_cells[i].differing.load(std::memory_order_relaxed);
    const double share =
        std::clamp((differing + kPairs * foreseen[i].differing) / (pairs + kPairs), 0.0, 1.0);
    const double antialiased = 1.0 - std::pow(1.0 - share, m_finer.neighbours);
    pixel[i] = kLookSeconds + antialiased * m_finer.samples * seconds[i];
    all += pixel[i] * m_cells.pixels(i, 1);
    done += pixel[i] * std::min<double>(visits(m_cells[i], 1), m_cells.pixels(i, 1));
  }
  const double real = m_cells.seconds(1), times = ratio(real, done, all);
  out.done += real;
  for (std::size_t i = 0; i < foreseen.size(); ++i) {
    pixel[i] *= times * std::max(0.0, m_cells.pixels(i, 1) - visits(m_cells[i], 1));
  }
  add_left(pixel, m_finer.job, out);
}

}  // namespace lentray::core
