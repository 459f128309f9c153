// Which cells of a light's raster an object may darken, and which a flat or round one covers
// wholly. Conservative: everything is widened by more than rounding can move it. Points are
// relative to the light. For building light buffers; one a thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/accel/light_raster.h"
#include "core/base/bounds.h"

namespace lentray::core {

/// A cell that is visited, and the range of w at which the object lies in it.
struct LightCell {
  std::uint32_t cell = 0;
  double near_w = 0.0;
  double full_w = Bounds::kInf;  ///< from here on the cell is dark; infinite: not wholly covered
};

/// All functions append to `out`, each cell once. `window`: of the object's box.
class LightOutline {
 public:
  explicit LightOutline(const LightRaster& raster) : m_raster(raster) {}

  /// In so few cells that a box is as good as any outline.
  bool is_small(const LightWindow& window) const { return is_small(range_of(window)); }
  void box(const Bounds& box, const LightWindow& window, std::vector<LightCell>& out);
  /// What is in the box and in the convex hull of the points.
  void hull(std::span<const Vec3> points, const Bounds& box, const LightWindow& window,
            std::vector<LightCell>& out);
  void sphere(const Vec3& centre, double radius, const LightWindow& window,
              std::vector<LightCell>& out);
  /// Even-odd, edges of any number of contours as pairs of ends, all in the plane
  /// dot(normal, x) = offset. Where a corner is beside or behind the light, its box counts.
  void flat(std::span<const Vec3> edge_ends, const Vec3& normal, double offset,
            std::vector<LightCell>& out);

 private:
  struct Range {
    int first[2], last[2];
    bool empty;
  };
  struct Point {
    double x, y;
  };  ///< in cells
  struct Span {
    double lo, hi;
  };

  Range range_of(const LightWindow& window) const;
  static bool is_small(const Range& r) {
    return r.last[0] - r.first[0] < 2 && r.last[1] - r.first[1] < 2;
  }
  Point point_of(const Vec3& v) const;  ///< w > 0
  double w_of(const Vec3& v) const { return LightFace::w_of(m_raster.face(), v); }
  std::uint32_t cell(int column, int row) const {
    return static_cast<std::uint32_t>(row * m_raster.size(0) + column);
  }
  double slack(int side) const;
  /// Calls visit(row, least x, most x) for the rows of the range that the line, widened, lies in.
  template <class Visit>
  void along(Point a, Point b, const Range& range, Visit&& visit) const;
  void all(const Range& range, double near_w, std::vector<LightCell>& out) const;
  void clear_rows(const Range& range);
  void widen_row(const Range& range, int row, double least, double most);
  void fill_rows(const Range& range, double near_w, std::vector<LightCell>& out) const;
  void turn_into_hull();
  void depths(const Vec3& normal, double offset, bool inside, int column, int row,
              LightCell& cell) const;

  const LightRaster& m_raster;
  // Kept for their memory.
  std::vector<Span> m_rows;
  std::vector<Point> m_points, m_hull;
  std::vector<std::uint8_t> m_mixed;
  std::vector<std::vector<double>> m_crossings;
};

}  // namespace lentray::core
