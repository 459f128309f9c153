#include "core/shape/outline.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/numeric/bounds_help.h"
#include "core/numeric/roots.h"

namespace lentray::core {
namespace {

/// The root of a cubic in [lo, hi], at whose ends it has values of different signs; found from where
/// a line between these has its own.
double root_between(const double f[4], double lo, double hi, double at_lo, double at_hi) {
  constexpr int kMaxSteps = 80;
  constexpr double kClose = 3e-16;  // a rounding of 1
  const bool lo_positive = at_lo > 0.0;
  double x = lo + (hi - lo) * (at_lo / (at_lo - at_hi));
  if (!(x >= lo && x <= hi)) x = 0.5 * (lo + hi);
  for (int step = 0; step < kMaxSteps && hi - lo > kClose; ++step) {
    const double y = ((f[0] * x + f[1]) * x + f[2]) * x + f[3];
    const double slope = (3.0 * f[0] * x + 2.0 * f[1]) * x + f[2];
    ((y > 0.0) == lo_positive ? lo : hi) = x;
    double next = x - y / slope;
    if (!(next >= lo && next <= hi)) next = 0.5 * (lo + hi);
    const double change = std::fabs(next - x);
    x = next;
    if (change <= kClose) break;
  }
  return x;
}

constexpr double kMarkSlack = 1e-3;  ///< of a square: far above rounding

double along(const Vec2& p, double a, double b, double c) { return a * p.u + b * p.v + c; }

/// line_crossings() of a straight or quadratic piece: a s2 + b s + c, which becomes `end`, whose sign counts.
int quadratic_crossings(double a, double b, double c, double end, double s[3]) {
  const bool begins = c > 0.0, ends = end > 0.0;
  const auto share = [](double at) { return std::clamp(at, 0.0, 1.0); };
  if (a == 0.0) {
    if (begins == ends) return 0;
    s[0] = share(c / (c - end));
    return 1;
  }
  if (begins == ends) {
    // Both ends are on one side: it turns on the other, or does not cross.
    const double middle = b + 2.0 * a;
    if ((begins ? b < 0.0 && middle > 0.0 : b > 0.0 && middle < 0.0) == false) return 0;
    if ((c - b * b / (4.0 * a) > 0.0) == begins) return 0;
  }
  const double root = std::sqrt(std::max(b * b - 4.0 * a * c, 0.0));
  /// Where it rises, or falls, through 0; without cancellation.
  const auto crossing = [&](bool rises) {
    const double slope = rises ? root : -root;
    if ((b > 0.0) != rises) return share((slope - b) / (2.0 * a));
    return c == 0.0 ? 0.0 : share(-2.0 * c / (b + slope));
  };
  s[0] = crossing(!begins);
  if (begins != ends) return 1;
  s[1] = crossing(begins);
  return 2;
}

}  // namespace

Vec2 CurvePiece::slope(double s) const {
  return {(3.0 * a.u * s + 2.0 * b.u) * s + c.u, (3.0 * a.v * s + 2.0 * b.v) * s + c.v};
}

double CurvePiece::farthest(const Vec2& n) const {
  return std::max(most_of_cubic(n.u * a.u + n.v * a.v, n.u * b.u + n.v * b.v, n.u * c.u + n.v * c.v,
                                n.u * d.u + n.v * d.v),
                  n.u * end.u + n.v * end.v);
}

CurvePiece CurvePiece::line(const Vec2& from, const Vec2& to) {
  return {{}, {}, {to.u - from.u, to.v - from.v}, from, to};
}

CurvePiece CurvePiece::conic(const Vec2& from, const Vec2& control, const Vec2& to) {
  return {{},
          {from.u - 2.0 * control.u + to.u, from.v - 2.0 * control.v + to.v},
          {2.0 * (control.u - from.u), 2.0 * (control.v - from.v)},
          from,
          to};
}

CurvePiece CurvePiece::bezier(const Vec2& from, const Vec2& control1, const Vec2& control2,
                              const Vec2& to) {
  return {{to.u - from.u + 3.0 * (control1.u - control2.u),
           to.v - from.v + 3.0 * (control1.v - control2.v)},
          {3.0 * (from.u - 2.0 * control1.u + control2.u),
           3.0 * (from.v - 2.0 * control1.v + control2.v)},
          {3.0 * (control1.u - from.u), 3.0 * (control1.v - from.v)},
          from,
          to};
}

int line_crossings(const CurvePiece& piece, double a, double b, double c, double s[3]) {
  const double f[4] = {a * piece.a.u + b * piece.a.v, a * piece.b.u + b * piece.b.v,
                       a * piece.c.u + b * piece.c.v, along(piece.d, a, b, c)};
  const double end = along(piece.end, a, b, c);
  if (f[0] == 0.0) return quadratic_crossings(f[1], f[2], f[3], end, s);
  double turns[3];
  int pieces = 0;
  // Where the slope's coefficients in Bernstein's form have one sign, it has no root; theirs is sure.
  constexpr double kRounding = 1e-12;
  const double middle = f[2] + f[1], last = 3.0 * f[0] + 2.0 * f[1] + f[2];
  const double sure = kRounding * (std::fabs(f[0]) + std::fabs(f[1]) + std::fabs(f[2]));
  const bool rises = f[2] > sure && middle > sure && last > sure;
  const bool falls = f[2] < -sure && middle < -sure && last < -sure;
  if (!rises && !falls) {
    double roots[2];
    const int n = solve_quadratic(3.0 * f[0], 2.0 * f[1], f[2], roots);
    for (int i = 0; i < n; ++i) {
      if (roots[i] > 0.0 && roots[i] < 1.0) turns[pieces++] = roots[i];
    }
  }
  turns[pieces++] = 1.0;
  int count = 0;
  double from = 0.0;
  double before = f[3];
  for (int i = 0; i < pieces; ++i) {
    const double to = turns[i];
    const double value = i + 1 == pieces ? end : ((f[0] * to + f[1]) * to + f[2]) * to + f[3];
    if ((value > 0.0) != (before > 0.0)) s[count++] = root_between(f, from, to, before, value);
    before = value;
    from = to;
  }
  return count;
}

Outline::Outline(std::vector<CurvePiece> pieces) : m_pieces(std::move(pieces)) {
  m_lo = {kInf, kInf};
  m_hi = {-kInf, -kInf};
  m_boxes.reserve(m_pieces.size());
  for (const CurvePiece& piece : m_pieces) {
    m_boxes.push_back(box_of(piece));
    m_lo = {std::min(m_lo.u, m_boxes.back().lo.u), std::min(m_lo.v, m_boxes.back().lo.v)};
    m_hi = {std::max(m_hi.u, m_boxes.back().hi.u), std::max(m_hi.v, m_boxes.back().hi.v)};
  }
  fill_squares();
}

/// Finer for more pieces. A square without pieces is inside if its middle is, and its neighbour
/// without pieces is like it.
void Outline::fill_squares() {
  constexpr std::size_t kLeast = 12;
  m_side =
      static_cast<int>(std::clamp<std::size_t>(kLeast + m_pieces.size(), kLeast, kMostSquares));
  const double width = m_hi.u - m_lo.u, height = m_hi.v - m_lo.v;
  m_columns_per_u = m_side / width;
  m_rows_per_v = m_side / height;
  m_mixed.fill(~0u);
  m_inside.fill(0);
  // Neither numbers so close together that rounding would matter nor infinite ones.
  const double far =
      std::max({std::fabs(m_lo.u), std::fabs(m_lo.v), std::fabs(m_hi.u), std::fabs(m_hi.v)});
  constexpr double kCoarse = 1e-6;
  const bool are_known = std::min(width, height) > kCoarse * far && std::isfinite(far);
  m_search.fill(m_boxes, {m_lo, m_hi}, are_known);
  if (!are_known) {
    m_side = 1;
    m_columns_per_u = m_rows_per_v = 0.0;
    return;
  }
  m_mixed.fill(0);
  for (std::size_t i = 0; i < m_pieces.size(); ++i) mark(m_pieces[i], m_boxes[i]);
  for (int row = 0; row < m_side; ++row) fill_row(row);
}

/// Runs of squares without pieces, from one to the next.
void Outline::fill_row(int row) {
  const auto r = static_cast<std::size_t>(row);
  const double v = m_lo.v + (row + 0.5) / m_rows_per_v;
  const std::uint32_t all = (2u << (m_side - 1)) - 1;
  double before = 2.0 * m_lo.u - m_hi.u;
  bool inside = false;
  for (std::uint32_t known = all & ~m_mixed[r]; known != 0;) {
    const int first = std::countr_zero(known);
    const std::uint32_t run = known & ~(known + (1u << first));
    const double u = m_lo.u + (first + 0.5) / m_columns_per_u;
    inside ^= is_odd(v, before, u);
    before = m_lo.u + (std::bit_width(run) - 0.5) / m_columns_per_u;
    if (inside) m_inside[r] |= run;
    known &= ~run;
  }
}

/// In parts between the turns of the curve and a few more places: each part lies in the box of its
/// ends. A straight piece row by row.
void Outline::mark(const CurvePiece& piece, const PlaneBox& box) {
  constexpr int kMostParts = 16;
  if (piece.is_straight()) return mark_line(piece.d, piece.end);
  const double squares =
      std::max((box.hi.u - box.lo.u) * m_columns_per_u, (box.hi.v - box.lo.v) * m_rows_per_v);
  const int parts =
      static_cast<int>(std::clamp(squares * 2.0, 1.0, static_cast<double>(kMostParts)));
  double places[kMostParts + 5];
  int count = 0;
  for (int i = 1; i < parts; ++i) places[count++] = static_cast<double>(i) / parts;
  const auto turns = [&](double a, double b, double c) {
    double roots[2];
    const int n = solve_quadratic(3.0 * a, 2.0 * b, c, roots);
    for (int i = 0; i < n; ++i) {
      if (roots[i] > 0.0 && roots[i] < 1.0) places[count++] = roots[i];
    }
  };
  turns(piece.a.u, piece.b.u, piece.c.u);
  turns(piece.a.v, piece.b.v, piece.c.v);
  std::sort(places, places + count);
  Vec2 from = piece.d;
  for (int i = 0; i <= count; ++i) {
    const Vec2 to = i < count ? piece.at(places[i]) : piece.end;
    const Vec2 a = in_squares(from), b = in_squares(to);
    const int first = square_of(std::min(a.v, b.v) - kMarkSlack),
              last = square_of(std::max(a.v, b.v) + kMarkSlack);
    for (int row = first; row <= last; ++row) mark(row, a.u, b.u);
    from = to;
  }
}

/// Each row what of the line may be in it.
void Outline::mark_line(const Vec2& from, const Vec2& to) {
  Vec2 a = in_squares(from), b = in_squares(to);
  if (a.v > b.v) std::swap(a, b);
  const bool is_level = b.v - a.v <= kMarkSlack;
  const double slope = is_level ? 0.0 : (b.u - a.u) / (b.v - a.v);
  const auto at = [&](double v) { return a.u + (std::clamp(v, a.v, b.v) - a.v) * slope; };
  const int first = square_of(a.v - kMarkSlack), last = square_of(b.v + kMarkSlack);
  for (int row = first; row <= last; ++row) {
    mark(row, at(row - kMarkSlack), is_level ? b.u : at(row + 1 + kMarkSlack));
  }
}

/// The squares of a row between two places.
void Outline::mark(int row, double u, double other_u) {
  const int first = square_of(std::min(u, other_u) - kMarkSlack),
            last = square_of(std::max(u, other_u) + kMarkSlack);
  m_mixed[static_cast<std::size_t>(row)] |= (2u << last) - (1u << first);
}

PlaneBox Outline::box_of(const CurvePiece& piece) {
  PlaneBox box{{std::min(piece.d.u, piece.end.u), std::min(piece.d.v, piece.end.v)},
               {std::max(piece.d.u, piece.end.u), std::max(piece.d.v, piece.end.v)}};
  if (piece.is_straight()) return box;
  const auto include = [&](double a, double b, double c) {
    double roots[2];
    const int n = solve_quadratic(3.0 * a, 2.0 * b, c, roots);
    for (int i = 0; i < n; ++i) {
      if (!(roots[i] > 0.0 && roots[i] < 1.0)) continue;
      const Vec2 p = piece.at(roots[i]);
      box.lo = {std::min(box.lo.u, p.u), std::min(box.lo.v, p.v)};
      box.hi = {std::max(box.hi.u, p.u), std::max(box.hi.v, p.v)};
    }
  };
  include(piece.a.u, piece.b.u, piece.c.u);
  include(piece.a.v, piece.b.v, piece.c.v);
  return box;
}

/// Pieces whose box does not reach as far as others are left out.
double Outline::farthest(const Vec2& n) const {
  constexpr double kSlack = 1e-12;
  // Along an axis, but for the rounding of turns by a right angle: as far as the box.
  const double box_u = n.u * (n.u > 0.0 ? m_hi.u : m_lo.u),
               box_v = n.v * (n.v > 0.0 ? m_hi.v : m_lo.v);
  const double size_u = std::fabs(n.u) * (m_hi.u - m_lo.u),
               size_v = std::fabs(n.v) * (m_hi.v - m_lo.v);
  if (std::min(size_u, size_v) < kSlack * std::max(size_u, size_v)) return box_u + box_v;
  double far = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < m_pieces.size(); ++i) {
    const double along_u = n.u * (n.u > 0.0 ? m_boxes[i].hi.u : m_boxes[i].lo.u);
    const double along_v = n.v * (n.v > 0.0 ? m_boxes[i].hi.v : m_boxes[i].lo.v);
    if (along_u + along_v + kSlack * (std::fabs(along_u) + std::fabs(along_v)) < far) continue;
    far = std::max(far, m_pieces[i].farthest(n));
  }
  return far;
}

