#include "core/accel/light_raster.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lentray::core {
namespace {

constexpr double kSlack = 1e-7;      ///< in u and v: far above rounding, far below a cell
constexpr double kCellSlack = 1e-3;  ///< in cells
constexpr double kDepthSlack = 1e-6; ///< relative, of w
constexpr double kLeastSlope = 1e-4; ///< a flat object seen more edge-on covers nothing for sure

double lower(double w) { return w - kDepthSlack * std::fabs(w); }
double upper(double w) { return w + kDepthSlack * std::fabs(w); }

}  // namespace

void LightWindow::include(const LightWindow& other) {
  if (other.is_empty()) return;
  for (int a = 0; a < 2; ++a) {
    lo[a] = std::min(lo[a], other.lo[a]);
    hi[a] = std::max(hi[a], other.hi[a]);
  }
}

void LightWindow::cut(double least, double most) {
  for (int a = 0; a < 2; ++a) {
    lo[a] = std::max(lo[a], least);
    hi[a] = std::min(hi[a], most);
  }
}

LightWindow window_of(const Bounds& box, int face) {
  LightWindow window;
  const int axis = face / 2;
  const double w1 = face & 1 ? -box.lo[axis] : box.hi[axis];
  const double w0 = std::max(face & 1 ? -box.hi[axis] : box.lo[axis], 0.0);
  if (!(w1 > 0.0)) return window;
  const int along[2] = {LightFace::u_axis(face), LightFace::v_axis(face)};
  for (int a = 0; a < 2; ++a) {
    const double lo = box.lo[along[a]], hi = box.hi[along[a]];
    // A quotient by w0 = 0 is infinite, or no number where the box reaches the light.
    const double least = lo / (lo < 0.0 ? w0 : w1), most = hi / (hi > 0.0 ? w0 : w1);
    window.lo[a] = std::isnan(least) ? -Bounds::kInf : least;
    window.hi[a] = std::isnan(most) ? Bounds::kInf : most;
  }
  window.cut(-1.0 - kSlack, 1.0 + kSlack);
  return window;
}

LightRaster::LightRaster(int face, const LightWindow& window, int columns, int rows)
    : m_face(face), m_u(LightFace::u_axis(face)), m_v(LightFace::v_axis(face)) {
  const int size[2] = {columns, rows};
  for (int a = 0; a < 2; ++a) {
    m_size[a] = size[a];
    m_limit[a] = size[a];
    m_lo[a] = window.lo[a] - 2.0 * kSlack;
    m_per_cell[a] = size[a] / (window.hi[a] + 2.0 * kSlack - m_lo[a]);
  }
}

Vec3 LightRaster::direction(double x, double y) const {
  Vec3 d;
  d[m_face / 2] = m_face & 1 ? -1.0 : 1.0;
  d[m_u] = place(0, x);
  d[m_v] = place(1, y);
  return d;
}

LightRaster::Range LightRaster::range_of(const LightWindow& window) const {
  Range r{{0, 0}, {-1, -1}, window.is_empty()};
  for (int a = 0; a < 2 && !r.empty; ++a) {
    const double first = (window.lo[a] - kSlack - m_lo[a]) * m_per_cell[a] - kCellSlack;
    const double last = (window.hi[a] + kSlack - m_lo[a]) * m_per_cell[a] + kCellSlack;
    r.first[a] = static_cast<int>(std::clamp(std::floor(first), 0.0, m_limit[a]));
    r.last[a] = static_cast<int>(std::clamp(std::floor(last), -1.0, m_limit[a] - 1.0));
    r.empty = r.first[a] > r.last[a];
  }
  return r;
}

void LightRaster::box(const Bounds& box, std::vector<LightCell>& out) const {
  const Range r = range_of(window_of(box, m_face));
  if (r.empty) return;
  const int axis = m_face / 2;
  const double w0 = std::max(m_face & 1 ? -box.hi[axis] : box.lo[axis], 0.0);
  for (int row = r.first[1]; row <= r.last[1]; ++row) {
    for (int column = r.first[0]; column <= r.last[0]; ++column) {
      out.push_back({static_cast<std::uint32_t>(row * m_size[0] + column), lower(w0)});
    }
  }
}

// A direction meets the sphere if it lies in the cone that touches it.
void LightRaster::sphere(const Vec3& centre, double radius, std::vector<LightCell>& out) const {
  const Bounds around{centre - Vec3(radius), centre + Vec3(radius)};
  const Range r = range_of(window_of(around, m_face));
  if (r.empty) return;
  const double near_w = lower(std::max(LightFace::w_of(m_face, centre) - radius, 0.0));
  const double tangent2 = dot(centre, centre) - radius * radius;
  const auto polar = [&](double x, double y) {  // w of the plane of the tangent circle, or infinity
    const Vec3 d = direction(x, y);
    const double along = dot(centre, d);
    const bool in = along > 0.0 && tangent2 > 0.0 &&
                    along * along * (1.0 - 1e-6) > tangent2 * dot(d, d);
    return in ? tangent2 / along : Bounds::kInf;
  };
  // Wider than a cell, so that neighbours share no rounding.
  for (int row = r.first[1]; row <= r.last[1]; ++row) {
    for (int column = r.first[0]; column <= r.last[0]; ++column) {
      double full = 0.0;
      for (int c = 0; c < 4 && full < Bounds::kInf; ++c) {
        const double x = column + (c & 1 ? 1.0 + kCellSlack : -kCellSlack);
        const double y = row + (c & 2 ? 1.0 + kCellSlack : -kCellSlack);
        full = std::max(full, polar(x, y));
      }
      out.push_back({static_cast<std::uint32_t>(row * m_size[0] + column), near_w, upper(full)});
    }
  }
}

