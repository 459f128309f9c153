#include "core/pattern/tiles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/tiny.h"
#include "core/noise/noise.h"

namespace lentray::core {
namespace {

class Checker final : public Pattern {
 public:
  double value(const Vec3& p) const override {
    const std::int64_t parity =
        whole_below(p.x + kTiny) ^ whole_below(p.y + kTiny) ^ whole_below(p.z + kTiny);
    return parity & 1 ? 1.0 : 0.0;
  }
};

/// A 6 x 6 grid of half triangles repeats; columns 1 and 4 are cut diagonally by edges.
class Hexagon final : public Pattern {
 public:
  double value(const Vec3& p) const override {
    constexpr double kRow = 0.866025404;  // height of the grid's rows: nine places, measured
    constexpr double kPeriod = 5.196152424;
    const double z = p.z < 0.0 ? kPeriod - std::fabs(p.z) : p.z;
    const double gx = wrap(std::fabs(p.x) / 0.5), gz = wrap(z / kRow);
    const int column = static_cast<int>(gx), row = static_cast<int>(gz);
    static constexpr char kOuter[] = {0, 1, 1, 2, 2, 0}, kInner[] = {2, 2, 0, 0, 1, 1};
    static constexpr char kBelow[] = {0, 2, 1, 0, 2, 1}, kAbove[] = {2, 1, 0, 2, 1, 0};
    if (column == 0 || column == 5) return kOuter[row];
    if (column == 2 || column == 3) return kInner[row];
    double u = gx - column;
    if ((column + row) % 2 == 1) u = 1.0 - u;
    if (u == 0.0) u = 0.0001;
    return (gz - row) / u < 1.0 ? kBelow[row] : kAbove[row];
  }

 private:
  /// From 0 on and below 6, whatever it is of.
  static double wrap(double g) {
    const double rest = g - std::floor(g / 6.0) * 6.0;
    return rest > 0.0 && rest < 6.0 ? rest : 0.0;
  }
};

class Square final : public Pattern {
 public:
  double value(const Vec3& p) const override {
    const bool odd_x = whole_below(p.x) & 1;
    const bool odd_z = whole_below(p.z) & 1;
    return odd_x ? (odd_z ? 2.0 : 3.0) : (odd_z ? 1.0 : 0.0);
  }
};

/// Unit triangles in rows of height sqrt(3)/2; six numbers around each corner.
class Triangular final : public Pattern {
 public:
  double value(const Vec3& p) const override {
    const double root3 = std::sqrt(3.0);
    const double x = p.x - 3.0 * std::floor(p.x / 3.0);
    double z = p.z - root3 * std::floor(p.z / root3);
    const double column = std::floor(x), u = x - column;
    const bool upper = z >= root3 / 2.0;
    if (upper) z = root3 - z;
    const bool right_of_left_edge = u != 0.0 && z / u < root3;
    const bool left_of_right_edge = z / (1.0 - u) < root3;
    double number = 1.0;
    if (right_of_left_edge) number = left_of_right_edge ? 0.0 : 3.0;
    number =
        number == 0.0 ? std::fmod(6.0 - 2.0 * column, 6.0) : std::fmod(number + 2.0 * column, 6.0);
    return upper ? 5.0 - number : number;
  }
};

class Cubic final : public Pattern {
 public:
  double value(const Vec3& p) const override {
    const double ax = std::fabs(p.x), ay = std::fabs(p.y), az = std::fabs(p.z);
    if (p.x >= 0 && ax >= ay && ax >= az) return 0.0;
    if (p.y >= 0 && ay >= ax && ay >= az) return 1.0;
    if (p.z >= 0 && az >= ax && az >= ay) return 2.0;
    if (p.x < 0 && ax >= ay && ax >= az) return 3.0;
    if (p.y < 0 && ay >= ax && ay >= az) return 4.0;
    return 5.0;
  }
};

/// Courses of bricks; every second course is shifted by half a brick in x and z.
class Brick final : public Pattern {
 public:
  Brick(const Vec3& size, double mortar) : m_size(size), m_shift(kTiny + mortar) {
    m_gap = {mortar / size.x, mortar / size.y, mortar / size.z};
  }
  double value(const Vec3& p) const override {
    const double x = (p.x + m_shift) / m_size.x;
    const double y = (p.y + m_shift) / m_size.y;
    const double z = (p.z + m_shift) / m_size.z;
    if (part(y) <= m_gap.y) return 0.0;
    const bool odd_course = part(y * 0.5) <= 0.5;
    if (part(odd_course ? x : x + 0.5) <= m_gap.x) return 0.0;
    return part(odd_course ? z + 0.5 : z) <= m_gap.z ? 0.0 : 1.0;
  }

 private:
  static double part(double v) {
    const double rest = v - std::trunc(v);
    return rest < 0.0 ? rest + 1.0 : rest;
  }
  Vec3 m_size, m_gap;
  double m_shift;
};

class Cells final : public Pattern {
 public:
  double value(const Vec3& p) const override {
    const auto cell = [](double v) { return static_cast<int>(whole_below(v + kTiny)); };
    return std::min(lattice_random(lattice_hash(cell(p.x), cell(p.y), cell(p.z))), 1.0);
  }
};

}  // namespace

PatternPtr make_checker() { return std::make_unique<Checker>(); }
PatternPtr make_hexagon() { return std::make_unique<Hexagon>(); }
PatternPtr make_square() { return std::make_unique<Square>(); }
PatternPtr make_triangular() { return std::make_unique<Triangular>(); }
PatternPtr make_cubic() { return std::make_unique<Cubic>(); }
PatternPtr make_brick(const Vec3& size, double mortar) {
  return std::make_unique<Brick>(size, mortar);
}
PatternPtr make_cells() { return std::make_unique<Cells>(); }

}  // namespace lentray::core
