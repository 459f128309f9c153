#include "parser/grammar/transform.h"

#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "core/numeric/bounds_help.h"
#include "parser/descriptions/interior.h"
#include "parser/descriptions/texture.h"
#include "parser/grammar/triangle_steps.h"
#include "parser/interpreter/parser.h"
#include "parser/stock/stock_box.h"

namespace lentray::parser {

namespace {

void move(ObjectDesc& object, const core::Transform& transform, bool plain);

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
  move_triangles(object, {}, transform, true);
  move(object, transform, plain);
}

bool accept_transforms(Parser& parser, ObjectDesc& object) {
  Step step = accept_step(parser);
  if (!step.transform) return false;
  core::Transform all;  // boxes go step by step, all the rest at once
  bool plain = true;
  for (; step.transform; step = accept_step(parser)) {
    turn_box(object, all, *step.transform, step.plain);
    move_triangles(object, all, *step.transform, step.is_scale);
    all = all.then(*step.transform);
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
