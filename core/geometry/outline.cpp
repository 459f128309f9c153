#include "core/geometry/outline.h"

#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/processor.h"
#include "core/geometry/bounds_help.h"
#include "core/geometry/roots.h"

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
constexpr float kWaySlack = 1e-4f;   ///< of a square: by how much ways may be off

double along(const Vec2& p, double a, double b, double c) { return a * p.u + b * p.v + c; }

}  // namespace

Vec2 CurvePiece::at(double s) const {
  return {((a.u * s + b.u) * s + c.u) * s + d.u, ((a.v * s + b.v) * s + c.v) * s + d.v};
}

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
  double turns[3];
  int pieces = 0;
  // Where the slope's coefficients in Bernstein's form have one sign, it has no root; theirs is sure.
  constexpr double kRounding = 1e-12;
  const double middle = f[2] + f[1], last = 3.0 * f[0] + 2.0 * f[1] + f[2];
  const double sure = kRounding * (std::fabs(f[0]) + std::fabs(f[1]) + std::fabs(f[2]));
  const bool rises = f[2] > sure && middle > sure && last > sure;
  const bool falls = f[2] < -sure && middle < -sure && last < -sure;
  if (!rises && !falls && (f[0] != 0.0 || f[1] != 0.0)) {
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
    const double value =
        i + 1 == pieces ? along(piece.end, a, b, c) : ((f[0] * to + f[1]) * to + f[2]) * to + f[3];
    if ((value > 0.0) != (before > 0.0)) s[count++] = root_between(f, from, to, before, value);
    before = value;
    from = to;
  }
  return count;
}

Outline::Outline(std::vector<CurvePiece> pieces) : m_pieces(std::move(pieces)) {
  m_lo = {kInf, kInf};
  m_hi = {-kInf, -kInf};
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
  m_side = static_cast<int>(std::clamp<std::size_t>(kLeast + m_pieces.size(), kLeast, kMostSquares));
  const double width = m_hi.u - m_lo.u, height = m_hi.v - m_lo.v;
  m_columns_per_u = m_side / width;
  m_rows_per_v = m_side / height;
  m_mixed.fill(~0u);
  m_inside.fill(0);
  m_words = (m_pieces.size() + 63) / 64;
  // Neither numbers so close together that rounding would matter nor infinite ones.
  const double far = std::max({std::fabs(m_lo.u), std::fabs(m_lo.v), std::fabs(m_hi.u), std::fabs(m_hi.v)});
  constexpr double kCoarse = 1e-6;
  if (!(std::min(width, height) > kCoarse * far && std::isfinite(far))) {
    m_side = 1;
    m_columns_per_u = m_rows_per_v = 0.0;
    m_in_rows.assign(m_words, ~std::uint64_t{0});
    if (m_pieces.size() % 64 != 0) m_in_rows.back() >>= 64 - m_pieces.size() % 64;
    m_in_columns = m_in_rows;
    return;
  }
  m_mixed.fill(0);
  m_in_rows.assign(m_words * static_cast<std::size_t>(m_side), 0);
  m_in_columns = m_in_rows;
  for (std::size_t i = 0; i < m_pieces.size(); ++i) mark(i);
  for (int row = 0; row < m_side; ++row) {
    const auto r = static_cast<std::size_t>(row);
    bool known = false, inside = false;
    for (int column = 0; column < m_side; ++column) {
      const std::uint32_t bit = 1u << column;
      if (m_mixed[r] & bit) {
        known = false;
        continue;
      }
      if (!known) inside = contains_counted(m_lo.u + (column + 0.5) / m_columns_per_u, m_lo.v + (row + 0.5) / m_rows_per_v);
      known = true;
      if (inside) m_inside[r] |= bit;
    }
  }
}

/// In parts between the turns of the curve and a few more places: each part lies in the box of its
/// ends.
void Outline::mark(std::size_t index) {
  constexpr int kMostParts = 16;
  const CurvePiece& piece = m_pieces[index];
  const Box& box = m_boxes[index];
  const double squares = std::max((box.hi.u - box.lo.u) * m_columns_per_u, (box.hi.v - box.lo.v) * m_rows_per_v);
  const int parts = static_cast<int>(std::clamp(squares * 2.0, 1.0, static_cast<double>(kMostParts)));
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
    mark(index, Box{{std::min(from.u, to.u), std::min(from.v, to.v)}, {std::max(from.u, to.u), std::max(from.v, to.v)}});
    from = to;
  }
}