/// A closed way that only ever turns to one side, and along either axis goes forth and back once.
bool Outline::is_convex() const {
  double side = 0.0;
  int turns_u = 0, turns_v = 0;
  const auto turns = [](double before, double after) { return before * after < 0.0 ? 1 : 0; };
  Vec2 last{}, last_moved{};  // slopes; of the latter each part that is not 0
  for (std::size_t i = 0; i <= m_pieces.size(); ++i) {
    const CurvePiece &piece = m_pieces[i % m_pieces.size()],
                     &next = m_pieces[(i + 1) % m_pieces.size()];
    if (!piece.is_straight() || piece.end.u != next.d.u || piece.end.v != next.d.v) return false;
    const Vec2 slope = piece.c;
    if (slope.u == 0.0 && slope.v == 0.0) continue;
    const double turn = last.u * slope.v - last.v * slope.u;
    if (turn * side < 0.0) return false;
    if (turn != 0.0) side = turn;
    turns_u += turns(last_moved.u, slope.u);
    turns_v += turns(last_moved.v, slope.v);
    if (slope.u != 0.0) last_moved.u = slope.u;
    if (slope.v != 0.0) last_moved.v = slope.v;
    last = slope;
  }
  return side != 0.0 && turns_u <= 2 && turns_v <= 2;
}

