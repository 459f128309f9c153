// What the threads of a frame report of their work, for squares of the picture: pixels that were
// visited, CPU time, and how often neighbouring samples differ. Pixels of the image, seconds.
// Threads: any number add and read at once; a reader may see a visit before its time.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/render/picture_ledger.h"
#include "core/render/pixel_order.h"

namespace lentray::core {

class WorkCells {
 public:
  static constexpr std::size_t kStages = 2;  ///< of a band, see FilmBand

  struct Cell {
    std::array<std::atomic<std::uint32_t>, kStages> visits{};  ///< pixels
    std::array<std::uint32_t, kStages> known{};                ///< pixels that are not visited
    std::atomic<std::uint64_t> nanoseconds{0};                 ///< of stage 0
    std::atomic<std::uint32_t> pairs{0}, differing{0};         ///< neighbouring samples of stage 0
  };

  /// `region`: the pixels that are traced; not empty.
  explicit WorkCells(const PixelRegion& region);

  std::uint32_t side() const { return 1u << m_shift; }  ///< of a cell, pixels
  std::uint32_t columns() const { return m_columns; }
  std::uint32_t rows() const { return m_rows; }
  std::size_t size() const { return m_cells.size(); }
  /// Of the nearest cell for pixels outside the region.
  std::uint32_t index(std::int32_t column, std::int32_t row) const {
    return place(row, m_region.top, m_rows) * m_columns + place(column, m_region.left, m_columns);
  }
  /// How many pixels of the region a cell has that are visited in a stage.
  std::uint32_t pixels(std::size_t cell, std::size_t stage) const;
  /// Pixels of the region that are in the set are not visited. Before any work begins.
  void leave_out(const PixelSet& known, std::size_t stage);
  Cell& operator[](std::size_t cell) { return m_cells[cell]; }
  const Cell& operator[](std::size_t cell) const { return m_cells[cell]; }

  void add_seconds(std::size_t stage, double seconds) {
    m_nanoseconds[stage].fetch_add(static_cast<std::uint64_t>(seconds * 1e9),
                                   std::memory_order_relaxed);
  }
  /// CPU time of all threads.
  double seconds(std::size_t stage) const {
    return 1e-9 * static_cast<double>(m_nanoseconds[stage].load(std::memory_order_relaxed));
  }

 private:
  std::uint32_t place(std::int32_t at, std::uint32_t start, std::uint32_t count) const {
    const std::int32_t from = at - static_cast<std::int32_t>(start);
    const std::uint32_t cell = from < 0 ? 0 : static_cast<std::uint32_t>(from) >> m_shift;
    return cell < count ? cell : count - 1;
  }

  PixelRegion m_region;
  std::uint32_t m_shift = 4;  ///< a cell is 2^shift pixels wide and high
  std::uint32_t m_columns = 0, m_rows = 0;
  std::vector<Cell> m_cells;
  std::array<std::atomic<std::uint64_t>, kStages> m_nanoseconds{};
};

}  // namespace lentray::core