void Outline::mark(std::size_t index, const Box& box) {
  const double by_u = kMarkSlack / m_columns_per_u, by_v = kMarkSlack / m_rows_per_v;
  const int first_column = column_of(box.lo.u - by_u), last_column = column_of(box.hi.u + by_u);
  const int first_row = row_of(box.lo.v - by_v), last_row = row_of(box.hi.v + by_v);
  const std::uint32_t columns = (2u << last_column) - (1u << first_column);
  const std::size_t word = index / 64;
  const std::uint64_t bit = std::uint64_t{1} << index % 64;
  for (int row = first_row; row <= last_row; ++row) {
    m_mixed[static_cast<std::size_t>(row)] |= columns;
    m_in_rows[static_cast<std::size_t>(row) * m_words + word] |= bit;
  }
  for (int column = first_column; column <= last_column; ++column) {
    m_in_columns[static_cast<std::size_t>(column) * m_words + word] |= bit;
  }
}

/// What is said of squares holds a little beyond them too, as far as pieces were marked.
Outline::Walk Outline::walk(const Way& way, bool portable) const {
  constexpr double kLeastRise = 0.1;  // of a row: where floats tell the columns well enough
  Walk walk;
  const Box& region = way.region;
  if (!region.meets({m_lo, m_hi})) return walk;
  Rows rows{row_of(region.lo.v), row_of(region.hi.v)};
  const int first_column = column_of(region.lo.u), last_column = column_of(region.hi.u);
  const double slack = way.slack * std::max(m_columns_per_u, m_rows_per_v);
  const bool is_exact = way.is_known && slack < kWaySlack;
  const double du = (way.end.u - way.begin.u) * m_columns_per_u, dv = (way.end.v - way.begin.v) * m_rows_per_v;
  if (is_exact && rows.first != rows.last && first_column != last_column && std::fabs(dv) > kLeastRise) {
    const Vec2& low = dv > 0.0 ? way.begin : way.end;
    rows.begin = static_cast<float>(rows.first - (low.v - m_lo.v) * m_rows_per_v);
    rows.rise = static_cast<float>(std::fabs(dv));
    rows.column = static_cast<float>((low.u - m_lo.u) * m_columns_per_u);
    rows.columns_a_row = static_cast<float>(du / dv);
    walk.is_sure = true;
    !portable && has_avx2() ? meet_avx2(rows, walk) : meet_portable(rows, walk);
    return walk;
  }
  walk.is_sure = is_exact && (rows.first == rows.last || first_column == last_column);
  for (int row = rows.first; row <= rows.last; ++row) meet(row, (2u << last_column) - (1u << first_column), walk);
  return walk;
}

void Outline::meet(int row, std::uint32_t columns, Walk& walk) const {
  const std::uint32_t mixed = m_mixed[static_cast<std::size_t>(row)] & columns;
  walk.columns |= mixed;
  walk.rows |= static_cast<std::uint32_t>(mixed != 0) << row;
  walk.meets_inside = walk.meets_inside || (m_inside[static_cast<std::size_t>(row)] & columns) != 0;
}

void Outline::meet_portable(const Rows& rows, Walk& walk) const {
  const auto last_square = static_cast<float>(m_side - 1);
  const auto column_at = [&](float at) { return rows.column + std::clamp(at, 0.0f, rows.rise) * rows.columns_a_row; };
  const auto square = [&](float at) { return static_cast<int>(std::clamp(at, 0.0f, last_square)); };
  for (int row = rows.first; row <= rows.last; ++row) {
    const float at = rows.begin + static_cast<float>(row - rows.first);
    const float a = column_at(at), b = column_at(at + 1.0f);
    meet(row, (2u << square(std::max(a, b) + kWaySlack)) - (1u << square(std::min(a, b) - kWaySlack)), walk);
  }
}

