#include "parser/stock/triangle_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace lentray::parser {
namespace {

/// What leads out of a shape before a step of its transforms and after it.
struct Placed {
  const core::Transform &before, &after;
  bool scale;
};

/// Stock works a triangle out anew at every step, and then has its first two corners change places where
/// its normal's longest part points the wrong way: the next step's normal is that of the new order.
bool are_swapped(const std::array<Vec3, 3>& p, const core::Transform& placed) {
  const Vec3 second = placed.point(p[1]);
  const Vec3 n = cross(placed.point(p[0]) - second, placed.point(p[2]) - second);
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  if (x > y && x > z) return n.x > 0.0;
  if (x <= y && y > z) return n.y < 0.0;
  return n.z > 0.0;
}

/// Not all normals on one side of the triangle: stock drops it, for good. A normal turns with a scale another
/// way than a direction does, and may come over to the other side.
bool are_apart(const SmoothTriangleShape& triangle, const core::Transform& placed) {
  const Vec3 corner = placed.point(triangle.p[0]);
  const Vec3 face =
      cross(placed.point(triangle.p[1]) - corner, placed.point(triangle.p[2]) - corner);
  const auto side = [&](const Vec3& n) { return dot(placed.normal(n), face); };
  const auto [least, most] =
      std::minmax({side(triangle.n[0]), side(triangle.n[1]), side(triangle.n[2])});
  return !(least > 0.0 || most < 0.0);
}

/// Stock's `scale` makes the normals of smooth triangles units as they are placed then; `matrix` and
/// `transform` leave them as long as they become, and what is longer weighs more between the corners.
bool make_even(std::array<Vec3, 3>& normals, const core::Transform& placed) {
  constexpr double kAsLong = 1e-12;
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] = length(placed.normal(normals[i]));
  const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
  if (!(*least > 0.0) || *most - *least <= kAsLong * *most) return false;
  for (std::size_t i = 0; i < lengths.size(); ++i) normals[i] = normals[i] / lengths[i];
  return true;
}

/// The shape once more if the step changes the triangles in it.
std::optional<ShapeDesc> with_triangles_moved(const ShapeDesc& shape, const Placed& placed) {
  if (const auto* csg = std::get_if<CsgShape>(&shape)) {
    if (!csg->has_triangles) return std::nullopt;
    std::shared_ptr<Children> children;  // large ones are shared as long as they are the same
    for (std::size_t i = 0; i < csg->children->size(); ++i) {
      const ObjectDesc& child = *(*csg->children)[i];
      if (!has_triangles(child.shape)) continue;
      auto changed =
          with_triangles_moved(child.shape, {child.transform->then(placed.before),
                                             child.transform->then(placed.after), placed.scale});
      if (!changed) continue;
      if (!children) children = std::make_shared<Children>(*csg->children);
      auto copy = std::make_shared<ObjectDesc>(child);
      copy->shape = std::move(*changed);
      (*children)[i] = std::move(copy);
    }
    if (!children) return std::nullopt;
    CsgShape changed = *csg;
    changed.children = std::move(children);
    return changed;
  }
  if (const auto* triangle = std::get_if<TriangleShape>(&shape)) {
    if (!are_swapped(triangle->p, placed.before)) return std::nullopt;
    return TriangleShape{{triangle->p[1], triangle->p[0], triangle->p[2]}};
  }
  const auto* smooth = std::get_if<Sparse<SmoothTriangleShape>>(&shape);
  if (!smooth) return std::nullopt;
  SmoothTriangleShape changed = **smooth;
  bool other = placed.scale && make_even(changed.n, placed.after);
  if (are_apart(changed, placed.after)) {
    changed.n = {};
    other = true;
  }
  if (!other) return std::nullopt;
  return Sparse<SmoothTriangleShape>(changed);
}

}  // namespace

bool has_triangles(const ShapeDesc& shape) {
  if (const auto* csg = std::get_if<CsgShape>(&shape)) return csg->has_triangles;
  return std::holds_alternative<TriangleShape>(shape) ||
         std::holds_alternative<Sparse<SmoothTriangleShape>>(shape);
}

void move_triangles(ObjectDesc& object, const core::Transform& all, const core::Transform& step,
                    bool scale) {
  if (!has_triangles(object.shape)) return;
  const core::Transform before = object.transform->then(all);
  if (auto changed = with_triangles_moved(object.shape, {before, before.then(step), scale})) {
    object.shape = std::move(*changed);
  }
}

}  // namespace lentray::parser