/// From the next place in the row that is known.
bool Outline::contains_counted(double u, double v) const {
  const auto row = static_cast<std::size_t>(row_of(v));
  const std::uint32_t own = 1u << column_of(u), known = ~m_mixed[row];
  const auto middle = [&](int column) { return m_lo.u + (column + 0.5) / m_columns_per_u; };
  const auto inside = [&](int column) { return (m_inside[row] >> column & 1u) != 0; };
  if (const std::uint32_t before = known & (own - 1); before != 0) {
    const int column = std::bit_width(before) - 1;
    return inside(column) != is_odd(v, middle(column), u);
  }
  const std::uint32_t after = known & ~(own | (own - 1)) & ((2u << (m_side - 1)) - 1);
  if (after == 0) return is_odd(v, u, kInf);
  const int column = std::countr_zero(after);
  return inside(column) != is_odd(v, u, middle(column));
}

bool Outline::is_odd(double v, double from, double to) const {
  bool odd = false;
  const auto look = [&](std::size_t i) {
    const PlaneBox& box = m_boxes[i];
    if (v < box.lo.v || v > box.hi.v || from > box.hi.u || to < box.lo.u) return true;
    const CurvePiece& piece = m_pieces[i];
    if (from < box.lo.u && to >= box.hi.u) {  // how often it crosses follows from its ends
      odd ^= (piece.d.v > v) != (piece.end.v > v);
      return true;
    }
    double s[3];
    const int n = line_crossings(piece, 0.0, 1.0, -v, s);
    for (int k = 0; k < n; ++k) {
      const double u = piece.at(s[k]).u;
      odd ^= u > from && u <= to;
    }
    return true;
  };
  constexpr std::size_t kFew = 8;  // to look at all costs less than to search
  if (m_pieces.size() <= kFew) {
    for (std::size_t i = 0; i < m_pieces.size(); ++i) look(i);
  } else {
    m_search.along({{from, v}, {std::min(to, m_hi.u), v}, 0.0, true}, look);
  }
  return odd;
}

}  // namespace lentray::core
