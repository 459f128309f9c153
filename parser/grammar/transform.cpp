#include "parser/grammar/transform.h"

#include <memory>
#include <optional>
#include <utility>

#include "parser/descriptions/interior.h"
#include "parser/descriptions/texture.h"
#include "parser/interpreter/parser.h"
#include "parser/stock/history.h"

namespace lentray::parser {

namespace {

void move(ObjectDesc& object, const TransformStep& step);

Ref<ObjectDesc> moved(const Ref<ObjectDesc>& object, const TransformStep& step) {
  auto copy = std::make_shared<ObjectDesc>(*object);
  note_step(*copy, {}, step);
  move(*copy, step);
  return copy;
}

void move(ObjectDesc& object, const TransformStep& step) {
  const core::Transform& transform = step.transform;
  if (object.texture && !object.uv_mapping && !object.texture_waits) {
    object.texture_waits = object.transform->is_identity() && can_wait(*object.texture);
    if (!object.texture_waits) object.texture = transformed(std::move(object.texture), transform);
  }
  object.transform.edit().add(transform);
  if (!object.rare.is_stored()) return;
  RareParts& rare = object.rare.edit();
  if (!object.uv_mapping && rare.interior_texture) {
    rare.interior_texture = transformed(std::move(rare.interior_texture), transform);
  }
  if (rare.interior && !rare.interior->media.empty())
    rare.interior = transformed(std::move(rare.interior), transform);
  for (Ref<ObjectDesc>& clip : rare.clipped_by) clip = moved(clip, step);
  for (Ref<ObjectDesc>& bound : rare.bounded_by) bound = moved(bound, step);
}

/// Of the next statement, if it is a transform.
TransformKind kind_of_next(Parser& parser) {
  if (parser.at(Keyword::kScale)) return TransformKind::kScale;
  return parser.at(Keyword::kMatrix) || parser.at(Keyword::kTransform) ? TransformKind::kComposed
                                                                       : TransformKind::kMove;
}

}  // namespace

void apply_transform(ObjectDesc& object, const core::Transform& transform) {
  if (transform.is_identity()) return;
  const TransformStep step = step_of(TransformKind::kUnknown, transform);
  note_step(object, {}, step);
  move(object, step);
}

bool accept_transforms(Parser& parser, ObjectDesc& object) {
  TransformKind kind = kind_of_next(parser);
  std::optional<core::Transform> next = parser.accept_transform();
  if (!next) return false;
  core::Transform all;  // history goes step by step, all the rest at once
  bool keep_balls = true;
  while (next) {
    const TransformStep step = step_of(kind, *next);
    note_step(object, all, step);
    all = all.then(*next);
    keep_balls = keep_balls && step.keeps_balls;
    kind = kind_of_next(parser);
    next = parser.accept_transform();
  }
  if (!all.is_identity()) move(object, {all, keep_balls, true});
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
