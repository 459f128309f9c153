#include "core/accel/test_cost.h"

#include <string_view>
#include <typeinfo>
#include <vector>

#include "core/object/leaf.h"
#include "core/object/object.h"
#include "core/shape/polygon.h"

namespace lentray::core {
namespace {

struct Row {
  std::string_view name;
  double cost;
};

constexpr double kOther = 100.0;  // solved by iteration, or by a hierarchy of its own
constexpr double kPart = 8.0;     // what CSG does about each of its parts
constexpr double kTransform = 6.0;
constexpr Row kCosts[] = {
    {"sphere", 6},
    {"triangle", 10},
    {"smooth_triangle", 10},
    {"box", 10},
    {"plane", 6},
    {"disc", 8},
    {"cylinder", 16},
    {"cone", 18},
    {"quadric", 14},
    {"torus", 80},
    {"blob", 60},
    {"ovus", 60},
    {"mesh", 60},
    {"mesh2", 60},
    {"height_field", 80},
    {"isosurface", 2000},
    {"julia_fractal", 1500},
    {"parametric", 5000},
    {"superellipsoid", 500},
    {"sphere_sweep", 400},
    {"bicubic_patch", 200},
};

double cost_of(const Leaf& leaf) {
  double cost = leaf.transform() ? kTransform : 0.0;
  const Shape& shape = leaf.shape();
  if (typeid(shape) == typeid(Polygon)) {
    return cost + 10.0 +
           0.3 * static_cast<double>(static_cast<const Polygon&>(shape).points().size());
  }
  for (const Row& row : kCosts) {
    if (row.name == leaf.name()) return cost + row.cost;
  }
  return cost + kOther;
}

}  // namespace

double test_cost(const Object& object) {
  if (typeid(object) == typeid(Leaf)) return cost_of(static_cast<const Leaf&>(object));
  std::vector<const Leaf*> leaves;
  object.leaves(leaves);
  double cost = 0.0;
  for (const Leaf* leaf : leaves) cost += cost_of(*leaf);
  if (leaves.size() > 1) cost += kPart * static_cast<double>(leaves.size());
  return cost;
}

}  // namespace lentray::core
