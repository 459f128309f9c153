#include "core/irradiance/sample_grid.h"

#include <algorithm>

namespace lentray::core {
namespace {

constexpr std::size_t kFewSlots = 64;
constexpr float kNowhere = 1e15f;  ///< sides away: of a lane without a sample

}  // namespace

SampleGrid::SampleGrid() : m_slots(kFewSlots, kNone), m_mask(kFewSlots - 1) {}

const SampleGrid::Grid& SampleGrid::grid_of(int exponent) {
  const auto at =
      std::lower_bound(m_grids.begin(), m_grids.end(), exponent,
                       [](const Grid& grid, int wanted) { return grid.exponent < wanted; });
  if (at != m_grids.end() && at->exponent == exponent) return *at;
  return *m_grids.insert(at, {exponent, std::ldexp(1.0, -exponent)});
}

/// Of the cell, or a free one.
std::uint32_t& SampleGrid::slot(int exponent, const std::array<std::uint32_t, 3>& place) {
  for (std::uint64_t i = hash(exponent, place);; ++i) {
    std::uint32_t& slot = m_slots[i & m_mask];
    if (slot == kNone) return slot;
    if (m_cells[slot].is_at(exponent, place)) return slot;
  }
}

void SampleGrid::grow() {
  m_slots.assign(2 * m_slots.size(), kNone);
  m_mask = m_slots.size() - 1;
  for (std::uint32_t i = 0; i < m_cells.size(); ++i) {
    slot(m_cells[i].exponent, m_cells[i].place) = i;
  }
}

/// A four with a free lane: that of the next sample.
SampleGrid::Four& SampleGrid::room_in(Cell& cell) {
  if (cell.samples % 4 == 0) {
    const auto added = static_cast<std::uint32_t>(m_fours.size());
    Four empty{};
    std::fill_n(empty.x, 4, kNowhere);
    std::fill_n(empty.index, 4, kNone);
    m_fours.push_back(empty);
    m_next.push_back(kNone);
    (cell.samples == 0 ? cell.first : m_next[cell.last]) = added;
    cell.last = added;
  }
  return m_fours[cell.last];
}

void SampleGrid::put(std::uint32_t index, const IrradianceSample& sample, const Grid& grid,
                     const Place& place) {
  if (2 * m_cells.size() >= m_slots.size()) grow();
  std::uint32_t& found = slot(grid.exponent, short_of(place));
  if (found == kNone) {
    found = static_cast<std::uint32_t>(m_cells.size());
    m_cells.push_back({grid.exponent, short_of(place), kNone, kNone, 0});
  }
  Cell& cell = m_cells[found];
  Four& four = room_in(cell);
  const std::size_t lane = cell.samples++ % 4;
  const Vec3 at = in_sides(beyond_origin(sample.point), grid);
  four.x[lane] = static_cast<float>(at.x - static_cast<double>(place[0]));
  four.y[lane] = static_cast<float>(at.y - static_cast<double>(place[1]));
  four.z[lane] = static_cast<float>(at.z - static_cast<double>(place[2]));
  four.radius[lane] = static_cast<float>(sample.radius * grid.inverse);
  const bool grows = sample.nearest > sample.radius && !(sample.to_nearest == Vec3());
  four.longest[lane] =
      grows ? static_cast<float>(sample.nearest * grid.inverse) : four.radius[lane];
  four.nx[lane] = static_cast<float>(sample.normal.x);
  four.ny[lane] = static_cast<float>(sample.normal.y);
  four.nz[lane] = static_cast<float>(sample.normal.z);
  four.index[lane] = index;
}

void SampleGrid::add(std::uint32_t index, const IrradianceSample& sample, const Vec3& middle,
                     double half) {
  const Grid grid = grid_of(std::ilogb(half));
  // The box is two cells along each axis.
  const Place first = cell_of(in_sides(middle - Vec3(0.5 * half), grid));
  for (int corner = 0; corner < 8; ++corner) {
    put(index, sample, grid,
        {first[0] + (corner & 1), first[1] + (corner >> 1 & 1), first[2] + (corner >> 2)});
  }
}

std::size_t SampleGrid::bytes() const {
  return m_cells.capacity() * sizeof(Cell) + m_slots.capacity() * sizeof(m_slots[0]) +
         m_fours.capacity() * sizeof(Four) + m_next.capacity() * sizeof(m_next[0]);
}

}  // namespace lentray::core
