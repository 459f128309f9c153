#include "parser/grammar/transform.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "core/geometry/bounds_help.h"
#include "parser/build/stock_box.h"
#include "parser/descriptions/interior.h"
#include "parser/descriptions/texture.h"
#include "parser/parser.h"

namespace lentray::parser {

namespace {

void move(ObjectDesc& object, const core::Transform& transform, bool plain);

/// The shape once more if it changes. Stock's `scale` makes the normals of smooth triangles units as they are placed
/// then; `matrix` and `transform` leave them as long as they become, and what is longer weighs more between the
/// corners. `placed`: what leads out of the object, with the scale.
std::optional<ShapeDesc> with_even_normals(const ShapeDesc& shape, const core::Transform& placed) {
  constexpr double kAsLong = 1e-12;
  if (const auto* csg = std::get_if<CsgShape>(&shape)) {
    if (!csg->has_smooth_triangles) return std::nullopt;
    std::shared_ptr<Children> children;  // large ones are shared as long as they are the same
    for (std::size_t i = 0; i < csg->children->size(); ++i) {
      const ObjectDesc& child = *(*csg->children)[i];
      auto even = with_even_normals(child.shape, child.transform->then(placed));
      if (!even) continue;
      if (!children) children = std::make_shared<Children>(*csg->children);
      auto copy = std::make_shared<ObjectDesc>(child);
      copy->shape = std::move(*even);
      (*children)[i] = std::move(copy);
    }
    if (!children) return std::nullopt;
    CsgShape changed = *csg;
    changed.children = std::move(children);
    return changed;
  }
  const auto* triangle = std::get_if<Sparse<SmoothTriangleShape>>(&shape);
  if (!triangle) return std::nullopt;
  SmoothTriangleShape even = **triangle;
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] = length(placed.normal(even.n[i]));
  const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
  if (!(*least > 0.0) || *most - *least <= kAsLong * *most) return std::nullopt;
  for (std::size_t i = 0; i < lengths.size(); ++i) even.n[i] = even.n[i] / lengths[i];
  return Sparse<SmoothTriangleShape>(even);
}

void make_normals_even(ObjectDesc& object, const core::Transform& outer) {
  if (auto even = with_even_normals(object.shape, object.transform->then(outer))) object.shape = std::move(*even);
}

Ref<ObjectDesc> moved(const Ref<ObjectDesc>& object, const core::Transform& transform, bool plain) {
  auto copy = std::make_shared<ObjectDesc>(*object);
  turn_box(*copy, {}, transform, plain);
  move(*copy, transform, plain);
  return copy;
}

void move(ObjectDesc& object, const core::Transform& transform, bool plain) {
  object.transform = object.transform->then(transform);
  if (!object.uv_mapping) {
    if (object.texture) object.texture = transformed(object.texture, transform);
  }
  if (!object.rare.is_stored()) return;
  RareParts& rare = object.rare.edit();
  if (!object.uv_mapping && rare.interior_texture) {
    rare.interior_texture = transformed(rare.interior_texture, transform);
  }
  if (rare.interior && !rare.interior->media.empty()) rare.interior = transformed(rare.interior, transform);
  for (Ref<ObjectDesc>& clip : rare.clipped_by) clip = moved(clip, transform, plain);
  for (Ref<ObjectDesc>& bound : rare.bounded_by) bound = moved(bound, transform, plain);
}

/// The next statement, if it is a transform, and whether it is plain: see turn_box().
struct Step {
  std::optional<core::Transform> transform;
  bool plain;
  bool is_scale;
};

Step accept_step(Parser& parser) {
  const bool scale = parser.at(Keyword::kScale);
  const bool composed = parser.at(Keyword::kMatrix) || parser.at(Keyword::kTransform);
  Step step{parser.accept_transform(), !composed, scale};
  if (!scale) return step;
  const core::Matrix& m = step.transform->rows();
  step.plain = m[0][0] == m[1][1] && m[0][0] == m[2][2];
  return step;
}

}  // namespace

void apply_transform(ObjectDesc& object, const core::Transform& transform) {
  if (transform.is_identity()) return;
  const bool plain = core::similarity_scale(transform) > 0.0;
  turn_box(object, {}, transform, plain);
  make_normals_even(object, transform);
  move(object, transform, plain);
}

bool accept_transforms(Parser& parser, ObjectDesc& object) {
  Step step = accept_step(parser);
  if (!step.transform) return false;
  core::Transform all;  // boxes go step by step, all the rest at once
  bool plain = true;
  for (; step.transform; step = accept_step(parser)) {
    turn_box(object, all, *step.transform, step.plain);
    all = all.then(*step.transform);
    if (step.is_scale) make_normals_even(object, all);
    plain = plain && step.plain;
  }
  if (!all.is_identity()) move(object, all, plain);
  return true;
}

Ref<ObjectDesc> transformed(const Ref<ObjectDesc>& object, const core::Transform& transform) {
  if (!object || transform.is_identity()) return object;
  auto copy = std::make_shared<ObjectDesc>(*object);
  apply_transform(*copy, transform);
  return copy;
}

void LightDesc::apply(const core::Transform& t) {
  position = t.point(position);
  point_at = t.point(point_at);
  axis1 = t.vector(axis1);
  axis2 = t.vector(axis2);
  looks_like = transformed(looks_like, t);
  projected_through = transformed(projected_through, t);
}

}  // namespace lentray::parser
