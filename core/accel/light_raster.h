// What a light sees through one face of a cube around it, as a raster of cells: which cells an
// object may darken, and which a flat or round one covers wholly. Conservative: everything is
// widened by more than rounding can move it. World space in, cells out; for building only.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/bounds.h"
#include "core/base/vec3.h"

namespace lentray::core {

/// A direction's place on the face: u and v are its other components over w, the face's own,
/// so that straight lines stay straight. Faces 2 * axis (w towards +) and 2 * axis + 1.
struct LightFace {
  static constexpr int kFaces = 6;
  static int of(const Vec3& v) {
    const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
    const int axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
    return 2 * axis + (v[axis] < 0.0 ? 1 : 0);
  }
  static double w_of(int face, const Vec3& v) { return face & 1 ? -v[face / 2] : v[face / 2]; }
  static int u_axis(int face) { return face / 2 == 0 ? 1 : 0; }
  static int v_axis(int face) { return face / 2 == 2 ? 1 : 2; }
};

/// A rectangle of the face's plane.
struct LightWindow {
  double lo[2] = {Bounds::kInf, Bounds::kInf}, hi[2] = {-Bounds::kInf, -Bounds::kInf};
  bool is_empty() const { return !(lo[0] <= hi[0] && lo[1] <= hi[1]); }
  void include(const LightWindow& other);
  void cut(double least, double most);
};

/// Where the box shows on the face, exactly but for rounding; empty if it does not. `box` is
/// relative to the light.
LightWindow window_of(const Bounds& box, int face);

/// What cell a rasteriser visits, and the range of w at which the object lies in it.
struct LightCell {
  std::uint32_t cell = 0;
  double near_w = 0.0;
  double full_w = Bounds::kInf;  ///< from here on the cell is dark; infinite: not wholly covered
};

class LightRaster {
 public:
  LightRaster() = default;
  /// `columns` and `rows` cells over the window, which is widened a little.
  LightRaster(int face, const LightWindow& window, int columns, int rows);

  bool empty() const { return m_size[0] == 0; }
  std::uint32_t cells() const {
    return static_cast<std::uint32_t>(m_size[0]) * static_cast<std::uint32_t>(m_size[1]);
  }
  /// The cell of a direction of this face with that w > 0; -1 outside.
  std::int64_t cell_of(const Vec3& v, double w) const {
    const double along[3] = {v.x, v.y, v.z}, over_w = 1.0 / w;
    const double x = (along[m_u] * over_w - m_lo[0]) * m_per_cell[0];
    const double y = (along[m_v] * over_w - m_lo[1]) * m_per_cell[1];
    if (!(x >= 0.0 && y >= 0.0 && x < m_limit[0] && y < m_limit[1])) return -1;
    return static_cast<std::int64_t>(y) * m_size[0] + static_cast<std::int64_t>(x);
  }

  /// All rasterisers append to `out`; points are relative to the light.
  void box(const Bounds& box, std::vector<LightCell>& out) const;
  void sphere(const Vec3& centre, double radius, std::vector<LightCell>& out) const;
  /// Even-odd, edges of any number of contours as pairs of ends, all in the plane
  /// dot(normal, x) = offset. Where a corner is beside or behind the light, its box counts.
  void flat(std::span<const Vec3> edge_ends, const Vec3& normal, double offset,
            std::vector<LightCell>& out) const;

 private:
  struct Range { int first[2], last[2]; bool empty; };
  Range range_of(const LightWindow& window) const;
  /// The direction of a corner of the lattice, w = 1; `grow` cells further out of a cell.
  double place(int axis, double cell) const { return m_lo[axis] + cell / m_per_cell[axis]; }
  Vec3 direction(double x, double y) const;
  void depths(const Vec3& normal, double offset, int column, int row, bool inside,
              LightCell& cell) const;

  int m_face = 0, m_u = 0, m_v = 1;
  int m_size[2] = {0, 0};
  double m_lo[2] = {0.0, 0.0}, m_per_cell[2] = {0.0, 0.0}, m_limit[2] = {0.0, 0.0};
};

}  // namespace lentray::core