/// Eight rows at once.
LENTRAY_AVX2 void Outline::meet_avx2(const Rows& rows, Walk& walk) const {
  const __m256 zero = _mm256_setzero_ps(), slack = _mm256_set1_ps(kWaySlack);
  const __m256 last_square = _mm256_set1_ps(static_cast<float>(m_side - 1)), rise = _mm256_set1_ps(rows.rise);
  const __m256i steps = _mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0);
  const auto column_at = [&](__m256 at) LENTRAY_AVX2 {
    const __m256 along = _mm256_min_ps(_mm256_max_ps(at, zero), rise);
    return _mm256_add_ps(_mm256_set1_ps(rows.column), _mm256_mul_ps(along, _mm256_set1_ps(rows.columns_a_row)));
  };
  const auto square = [&](__m256 at) LENTRAY_AVX2 {
    return _mm256_cvttps_epi32(_mm256_min_ps(_mm256_max_ps(at, zero), last_square));
  };
  const auto those = [&](__m256i columns, const std::uint32_t* of) LENTRAY_AVX2 {
    return _mm256_and_si256(columns, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(of)));
  };
  __m256i mixed_columns = _mm256_setzero_si256(), inside = mixed_columns;
  for (int row = rows.first; row <= rows.last; row += 8) {
    const __m256i step = _mm256_add_epi32(steps, _mm256_set1_epi32(row - rows.first));
    const __m256 at = _mm256_add_ps(_mm256_set1_ps(rows.begin), _mm256_cvtepi32_ps(step));
    const __m256 a = column_at(at), b = column_at(_mm256_add_ps(at, _mm256_set1_ps(1.0f)));
    const __m256i first = square(_mm256_sub_ps(_mm256_min_ps(a, b), slack));
    const __m256i last = square(_mm256_add_ps(_mm256_max_ps(a, b), slack));
    __m256i columns = _mm256_sub_epi32(_mm256_sllv_epi32(_mm256_set1_epi32(2), last),
                                       _mm256_sllv_epi32(_mm256_set1_epi32(1), first));
    columns = _mm256_andnot_si256(_mm256_cmpgt_epi32(step, _mm256_set1_epi32(rows.last - rows.first)), columns);
    const __m256i mixed = those(columns, m_mixed.data() + row);
    mixed_columns = _mm256_or_si256(mixed_columns, mixed);
    inside = _mm256_or_si256(inside, those(columns, m_inside.data() + row));
    const int none = _mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpeq_epi32(mixed, _mm256_setzero_si256())));
    walk.rows |= static_cast<std::uint32_t>(~none & 0xFF) << row;
  }
  walk.meets_inside = _mm256_testz_si256(inside, inside) == 0;
  __m128i four = _mm_or_si128(_mm256_castsi256_si128(mixed_columns), _mm256_extracti128_si256(mixed_columns, 1));
  four = _mm_or_si128(four, _mm_unpackhi_epi64(four, four));
  walk.columns = static_cast<std::uint32_t>(_mm_cvtsi128_si32(four) | _mm_extract_epi32(four, 1));
}

Outline::Box Outline::box_of(const CurvePiece& piece) {
  Box box{{std::min(piece.d.u, piece.end.u), std::min(piece.d.v, piece.end.v)},
          {std::max(piece.d.u, piece.end.u), std::max(piece.d.v, piece.end.v)}};
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
  const double box_u = n.u * (n.u > 0.0 ? m_hi.u : m_lo.u), box_v = n.v * (n.v > 0.0 ? m_hi.v : m_lo.v);
  const double size_u = std::fabs(n.u) * (m_hi.u - m_lo.u), size_v = std::fabs(n.v) * (m_hi.v - m_lo.v);
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

void Outline::drop_boxes() {
  m_lo = {-kInf, -kInf};
  m_hi = {kInf, kInf};
  m_boxes.assign(m_boxes.size(), {m_lo, m_hi});
  fill_squares();
}

bool Outline::contains(double u, double v) const {
  if (!(u >= m_lo.u && u <= m_hi.u && v >= m_lo.v && v <= m_hi.v)) return false;
  const auto row = static_cast<std::size_t>(row_of(v));
  const std::uint32_t bit = 1u << column_of(u);
  return m_mixed[row] & bit ? contains_counted(u, v) : (m_inside[row] & bit) != 0;
}

bool Outline::contains_counted(double u, double v) const {
  bool inside = false;
  const auto count = [&](std::size_t i) {
    const Box& box = m_boxes[i];
    if (v < box.lo.v || v > box.hi.v || u > box.hi.u) return;
    if (u < box.lo.u) {  // all of it is beyond: how often it crosses follows from its ends
      if ((m_pieces[i].d.v > v) != (m_pieces[i].end.v > v)) inside = !inside;
      return;
    }
    double s[3];
    const int n = line_crossings(m_pieces[i], 0.0, 1.0, -v, s);
    for (int k = 0; k < n; ++k) {
      if (m_pieces[i].at(s[k]).u > u) inside = !inside;
    }
  };
  const std::uint64_t* const in_row = &m_in_rows[static_cast<std::size_t>(row_of(v)) * m_words];
  for (std::size_t word = 0; word < m_words; ++word) {
    for (std::uint64_t bits = in_row[word]; bits != 0; bits &= bits - 1) {
      count(64 * word + static_cast<std::size_t>(std::countr_zero(bits)));
    }
  }
  return inside;
}

}  // namespace lentray::core
