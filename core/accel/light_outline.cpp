#include "core/accel/light_outline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lentray::core {
namespace {

constexpr double kSlack = LightWindow::kSlack;
constexpr double kCellSlack = 1e-3;    ///< in cells
constexpr double kDepthSlack = 1e-6;   ///< relative, of w
constexpr double kLeastSlope = 1e-4;   ///< a flat object seen more edge-on covers nothing for sure
constexpr double kLeastSphere = 1e-6;  ///< seen smaller, its outline is lost in rounding

double lower(double w) { return w - kDepthSlack * std::fabs(w); }
double upper(double w) { return w + kDepthSlack * std::fabs(w); }

}  // namespace

LightOutline::Range LightOutline::range_of(const LightWindow& window) const {
  Range r{{0, 0}, {-1, -1}, window.is_empty()};
  for (int a = 0; a < 2 && !r.empty; ++a) {
    const double first = m_raster.in_cells(a, window.lo[a] - kSlack) - kCellSlack;
    const double last = m_raster.in_cells(a, window.hi[a] + kSlack) + kCellSlack;
    const double limit = m_raster.size(a);
    r.first[a] = static_cast<int>(std::clamp(std::floor(first), 0.0, limit));
    r.last[a] = static_cast<int>(std::clamp(std::floor(last), -1.0, limit - 1.0));
    r.empty = r.first[a] > r.last[a];
  }
  return r;
}

LightOutline::Point LightOutline::point_of(const Vec3& v) const {
  const double over_w = 1.0 / w_of(v);
  return {m_raster.in_cells(0, v[m_raster.axis(0)] * over_w),
          m_raster.in_cells(1, v[m_raster.axis(1)] * over_w)};
}

double LightOutline::slack(int side) const { return kSlack * m_raster.per_cell(side) + kCellSlack; }

template <class Visit>
void LightOutline::along(Point a, Point b, const Range& range, Visit&& visit) const {
  if (b.y < a.y) std::swap(a, b);
  const double across = slack(0), up = slack(1);
  const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0.0;
  const auto row_of = [&](double y) {
    return static_cast<int>(std::clamp(std::floor(y), range.first[1] - 1.0, range.last[1] + 1.0));
  };
  const int from = std::max(range.first[1], row_of(a.y - up));
  const int to = std::min(range.last[1], row_of(b.y + up));
  for (int row = from; row <= to; ++row) {
    // The part of the line in this row.
    const double ya = std::max(a.y, row - up), yb = std::min(b.y, row + 1.0 + up);
    double xa = b.y > a.y ? a.x + (ya - a.y) * slope : a.x;
    double xb = b.y > a.y ? a.x + (yb - a.y) * slope : b.x;
    if (xb < xa) std::swap(xa, xb);
    visit(row, std::max(xa, std::min(a.x, b.x)) - across,
          std::min(xb, std::max(a.x, b.x)) + across);
  }
}

void LightOutline::clear_rows(const Range& range) {
  m_rows.assign(static_cast<std::size_t>(range.last[1] - range.first[1] + 1),
                {Bounds::kInf, -Bounds::kInf});
}

void LightOutline::widen_row(const Range& range, int row, double least, double most) {
  Span& span = m_rows[static_cast<std::size_t>(row - range.first[1])];
  span.lo = std::min(span.lo, least);
  span.hi = std::max(span.hi, most);
}

void LightOutline::fill_rows(const Range& range, double near_w, std::vector<LightCell>& out) const {
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const int row = range.first[1] + static_cast<int>(i);
    const Span& span = m_rows[i];
    if (!(span.lo <= span.hi)) continue;
    const int from = static_cast<int>(std::max(std::floor(span.lo), 1.0 * range.first[0]));
    const int to = static_cast<int>(std::min(std::floor(span.hi), 1.0 * range.last[0]));
    for (int column = from; column <= to; ++column) out.push_back({cell(column, row), near_w});
  }
}

