// Plans on the grid of whole numbers: squares, rectangles of two squares, and trapezoids.
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/pattern/tile_plans.h"

namespace lentray::core {
namespace {

Tile rectangle(int level, double x, double z, double width, double height) {
  return {level, {{x, z}, {x + width, z}, {x + width, z + height}, {x, z + height}}};
}
Tile square(int level, double x, double z) { return rectangle(level, x, z, 1, 1); }
Tile lying(int level, double x, double z) { return rectangle(level, x, z, 2, 1); }
Tile standing(int level, double x, double z) { return rectangle(level, x, z, 1, 2); }

/// Around a square, each along one of its sides.
std::vector<Tile> pinwheel() {
  return {square(0, 1, 1), lying(1, 1, 0), lying(1, 0, 2), standing(2, 0, 0), standing(2, 2, 1)};
}

/// Pinwheels that turn one way and the other, mirrored at x = 3 and z = 3.
TilePlan mirrored_pinwheels() {
  TilePlan plan{{6, 0}, {0, 6}, 3};
  for (const double x_sense : {-1.0, 1.0}) {
    for (const double z_sense : {-1.0, 1.0}) {
      for (Tile tile : pinwheel()) {
        for (PlanePoint& c : tile.corners) c = {3 + x_sense * c.x, 3 + z_sense * c.z};
        plan.tiles.push_back(tile);
      }
    }
  }
  return plan;
}

/// The frame between two squares, one in the other, mitred and with its outer sides shared: four
/// trapezoids. Levels are those of the square and of the frame's right, left, far and near part.
TilePlan mitred(int levels, int inner, int right, int left, int far, int near) {
  // Twice the inner side is the period, and half the inner square's diagonal is 1.
  const double half = std::sqrt(0.5), outer = std::sqrt(2.0);
  TilePlan plan{{2 * outer, 0}, {0, 2 * outer}, levels, half / 2};
  plan.tiles = {
      rectangle(inner, -half, -half, outer, outer),
      {far, {{-half, half}, {-outer, outer}, {outer, outer}, {half, half}}},
      {near, {{-half, -half}, {-outer, -outer}, {outer, -outer}, {half, -half}}},
      {right, {{half, -half}, {outer, -outer}, {outer, outer}, {half, half}}},
      {left, {{-half, -half}, {-outer, -outer}, {-outer, outer}, {-half, half}}},
  };
  plan.edges_by_order = true;
  for (Tile& tile : plan.tiles) {
    for (PlanePoint& corner : tile.corners) corner = {corner.x + outer, corner.z + outer};
  }
  return plan;
}

}  // namespace

TilePlan plan_of_squares(int number) {
  switch (number) {
    case 1: return {{1, 0}, {0, 1}, 1, .5, {square(0, 0, 0)}};
    case 6: return {{1, 1}, {4, 0}, 2, .5, {lying(0, 1, 0), standing(1, 0, 0)}};
    case 10: return {{1, 0}, {.5, 1}, 1, .5, {square(0, 0, 0)}};
    case 11: return {{3, 0}, {0, 3}, 3, .5, pinwheel()};
    case 12: return mirrored_pinwheels();
    case 13: return mitred(3, 0, 2, 2, 1, 1);
    case 14: return mitred(5, 4, 0, 1, 3, 2);
    case 15: return {{2, 1}, {-1, 2}, 2, .5, {square(0, 0, 0), rectangle(1, 1, -1, 2, 2)}};
    case 18:
      return {{2, 2},
              {4, 0},
              2,
              .5,
              {standing(1, 0, 0), standing(1, 1, 0), lying(0, 2, 0), lying(0, 2, 1)}};
    default: throw std::invalid_argument("no tiling of squares: " + std::to_string(number));
  }
}

}  // namespace lentray::core