/// Range of w of the plane over a cell: 1 / w is linear in u and v, so the corners have it.
void LightRaster::depths(const Vec3& normal, double offset, int column, int row, bool inside,
                         LightCell& cell) const {
  double least = Bounds::kInf, most = 0.0;
  bool sure = inside;
  for (int c = 0; c < 4; ++c) {
    const double x = column + (c & 1 ? 1.0 + kCellSlack : -kCellSlack);
    const double y = row + (c & 2 ? 1.0 + kCellSlack : -kCellSlack);
    const Vec3 d = direction(x, y);
    const double slope = dot(normal, d);
    const double w = offset / slope;
    sure = sure && std::fabs(slope) > kLeastSlope * length(d);
    if (!(w > 0.0)) {  // the plane's horizon crosses the cell
      cell.near_w = 0.0;
      cell.full_w = Bounds::kInf;
      return;
    }
    least = std::min(least, w);
    most = std::max(most, w);
  }
  cell.near_w = lower(least);
  cell.full_w = sure ? upper(most) : Bounds::kInf;
}

void LightRaster::flat(std::span<const Vec3> ends, const Vec3& normal, double offset,
                       std::vector<LightCell>& out) const {
  Bounds around;
  for (const Vec3& p : ends) around.include(p);
  const int axis = m_face / 2;
  const double w0 = m_face & 1 ? -around.hi[axis] : around.lo[axis];
  const double w1 = m_face & 1 ? -around.lo[axis] : around.hi[axis];
  const double far = std::max({std::fabs(around.lo[m_u]), std::fabs(around.hi[m_u]),
                               std::fabs(around.lo[m_v]), std::fabs(around.hi[m_v])});
  if (!(w1 > 0.0)) return;
  if (!(w0 > 1e-3 * far) || !(w0 > 0.0)) return box(around, out);
  const Range r = range_of(window_of(around, m_face));
  if (r.empty) return;

  // Everything in cells from here.
  const int width = r.last[0] - r.first[0] + 1, height = r.last[1] - r.first[1] + 1;
  std::vector<std::uint8_t> mixed(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(height));
  const double slack[2] = {kSlack * m_per_cell[0] + kCellSlack, kSlack * m_per_cell[1] + kCellSlack};
  const auto flattened = [&](const Vec3& p) {
    const double w = LightFace::w_of(m_face, p);
    return std::pair((p[m_u] / w - m_lo[0]) * m_per_cell[0] - r.first[0],
                     (p[m_v] / w - m_lo[1]) * m_per_cell[1] - r.first[1]);
  };
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    auto [x0, y0] = flattened(ends[i]);
    auto [x1, y1] = flattened(ends[i + 1]);
    if (y1 < y0) {
      std::swap(x0, x1);
      std::swap(y0, y1);
    }
    const double slope = y1 > y0 ? (x1 - x0) / (y1 - y0) : 0.0;
    const int first = static_cast<int>(std::clamp(std::floor(y0 - slack[1]), 0.0, height * 1.0));
    const int last = static_cast<int>(std::clamp(std::floor(y1 + slack[1]), -1.0, height - 1.0));
    for (int row = first; row <= last; ++row) {
      // The part of the edge in this row.
      const double ya = std::max(y0, row - slack[1]), yb = std::min(y1, row + 1.0 + slack[1]);
      double xa = y1 > y0 ? x0 + (ya - y0) * slope : x0, xb = y1 > y0 ? x0 + (yb - y0) * slope : x1;
      if (xb < xa) std::swap(xa, xb);
      xa = std::max(xa, std::min(x0, x1)) - slack[0];
      xb = std::min(xb, std::max(x0, x1)) + slack[0];
      const int from = static_cast<int>(std::clamp(std::floor(xa), 0.0, width * 1.0));
      const int to = static_cast<int>(std::clamp(std::floor(xb), -1.0, width - 1.0));
      for (int column = from; column <= to; ++column) {
        mixed[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
              static_cast<std::size_t>(column)] = 1;
      }
      const double middle = row + 0.5;
      if (y0 <= middle && middle < y1) {
        crossings[static_cast<std::size_t>(row)].push_back(x0 + (middle - y0) * slope);
      }
    }
  }
  for (int row = 0; row < height; ++row) {
    std::vector<double>& across = crossings[static_cast<std::size_t>(row)];
    std::sort(across.begin(), across.end());
    std::size_t passed = 0;
    for (int column = 0; column < width; ++column) {
      while (passed < across.size() && across[passed] < column + 0.5) ++passed;
      const bool edge = mixed[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(column)] != 0;
      const bool inside = !edge && (passed & 1) != 0;
      if (!edge && !inside) continue;
      LightCell cell;
      const int x = column + r.first[0], y = row + r.first[1];
      cell.cell = static_cast<std::uint32_t>(y * m_size[0] + x);
      depths(normal, offset, x, y, inside, cell);
      cell.near_w = std::max(cell.near_w, lower(w0));
      out.push_back(cell);
    }
  }
}

}  // namespace lentray::core
