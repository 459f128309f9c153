// Reports the work of one thread to the cells of the picture. Time is the thread's CPU time, so that
// other programs and waiting do not count; reading it takes some 0.2 microseconds, so it is read
// once for many fast pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/render/antialiasing.h"
#include "core/render/pixel_lattice.h"
#include "core/render/work_cells.h"

namespace lentray::core {

/// CPU time of the calling thread.
double thread_seconds();

class WorkMeter {
 public:
  /// `lattice` and `threshold` say which samples are neighbours and when they differ.
  WorkMeter(WorkCells& cells, const PixelLattice& lattice, double threshold)
      : m_cells(cells), m_lattice(lattice), m_threshold(static_cast<float>(threshold)) {}

  /// A job begins, or ends: what is visited between belongs to the stage.
  void begin(std::size_t stage);
  void end();
  /// Work on a pixel begins.
  void pixel(std::int32_t column, std::int32_t row) {
    const std::uint32_t cell = m_cells.index(column, row);
    if (cell != m_cell || m_count >= m_most) leave(cell);
    ++m_count;
  }
  /// A sample of stage 0 as it will be compared.
  void seen(std::int32_t column, std::int32_t row, const Compared& sample);

 private:
  struct Visited {
    std::uint32_t cell = 0, count = 0;
  };
  void leave(std::uint32_t next_cell);
  /// Shares the time since the last call among the cells visited since.
  void share_time();
  bool are_neighbours(std::int32_t column, std::int32_t row) const;

  WorkCells& m_cells;
  const PixelLattice& m_lattice;
  const float m_threshold;
  std::size_t m_stage = 0;
  std::uint32_t m_cell = 0, m_count = 0;
  std::uint32_t m_most = 1;  ///< pixels between two looks at the clock
  std::array<Visited, 8> m_visited{};
  std::size_t m_visits = 0;  ///< used of m_visited
  double m_read = 0.0;       ///< when the clock was read
  std::int32_t m_last_column = -2, m_last_row = -2;
  Compared m_last{};
};

}  // namespace lentray::core
