#include "core/pattern/tiles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/tiny.h"
#include "core/noise/noise.h"

namespace lentray::core {
namespace {

/// From 0 on and below 6, whatever it is of.
double within_six(double g) {
  const double rest = g - std::floor(g / 6.0) * 6.0;
  return rest > 0.0 && rest < 6.0 ? rest : 0.0;
}

}  // namespace

PatternPtr make_checker() {
  return pattern_of([](const Vec3& p) {
    const std::int64_t parity =
        whole_below(p.x + kTiny) ^ whole_below(p.y + kTiny) ^ whole_below(p.z + kTiny);
    return parity & 1 ? 1.0 : 0.0;
  });
}

/// A 6 x 6 grid of half triangles repeats; columns 1 and 4 are cut diagonally by edges.
PatternPtr make_hexagon() {
  return pattern_of([](const Vec3& p) -> double {
    constexpr double kRow = 0.866025404;  // height of the grid's rows: nine places, measured
    constexpr double kPeriod = 5.196152424;
    const double z = p.z < 0.0 ? kPeriod - std::fabs(p.z) : p.z;
    const double gx = within_six(std::fabs(p.x) / 0.5), gz = within_six(z / kRow);
    const int column = static_cast<int>(gx), row = static_cast<int>(gz);
    static constexpr char kOuter[] = {0, 1, 1, 2, 2, 0}, kInner[] = {2, 2, 0, 0, 1, 1};
    static constexpr char kBelow[] = {0, 2, 1, 0, 2, 1}, kAbove[] = {2, 1, 0, 2, 1, 0};
    if (column == 0 || column == 5) return kOuter[row];
    if (column == 2 || column == 3) return kInner[row];
    double u = gx - column;
    if ((column + row) % 2 == 1) u = 1.0 - u;
    if (u == 0.0) u = 0.0001;
    return (gz - row) / u < 1.0 ? kBelow[row] : kAbove[row];
  });
}

PatternPtr make_square() {
  return pattern_of([](const Vec3& p) {
    const bool odd_x = whole_below(p.x) & 1;
    const bool odd_z = whole_below(p.z) & 1;
    return odd_x ? (odd_z ? 2.0 : 3.0) : (odd_z ? 1.0 : 0.0);
  });
}

/// Unit triangles in rows of height sqrt(3)/2; six numbers around each corner.
PatternPtr make_triangular() {
  return pattern_of([](const Vec3& p) {
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
  });
}

PatternPtr make_cubic() {
  return pattern_of([](const Vec3& p) {
    const double ax = std::fabs(p.x), ay = std::fabs(p.y), az = std::fabs(p.z);
    if (p.x >= 0 && ax >= ay && ax >= az) return 0.0;
    if (p.y >= 0 && ay >= ax && ay >= az) return 1.0;
    if (p.z >= 0 && az >= ax && az >= ay) return 2.0;
    if (p.x < 0 && ax >= ay && ax >= az) return 3.0;
    if (p.y < 0 && ay >= ax && ay >= az) return 4.0;
    return 5.0;
  });
}

/// Courses of bricks; every second course is shifted by half a brick in x and z.
PatternPtr make_brick(const Vec3& size, double mortar) {
  const auto part = [](double v) {
    const double rest = v - std::trunc(v);
    return rest < 0.0 ? rest + 1.0 : rest;
  };
  const Vec3 gap{mortar / size.x, mortar / size.y, mortar / size.z};
  return pattern_of([part, size, gap, shift = kTiny + mortar](const Vec3& p) {
    const double x = (p.x + shift) / size.x;
    const double y = (p.y + shift) / size.y;
    const double z = (p.z + shift) / size.z;
    if (part(y) <= gap.y) return 0.0;
    const bool odd_course = part(y * 0.5) <= 0.5;
    if (part(odd_course ? x : x + 0.5) <= gap.x) return 0.0;
    return part(odd_course ? z + 0.5 : z) <= gap.z ? 0.0 : 1.0;
  });
}

PatternPtr make_cells() {
  return pattern_of([](const Vec3& p) {
    const auto cell = [](double v) { return static_cast<int>(whole_below(v + kTiny)); };
    return std::min(cell_randoms(cell(p.x), cell(p.y), cell(p.z)).x, 1.0);
  });
}

}  // namespace lentray::core
