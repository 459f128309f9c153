#include "core/render/work_cells.h"

#include <algorithm>

namespace lentray::core {
namespace {

constexpr std::size_t kMostCells = 65536;

std::uint32_t count(std::uint32_t first, std::uint32_t end, std::uint32_t shift) {
  return ((end - first) + (1u << shift) - 1) >> shift;
}

}  // namespace

WorkCells::WorkCells(const PixelRegion& region) : m_region(region) {
  const auto measure = [this] {
    m_columns = count(m_region.left, m_region.right, m_shift);
    m_rows = count(m_region.top, m_region.bottom, m_shift);
    return std::size_t{m_columns} * m_rows;
  };
  while (measure() > kMostCells) ++m_shift;
  m_cells = std::vector<Cell>(measure());
}

void WorkCells::leave_out(const PixelSet& known, std::size_t stage) {
  for (std::uint32_t row = m_region.top; row < m_region.bottom; ++row) {
    for (std::uint32_t k = m_region.left; k < m_region.right; ++k) {
      if (!known.has({k, row})) continue;
      ++m_cells[index(static_cast<std::int32_t>(k), static_cast<std::int32_t>(row))].known[stage];
    }
  }
}

std::uint32_t WorkCells::pixels(std::size_t cell, std::size_t stage) const {
  const auto part = [this](std::uint32_t start, std::uint32_t end, std::size_t k) {
    const std::uint32_t first = start + (static_cast<std::uint32_t>(k) << m_shift);
    return std::min(end, first + (1u << m_shift)) - first;
  };
  return part(m_region.left, m_region.right, cell % m_columns) *
             part(m_region.top, m_region.bottom, cell / m_columns) -
         m_cells[cell].known[stage];
}

}  // namespace lentray::core
