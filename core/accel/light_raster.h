// What a light sees through one face of a cube around it, as a raster of cells.
// World space in, relative to the light; cells out. Immutable, any number of threads.
#pragma once

#include <cmath>
#include <cstdint>

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
  static constexpr double kSlack = 1e-7;  ///< in u and v: far above rounding, far below a cell
  double lo[2] = {Bounds::kInf, Bounds::kInf}, hi[2] = {-Bounds::kInf, -Bounds::kInf};
  bool is_empty() const { return !(lo[0] <= hi[0] && lo[1] <= hi[1]); }
  void include(const LightWindow& other);
  void cut(double least, double most);
};

/// Where the box shows on the face, exactly but for rounding; empty if it does not. `box` is
/// relative to the light.
LightWindow window_of(const Bounds& box, int face);

class LightRaster {
 public:
  LightRaster() = default;
  /// `columns` and `rows` cells over the window, which is widened a little.
  LightRaster(int face, const LightWindow& window, int columns, int rows);

  std::uint32_t cells() const {
    return static_cast<std::uint32_t>(m_size[0]) * static_cast<std::uint32_t>(m_size[1]);
  }
  /// The cell of a direction of this face with that w > 0; -1 outside.
  std::int64_t cell_of(const Vec3& v, double w) const {
    const double along[3] = {v.x, v.y, v.z}, over_w = 1.0 / w;
    const double x = (along[m_u] * over_w - m_lo[0]) * m_per_cell[0];
    const double y = (along[m_v] * over_w - m_lo[1]) * m_per_cell[1];
    if (!(x >= 0.0 && y >= 0.0 && x < m_size[0] && y < m_size[1])) return -1;
    return static_cast<std::int64_t>(static_cast<std::int32_t>(y)) * m_size[0] +
           static_cast<std::int32_t>(x);
  }

  int face() const { return m_face; }
  int axis(int side) const { return side == 0 ? m_u : m_v; }
  int size(int side) const { return m_size[side]; }
  /// Cells a unit of u or v.
  double per_cell(int side) const { return m_per_cell[side]; }
  double least(int side) const { return m_lo[side]; }  ///< u or v where the cells begin
  /// u or v to cells, and back.
  double in_cells(int side, double at) const { return (at - m_lo[side]) * m_per_cell[side]; }
  double place(int side, double cell) const { return m_lo[side] + cell / m_per_cell[side]; }
  /// Of a corner of the lattice, w = 1.
  Vec3 direction(double x, double y) const;

 private:
  int m_face = 0, m_u = 0, m_v = 1;
  int m_size[2] = {0, 0};
  double m_lo[2] = {0.0, 0.0}, m_per_cell[2] = {0.0, 0.0};
};

}  // namespace lentray::core
