#include "core/accel/uniform_grid.h"

#include <algorithm>
#include <numeric>

namespace lentray::core {
namespace {

constexpr double kCellsAPart = 4.0;
constexpr int kMostCells = 128;     ///< along an axis
constexpr double kThinnest = 1e-3;  ///< of the longest side: what a flat grid's height is taken as

}  // namespace

UniformGrid::UniformGrid(std::span<const Bounds> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].is_empty()) continue;
    m_box.include(boxes[i]);
    m_all.push_back(static_cast<std::uint32_t>(i));
  }
  if (m_all.empty()) return;
  const Vec3 raw = m_box.hi - m_box.lo;
  const double longest = std::max({raw.x, raw.y, raw.z, 1e-30});
  const double grow = kThinnest * longest;
  m_box.lo -= Vec3{grow, grow, grow};
  m_box.hi += Vec3{grow, grow, grow};
  const Vec3 extent = m_box.hi - m_box.lo;
  const double volume = extent.x * extent.y * extent.z;
  const double density = std::cbrt(kCellsAPart * static_cast<double>(m_all.size()) / volume);
  for (int a = 0; a < 3; ++a) {
    m_cells[a] = static_cast<int>(std::clamp(extent[a] * density, 1.0, 1.0 * kMostCells));
    m_size[a] = extent[a] / m_cells[a];
  }
  // Twice over the boxes: how many a cell has, then which.
  const auto visit = [&](auto&& each) {
    for (const std::uint32_t part : m_all) {
      const Vec3 pad = m_size * kPad;
      const std::array<int, 3> lo = cell_of(boxes[part].lo - pad),
                               hi = cell_of(boxes[part].hi + pad);
      for (int z = lo[2]; z <= hi[2]; ++z) {
        for (int y = lo[1]; y <= hi[1]; ++y) {
          for (int x = lo[0]; x <= hi[0]; ++x) each(index({x, y, z}), part);
        }
      }
    }
  };
  m_first.assign(static_cast<std::size_t>(m_cells[0]) * m_cells[1] * m_cells[2] + 1, 0);
  visit([&](std::size_t cell, std::uint32_t) { ++m_first[cell + 1]; });
  std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
  m_parts.resize(m_first.back());
  std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
  visit([&](std::size_t cell, std::uint32_t part) { m_parts[next[cell]++] = part; });
}

std::array<int, 3> UniformGrid::cell_of(const Vec3& p) const {
  std::array<int, 3> cell{};
  for (int a = 0; a < 3; ++a) {
    const double place = std::floor((p[a] - m_box.lo[a]) / m_size[a]);
    cell[a] = static_cast<int>(std::clamp(place, 0.0, m_cells[a] - 1.0));
  }
  return cell;
}

UniformGrid::Start UniformGrid::start(const Ray& ray, double limit, Walker& walker) const {
  const Vec3 extent = m_box.hi - m_box.lo, away = ray.origin - m_box.centre();
  const Vec3& d = ray.direction;
  const double longest = std::max({extent.x, extent.y, extent.z});
  const double distance = std::max({std::fabs(away.x), std::fabs(away.y), std::fabs(away.z)});
  const double largest = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  if (!(distance < kFar * longest) || !(largest > 0.0)) return Start::kTooFar;
  double enters = 0.0, leaves = limit;
  for (int a = 0; a < 3; ++a) {
    if (std::fabs(d[a]) < kLeastComponent * largest) {
      if (ray.origin[a] < m_box.lo[a] || ray.origin[a] > m_box.hi[a]) return Start::kMisses;
      continue;
    }
    walker.step[a] = d[a] > 0.0 ? 1 : -1;
    walker.inverse[a] = 1.0 / d[a];
    const double t0 = (m_box.lo[a] - ray.origin[a]) * walker.inverse[a];
    const double t1 = (m_box.hi[a] - ray.origin[a]) * walker.inverse[a];
    enters = std::max(enters, std::min(t0, t1));
    leaves = std::min(leaves, std::max(t0, t1));
  }
  if (!(enters <= leaves)) return Start::kMisses;
  walker.at = cell_of(ray.origin + d * enters);
  for (int a = 0; a < 3; ++a) walker.leaves[a] = border(ray, walker, a);
  return Start::kInside;
}

std::size_t UniformGrid::memory() const {
  return (m_first.capacity() + m_parts.capacity() + m_all.capacity()) * sizeof(std::uint32_t);
}

}  // namespace lentray::core