void LightOutline::all(const Range& r, double near_w, std::vector<LightCell>& out) const {
  for (int row = r.first[1]; row <= r.last[1]; ++row) {
    for (int column = r.first[0]; column <= r.last[0]; ++column) {
      out.push_back({cell(column, row), near_w});
    }
  }
}

void LightOutline::box(const Bounds& box, const LightWindow& window, std::vector<LightCell>& out) {
  const Range r = range_of(window);
  if (r.empty) return;
  const int axis = m_raster.face() / 2;
  const double near_w = lower(std::max(m_raster.face() & 1 ? -box.hi[axis] : box.lo[axis], 0.0));
  all(r, near_w, out);
}

/// m_points into m_hull: the corners of their convex hull in turn.
void LightOutline::turn_into_hull() {
  std::sort(m_points.begin(), m_points.end(),
            [](const Point& a, const Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  const auto turns_left = [](const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0.0;
  };
  m_hull.clear();
  for (const bool back : {false, true}) {
    const std::size_t start = m_hull.size();
    for (const Point& p : m_points) {
      while (m_hull.size() >= start + 2 &&
             !turns_left(m_hull[m_hull.size() - 2], m_hull.back(), p)) {
        m_hull.pop_back();
      }
      m_hull.push_back(p);
    }
    m_hull.pop_back();
    if (!back) std::reverse(m_points.begin(), m_points.end());
  }
  if (m_hull.empty()) m_hull.push_back(m_points.front());  // all in one place
}

void LightOutline::hull(std::span<const Vec3> points, const Bounds& in, const LightWindow& window,
                        std::vector<LightCell>& out) {
  double w0 = Bounds::kInf, far = 0.0;
  for (const Vec3& p : points) {
    w0 = std::min(w0, w_of(p));
    far = std::max({far, std::fabs(p[m_raster.axis(0)]), std::fabs(p[m_raster.axis(1)])});
  }
  const Range r = range_of(window);
  if (r.empty) return;
  if (is_small(r) || points.empty() || !(w0 > 1e-3 * far) || !(w0 > 0.0))
    return box(in, window, out);
  m_points.clear();
  for (const Vec3& p : points) m_points.push_back(point_of(p));
  turn_into_hull();
  clear_rows(r);
  for (std::size_t i = 0; i < m_hull.size(); ++i) {
    along(m_hull[i], m_hull[(i + 1) % m_hull.size()], r,
          [&](int row, double least, double most) { widen_row(r, row, least, most); });
  }
  const int axis = m_raster.face() / 2;
  const double box_w = m_raster.face() & 1 ? -in.hi[axis] : in.lo[axis];
  fill_rows(r, lower(std::max(w0, box_w)), out);
}

// A direction (u, v, 1) meets the sphere if it lies in the cone that touches it, an ellipse in u and
// v: (cw + cu u + cv v)^2 >= T (1 + u^2 + v^2), T the square of the tangent's length.
void LightOutline::sphere(const Vec3& centre, double radius, const LightWindow& window,
                          std::vector<LightCell>& out) {
  const double cw = w_of(centre), cu = centre[m_raster.axis(0)], cv = centre[m_raster.axis(1)];
  const double radius2 = radius * radius, distance2 = dot(centre, centre);
  const double tangent2 = distance2 - radius2;
  if (!(cw > 1.001 * radius) || !(radius2 > kLeastSphere * kLeastSphere * distance2)) {
    return box({centre - Vec3(radius), centre + Vec3(radius)}, window, out);
  }
  // Its ends in u and in v, and the v of the former.
  const double over = 1.0 / ((cw - radius) * (cw + radius));
  const double du = radius * std::sqrt(cw * cw + cu * cu - radius2);
  const double dv = radius * std::sqrt(cw * cw + cv * cv - radius2);
  const double u[2] = {(cu * cw - du) * over, (cu * cw + du) * over};
  LightWindow exact{{u[0], (cv * cw - dv) * over}, {u[1], (cv * cw + dv) * over}};
  exact.cut(-1.0 - kSlack, 1.0 + kSlack);
  const Range r = range_of(exact);
  if (r.empty) return;
  const double near_w = lower(cw - radius);
  if (is_small(r)) return all(r, near_w, out);
  const double v_turn = cv / (tangent2 - cv * cv);
  const double v[2] = {v_turn * (cw + cu * u[0]), v_turn * (cw + cu * u[1])};

  const double a = cu * cu - tangent2, over_a = 1.0 / a;
  const auto span_at = [&](double at) -> Span {
    const double straight = cw + cv * at, b = cu * straight;
    const double c = straight * straight - tangent2 * (1.0 + at * at);
    const double root2 = b * b - a * c;
    if (!(root2 > 0.0)) return {Bounds::kInf, -Bounds::kInf};
    const double root = std::sqrt(root2);
    return {(root - b) * over_a, (-root - b) * over_a};  // a < 0
  };
  const double across = slack(0), up = slack(1);
  const double least_along[2] = {cu < 0.0 ? 1.0 + kCellSlack : -kCellSlack,
                                 cv < 0.0 ? 1.0 + kCellSlack : -kCellSlack};
  for (int row = r.first[1]; row <= r.last[1]; ++row) {
    const double low = m_raster.place(1, row - up), high = m_raster.place(1, row + 1 + up);
    const Span below = span_at(low), above = span_at(high);
    Span outer{std::min(below.lo, above.lo), std::max(below.hi, above.hi)};
    for (int end = 0; end < 2; ++end) {
      if (!(v[end] >= low && v[end] <= high)) continue;
      outer.lo = std::min(outer.lo, u[end]);
      outer.hi = std::max(outer.hi, u[end]);
    }
    if (!(outer.lo <= outer.hi)) continue;
    const double inner[2] = {m_raster.in_cells(0, std::max(below.lo, above.lo)) + across,
                             m_raster.in_cells(0, std::min(below.hi, above.hi)) - across};
    const double least = std::floor(m_raster.in_cells(0, outer.lo) - across);
    const double most = std::floor(m_raster.in_cells(0, outer.hi) + across);
    const int from = static_cast<int>(std::max(least, 1.0 * r.first[0]));
    const int to = static_cast<int>(std::min(most, 1.0 * r.last[0]));
    for (int column = from; column <= to; ++column) {
      LightCell& reached = out.emplace_back(LightCell{cell(column, row), near_w});
      if (!(column >= inner[0] && column + 1.0 <= inner[1])) continue;
      // Dark beyond the plane of the circle where the cone touches.
      const double along = cw + cu * m_raster.place(0, column + least_along[0]) +
                           cv * m_raster.place(1, row + least_along[1]);
      if (along > 0.0) reached.full_w = upper(tangent2 / along);
    }
  }
}

/// Range of w of the plane over a cell: 1 / w is linear in u and v, so the corners have it.
void LightOutline::depths(const Vec3& normal, double offset, bool inside, int column, int row,
                          LightCell& cell) const {
  const double u[2] = {m_raster.place(0, column - kCellSlack),
                       m_raster.place(0, column + 1.0 + kCellSlack)};
  const double v[2] = {m_raster.place(1, row - kCellSlack),
                       m_raster.place(1, row + 1.0 + kCellSlack)};
  const double along = w_of(normal), across = normal[m_raster.axis(0)],
               up = normal[m_raster.axis(1)];
  // Of the plane to the directions of the corners, positive where they meet it.
  const double sign = offset < 0.0 ? -1.0 : 1.0;
  const double at[2] = {sign * (along + across * u[0]), sign * (along + across * u[1])};
  const double more[2] = {sign * up * v[0], sign * up * v[1]};
  const double least = std::min(at[0], at[1]) + std::min(more[0], more[1]);
  const double most = std::max(at[0], at[1]) + std::max(more[0], more[1]);
  if (!(offset != 0.0 && least > 0.0)) {  // the plane's horizon crosses the cell
    cell.near_w = 0.0;
    cell.full_w = Bounds::kInf;
    return;
  }
  const double away = std::fabs(offset);
  cell.near_w = lower(away / most);
  constexpr double kLongest = 1.7320509;  // of a direction on the face
  cell.full_w =
      inside && least > kLeastSlope * kLongest * 1.01 ? upper(away / least) : Bounds::kInf;
}

void LightOutline::flat(std::span<const Vec3> ends, const Vec3& normal, double offset,
                        std::vector<LightCell>& out) {
  Bounds around;
  for (const Vec3& p : ends) around.include(p);
  const int axis = m_raster.face() / 2;
  const double w0 = m_raster.face() & 1 ? -around.hi[axis] : around.lo[axis];
  const double w1 = m_raster.face() & 1 ? -around.lo[axis] : around.hi[axis];
  double far = 0.0;
  for (int a = 0; a < 2; ++a) {
    const int side = m_raster.axis(a);
    far = std::max({far, std::fabs(around.lo[side]), std::fabs(around.hi[side])});
  }
  if (!(w1 > 0.0)) return;
  const LightWindow window = window_of(around, m_raster.face());
  if (!(w0 > 1e-3 * far) || !(w0 > 0.0)) return box(around, window, out);
  const Range r = range_of(window);
  if (r.empty) return;

  const int width = r.last[0] - r.first[0] + 1, height = r.last[1] - r.first[1] + 1;
  if (width == 1 || height == 1) return all(r, lower(w0), out);
  if (width < 3 || height < 3) {  // too narrow for a cell without an edge
    clear_rows(r);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      along(point_of(ends[i]), point_of(ends[i + 1]), r,
            [&](int row, double least, double most) { widen_row(r, row, least, most); });
    }
    return fill_rows(r, lower(w0), out);
  }
  m_mixed.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  if (m_crossings.size() < static_cast<std::size_t>(height)) {
    m_crossings.resize(static_cast<std::size_t>(height));
  }
  for (int i = 0; i < height; ++i) m_crossings[static_cast<std::size_t>(i)].clear();
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    Point a = point_of(ends[i]), b = point_of(ends[i + 1]);
    if (b.y < a.y) std::swap(a, b);
    along(a, b, r, [&](int row, double least, double most) {
      const int from = static_cast<int>(std::max(std::floor(least), 1.0 * r.first[0])) - r.first[0];
      const int to = static_cast<int>(std::min(std::floor(most), 1.0 * r.last[0])) - r.first[0];
      const auto at = static_cast<std::size_t>(row - r.first[1]);
      std::uint8_t* mixed = m_mixed.data() + at * static_cast<std::size_t>(width);
      for (int column = from; column <= to; ++column) mixed[column] = 1;
      const double middle = row + 0.5;
      if (!(a.y <= middle && middle < b.y)) return;
      m_crossings[at].push_back(a.x + (middle - a.y) * ((b.x - a.x) / (b.y - a.y)));
    });
  }
  for (int row = 0; row < height; ++row) {
    std::vector<double>& across = m_crossings[static_cast<std::size_t>(row)];
    std::sort(across.begin(), across.end());
    std::size_t passed = 0;
    const std::uint8_t* mixed =
        m_mixed.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width);
    for (int column = 0; column < width; ++column) {
      const double middle = r.first[0] + column + 0.5;
      while (passed < across.size() && across[passed] < middle) ++passed;
      const bool inside = !mixed[column] && (passed & 1) != 0;
      if (!mixed[column] && !inside) continue;
      const int x = column + r.first[0], y = row + r.first[1];
      LightCell reached{cell(x, y)};
      depths(normal, offset, inside, x, y, reached);
      reached.near_w = std::max(reached.near_w, lower(w0));
      out.push_back(reached);
    }
  }
}

}  // namespace lentray::core
