#include "core/render/work_meter.h"

#include <algorithm>
#include <ctime>

namespace lentray::core {
namespace {

/// Seconds between two looks at the clock, about: enough to make them cheap, little enough for a bar.
constexpr double kBetween = 200e-6;
constexpr std::uint32_t kMost = 256;

}  // namespace

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void WorkMeter::begin(std::size_t stage) {
  m_stage = stage;
  m_count = 0;
  m_visits = 0;
  m_last_row = -2;
  m_read = thread_seconds();
}

void WorkMeter::end() {
  leave(m_cell);
  share_time();
}

void WorkMeter::leave(std::uint32_t next_cell) {
  if (m_count > 0) {
    m_cells[m_cell].visits[m_stage].fetch_add(m_count, std::memory_order_relaxed);
    m_visited[m_visits++] = {m_cell, m_count};
    m_count = 0;
    std::uint32_t all = 0;
    for (std::size_t i = 0; i < m_visits; ++i) all += m_visited[i].count;
    if (all >= m_most || m_visits == m_visited.size()) share_time();
  }
  m_cell = next_cell;
}

void WorkMeter::share_time() {
  const double now = thread_seconds(), spent = now - m_read;
  m_read = now;
  std::uint32_t all = 0;
  for (std::size_t i = 0; i < m_visits; ++i) all += m_visited[i].count;
  m_cells.add_seconds(m_stage, spent);
  if (m_stage == 0) {
    for (std::size_t i = 0; i < m_visits; ++i) {
      const double part = spent * m_visited[i].count / all;
      m_cells[m_visited[i].cell].nanoseconds.fetch_add(static_cast<std::uint64_t>(part * 1e9),
                                                       std::memory_order_relaxed);
    }
  }
  m_visits = 0;
  const double fitting = all * kBetween / std::max(spent, 1e-9);
  m_most =
      static_cast<std::uint32_t>(std::clamp(fitting, 1.0, std::min<double>(kMost, 2.0 * m_most)));
}

bool WorkMeter::are_neighbours(std::int32_t column, std::int32_t row) const {
  if (column < 0 || m_last_column < 0) return false;
  if (column == m_last_column) return row == m_last_row + 1 || row == m_last_row - 1;
  const auto width = static_cast<std::int32_t>(m_lattice.left.size());
  if (row != m_last_row || column >= width || m_last_column >= width) return false;
  return m_lattice.left[static_cast<std::size_t>(column)] == m_last_column ||
         m_lattice.left[static_cast<std::size_t>(m_last_column)] == column;
}

void WorkMeter::seen(std::int32_t column, std::int32_t row, const Compared& sample) {
  if (are_neighbours(column, row)) {
    WorkCells::Cell& cell = m_cells[m_cells.index(column, row)];
    cell.pairs.fetch_add(1, std::memory_order_relaxed);
    if (sample.distance(m_last) >= m_threshold)
      cell.differing.fetch_add(1, std::memory_order_relaxed);
  }
  m_last_column = column;
  m_last_row = row;
  m_last = sample;
}

}  // namespace lentray::core
