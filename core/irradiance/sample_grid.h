// Where samples may be of use: boxes of samples in grids, so that for a point a few are left to be looked
// at. World space. Samples are added in order, and named in order within a grid; grids with small cells
// come first. Reading is thread-safe while nobody adds.
//
// There is a grid for each size of boxes, a power of two. A cell names all samples whose boxes reach into
// it, four side by side with what shows in floats that they are too far, or turned away too much: none
// that is of use is left out.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/simd.h"
#include "core/irradiance/sample.h"

namespace lentray::core {

class SampleGrid {
 public:
  SampleGrid();
  /// `box`: from its middle, which is given beyond `origin`, `half` along each axis: a power of two.
  void add(std::uint32_t index, const IrradianceSample& sample, const Vec3& middle, double half);
  /// Calls take(index) for those below `limit` that may be of use.
  template <class Take>
  void near(const ReuseQuery& query, std::size_t limit, Take&& take) const;
  std::size_t bytes() const;

  /// Places are measured from there: it decides how they are rounded.
  static constexpr double kOrigin = -1e7;
  static Vec3 beyond_origin(const Vec3& point) { return point - Vec3(kOrigin); }

 private:
  using Place = std::array<std::int64_t, 3>;  ///< of a cell
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct Grid {
    int exponent;    ///< of the side of its cells
    double inverse;  ///< of the side
  };
  /// Places from the cell's corner and radii in sides.
  struct alignas(16) Four {
    float x[4], y[4], z[4], radius[4];
    float longest[4];           ///< radius towards anything
    float nx[4], ny[4], nz[4];  ///< normals
    std::uint32_t index[4];
  };
  struct Cell {
    int exponent;
    std::array<std::uint32_t, 3>
        place;                  ///< as far as 32 bits hold it: what shares them is looked at, too
    std::uint32_t first, last;  ///< fours
    std::uint32_t samples;
    bool is_at(int e, const std::array<std::uint32_t, 3>& p) const {
      return ((place[0] ^ p[0]) | (place[1] ^ p[1]) | (place[2] ^ p[2])) == 0 && exponent == e;
    }
  };
  static Float4 roots(Float4 v) {
    return Float4{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
  }
  /// What is asked, in the unit of the fours.
  struct Target {
    Float4 x, y, z, nx, ny, nz, most, slack;
    /// The lanes that may be of use: those not too far for how much they are turned, nor too far in front.
    unsigned among(const Four& four) const {
      constexpr float kRounding = 1e-6f, kInFront = 0.101f;
      const Float4 dx = simd::float4_at(four.x) - x, dy = simd::float4_at(four.y) - y,
                   dz = simd::float4_at(four.z) - z;
      const Float4 distance = roots(dx * dx + dy * dy + dz * dz);
      const Int4 is_close = distance <= simd::float4_at(four.radius) * most + slack;
      if (simd::signs(is_close) == 0) return 0;
      const Float4 mx = simd::float4_at(four.nx), my = simd::float4_at(four.ny),
                   mz = simd::float4_at(four.nz);
      const Float4 off = (1.0f - kRounding) - (mx * nx + my * ny + mz * nz);
      const Float4 turned = 2.0f * roots(simd::max(off, simd::float4(0.0f)));
      const Int4 is_near =
          is_close & (distance <= simd::float4_at(four.longest) * (most - turned) + slack);
      const Float4 in_front = dx * (mx + nx) + dy * (my + ny) + dz * (mz + nz);
      return simd::signs(is_near & (in_front <= kInFront * distance + 4.0f * slack));
    }
  };

  static std::uint64_t hash(int exponent, const std::array<std::uint32_t, 3>& place) {
    std::uint64_t h = (std::uint64_t{place[0]} << 32 | place[1]) * 0x9e3779b97f4a7c15ull;
    h ^= h >> 32;
    h += std::uint64_t{place[2]} << 8 | static_cast<std::uint8_t>(exponent);
    h *= 0xd6e8feb86659fd93ull;
    return h ^ h >> 32;
  }
  static std::array<std::uint32_t, 3> short_of(const Place& place) {
    return {static_cast<std::uint32_t>(place[0]), static_cast<std::uint32_t>(place[1]),
            static_cast<std::uint32_t>(place[2])};
  }
  /// Cells lie half a side beside the multiples of the side.
  static Vec3 in_sides(const Vec3& beyond, const Grid& grid) {
    return beyond * grid.inverse + Vec3(0.5);
  }
  static std::int64_t cell_of(double in_sides) {
    constexpr double kMost = 0x1p62;  // of what the type holds; no number is -kMost
    const double place = std::min(kMost, std::max(-kMost, in_sides));
    const auto whole = static_cast<std::int64_t>(place);
    return whole - (static_cast<double>(whole) > place ? 1 : 0);
  }
  static Place cell_of(const Vec3& in_sides) {
    return {cell_of(in_sides.x), cell_of(in_sides.y), cell_of(in_sides.z)};
  }
  std::uint32_t& slot(int exponent, const std::array<std::uint32_t, 3>& place);
  const Cell* find(int exponent, const std::array<std::uint32_t, 3>& place) const {
    for (std::uint64_t i = hash(exponent, place);; ++i) {
      const std::uint32_t cell = m_slots[i & m_mask];
      if (cell == kNone) return nullptr;
      const Cell& found = m_cells[cell];
      if (found.is_at(exponent, place)) return &found;
    }
  }
  const Grid& grid_of(int exponent);
  void grow();
  Four& room_in(Cell& cell);
  void put(std::uint32_t index, const IrradianceSample& sample, const Grid& grid,
           const Place& cell);

  std::vector<Grid> m_grids;           ///< by exponent
  std::vector<Cell> m_cells;           ///< of all grids
  std::vector<std::uint32_t> m_slots;  ///< by hash: cells
  std::uint64_t m_mask;
  std::vector<Four> m_fours;          ///< of all cells
  std::vector<std::uint32_t> m_next;  ///< the four behind each in its cell
};

template <class Take>
void SampleGrid::near(const ReuseQuery& query, std::size_t limit, Take&& take) const {
  constexpr double kWider = 1.0 + 1e-5, kRounding = 1e-5;  // above those of floats
  constexpr double kOff = 0x1p-50;  // of two places: what is rounded away beyond the origin
  constexpr double kSame = 2e-6;    // scene units: between such places there is no direction
  const Vec3 beyond = beyond_origin(query.point);
  const double off =
      kSame + kOff * (std::fabs(beyond.x) + std::fabs(beyond.y) + std::fabs(beyond.z));
  Target target;
  target.most = simd::float4(static_cast<float>(query.error_bound * kWider));
  target.nx = simd::float4(static_cast<float>(query.normal.x));
  target.ny = simd::float4(static_cast<float>(query.normal.y));
  target.nz = simd::float4(static_cast<float>(query.normal.z));
  for (const Grid& grid : m_grids) {
    const Vec3 at = in_sides(beyond, grid);
    const Place place = cell_of(at);
    const Cell* cell = find(grid.exponent, short_of(place));
    if (!cell) continue;
    target.x = simd::float4(static_cast<float>(at.x - static_cast<double>(place[0])));
    target.y = simd::float4(static_cast<float>(at.y - static_cast<double>(place[1])));
    target.z = simd::float4(static_cast<float>(at.z - static_cast<double>(place[2])));
    target.slack = simd::float4(static_cast<float>(kRounding + off * grid.inverse));
    for (std::uint32_t four = cell->first; four != kNone; four = m_next[four]) {
      const Four& those = m_fours[four];
      if (those.index[0] >= limit) break;
      for (unsigned lanes = target.among(those); lanes != 0; lanes &= lanes - 1) {
        const std::uint32_t index = those.index[std::countr_zero(lanes)];
        if (index < limit) take(index);
      }
    }
  }
}

}  // namespace lentray::core
