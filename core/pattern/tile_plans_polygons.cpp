// Plans of regular polygons with sides of length 1, and of lozenges.
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/pattern/tile_plans.h"

namespace lentray::core {
namespace {

const double kRoot2 = std::sqrt(2.0), kRoot3 = std::sqrt(3.0);
const double kHeight = kRoot3 / 2;       // of a triangle; from middle to edge in a hexagon
const double kToMiddle = kRoot3 / 6;     // from a triangle's edge to its middle
const double kHalfSquare = 0.5;          // from a square's edge to its middle
const double kHalfLozenge = kRoot3 / 4;  // from a lozenge's edge to its middle

PlanePoint direction(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

/// Left of its first side, which goes from a corner in that direction.
Tile polygon(int level, int sides, PlanePoint corner, double degrees) {
  Tile tile{level, {}};
  for (int i = 0; i < sides; ++i) {
    tile.corners.push_back(corner);
    const PlanePoint side = direction(degrees + 360.0 * i / sides);
    corner = {corner.x + side.x, corner.z + side.z};
  }
  return tile;
}

/// Upright and hanging triangles have their lower left and upper right corner there.
Tile upright(int level, PlanePoint corner) { return polygon(level, 3, corner, 0); }
Tile hanging(int level, PlanePoint corner) { return polygon(level, 3, corner, 180); }
Tile hexagon(int level, PlanePoint corner) { return polygon(level, 6, corner, 0); }
/// The sides from its corner go in these directions.
Tile lozenge(int level, PlanePoint corner, double degrees, double other) {
  const PlanePoint a = direction(degrees), b = direction(other);
  return {level,
          {corner,
           {corner.x + a.x, corner.z + a.z},
           {corner.x + a.x + b.x, corner.z + a.z + b.z},
           {corner.x + b.x, corner.z + b.z}}};
}

Tile turned(Tile tile, int level, PlanePoint middle, double degrees) {
  tile.level = level;
  const PlanePoint turn = direction(degrees);
  for (PlanePoint& corner : tile.corners) {
    const double x = corner.x - middle.x, z = corner.z - middle.z;
    corner = {middle.x + turn.x * x - turn.z * z, middle.z + turn.z * x + turn.x * z};
  }
  return tile;
}

TilePlan octagons_and_squares() {
  const double period = 1 + kRoot2;
  return {{period, 0},
          {0, period},
          2,
          kHalfSquare,
          {polygon(0, 4, {period / 2, period / 2 - kRoot2 / 2}, 45),
           polygon(1, 8, {-.5, -period / 2}, 0)}};
}

TilePlan rows_of_squares_and_triangles() {
  return {{1, 0},
          {.5, 1 + kHeight},
          3,
          kToMiddle,
          {polygon(2, 4, {0, 0}, 0), upright(0, {0, 1}), hanging(1, {.5, 1 + kHeight})},
          true};
}

/// Each with four squares and triangles at a hexagon's corner. Levels: of a square over the hexagon
/// and those that follow around it, of the triangle left of it and the one right.
TilePlan hexagons_squares_and_triangles(int levels, int hexagons, const int (&squares)[3], int left,
                                        int right) {
  TilePlan plan{{1.5 + kHeight, .5 + kHeight}, {0, 1 + kRoot3}, levels, kToMiddle};
  const PlanePoint middle{.5 + kHeight, .5 + kHeight};
  const Tile square = polygon(0, 4, {kHeight, -.5}, 0);
  plan.tiles = {hexagon(hexagons, {kHeight, .5}), polygon(left, 3, {kHeight, -.5}, 90),
                polygon(right, 3, {1 + kHeight, .5}, 270)};
  for (int i = 0; i < 3; ++i) plan.tiles.push_back(turned(square, squares[i], middle, 60.0 * i));
  return plan;
}

/// Hexagons ringed by triangles, in either handedness: rows shift by half a unit to one side.
TilePlan hexagons_ringed(double sense) {
  TilePlan plan{{2.5, sense * kHeight}, {sense * .5, 3 * kHeight}, 3, kToMiddle};
  const PlanePoint middle{1, kRoot3};
  plan.tiles = {hexagon(2, {.5, kHeight})};
  const Tile below = hanging(1, {1.5, kHeight});
  for (int i = 0; i < 6; ++i) plan.tiles.push_back(turned(below, 1 - i % 2, middle, 60.0 * i));
  // The two that touch hexagons at corners only.
  const Tile loose = sense < 0 ? hanging(1, {2.5, kHeight}) : upright(0, {1, 0});
  plan.tiles.push_back(loose);
  plan.tiles.push_back(turned(loose, 1 - loose.level, middle, 180));
  return plan;
}

/// Pairs of triangles, lying and standing in turn, between squares.
TilePlan snub_squares() {
  const double half = .5 + kHeight;
  TilePlan plan{{2 * half, 0}, {0, 2 * half}, 6, kToMiddle};
  const auto pairs = [&](PlanePoint middle, double degrees, int one, int other) {
    const Tile pair = polygon(one, 3, {middle.x, middle.z + .5}, 270);
    plan.tiles.push_back(turned(pair, one, middle, degrees));
    plan.tiles.push_back(turned(pair, other, middle, degrees + 180));
  };
  pairs({0, 0}, 0, 0, 2);
  pairs({half, half}, 0, 0, 2);
  pairs({half, 0}, 90, 3, 1);
  pairs({0, half}, 90, 3, 1);
  for (const Tile& square : {polygon(4, 4, {kHeight, 0}, 60), polygon(5, 4, {-kHeight, 0}, 30)}) {
    plan.tiles.push_back(square);
    plan.tiles.push_back(turned(square, square.level, {0, 0}, 180));
  }
  return plan;
}

/// The dodecagon's sides that run along an axis, but for the upper one, have a wider bevel.
TilePlan dodecagons_and_triangles() {
  Tile dodecagon = polygon(2, 12, {.5 + kHeight, 0}, 0);
  dodecagon.bevels.assign(12, kToMiddle);
  for (const int side : {0, 3, 9}) dodecagon.bevels[side] = 1.0 / 3.0;
  return {{2 + kRoot3, 0},
          {1 + kHeight, 1.5 + kRoot3},
          3,
          kToMiddle,
          {dodecagon, upright(0, {-.5, .5}), hanging(1, {.5, 1.5 + kRoot3})}};
}

/// Levels: of a hexagon, of the square at the dodecagon's left and those that follow around it, of
/// the dodecagon.
TilePlan dodecagons_and_hexagons(int levels, const int (&squares)[3], int dodecagons) {
  TilePlan plan{{3 + kRoot3, 0}, {1.5 + kHeight, 1.5 + 1.5 * kRoot3}, levels, kHalfSquare};
  const PlanePoint middle{1.5 + kHeight, 1 + kRoot3};
  const Tile square = polygon(0, 4, {-.5, .5 + kRoot3}, 0);
  plan.tiles = {polygon(dodecagons, 12, {1 + kHeight, kHeight}, 0),
                hexagon(0, {1 + kHeight, -kHeight}), hexagon(0, {-.5, .5})};
  for (int i = 0; i < 3; ++i) plan.tiles.push_back(turned(square, squares[i], middle, 60.0 * i));
  return plan;
}

}  // namespace

TilePlan plan_of_polygons(int number) {
  const PlanePoint origin{0, 0}, unit{1, 0}, slanted{.5, kHeight};
  switch (number) {
    case 2: return {{1.5, kHeight}, {0, kRoot3}, 1, kHeight, {hexagon(0, origin)}};
    case 3: return {unit, slanted, 2, kToMiddle, {upright(0, origin), hanging(1, slanted)}};
    case 4: return {unit, slanted, 1, kHalfLozenge, {lozenge(0, origin, 0, 60)}};
    case 5:
      return {
          {1.5, kHeight},
          {0, kRoot3},
          3,
          kHalfLozenge,
          {lozenge(0, origin, 0, 60), lozenge(1, origin, 60, 120), lozenge(2, origin, 120, 180)}};
    case 7: return octagons_and_squares();
    case 8: return rows_of_squares_and_triangles();
    case 9:
      return {{2, 0},
              {1, kRoot3},
              3,
              kToMiddle,
              {hexagon(2, origin), upright(0, {-1, 0}), hanging(1, {0, kRoot3})}};
    case 16: return hexagons_squares_and_triangles(3, 2, {0, 0, 0}, 1, 1);
    case 17: return hexagons_squares_and_triangles(6, 5, {0, 2, 1}, 4, 3);
    case 19: return hexagons_ringed(-1);
    case 20: return hexagons_ringed(1);
    case 21: return snub_squares();
    case 22: return dodecagons_and_triangles();
    case 23: return dodecagons_and_hexagons(3, {1, 1, 1}, 2);
    case 24: return dodecagons_and_hexagons(5, {1, 2, 3}, 4);
    default: throw std::invalid_argument("there is no tiling " + std::to_string(number));
  }
}

}  // namespace lentray::core
