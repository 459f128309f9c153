#include "parser/grammar/transform.h"

#include "parser/build/stock_box.h"
#include "parser/descriptions/interior.h"
#include "parser/descriptions/texture.h"
#include "parser/parser.h"

namespace lentray::parser {

namespace {

void move(ObjectDesc& object, const core::Transform& transform) {
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
  for (Ref<ObjectDesc>& clip : rare.clipped_by) clip = transformed(clip, transform);
  for (Ref<ObjectDesc>& bound : rare.bounded_by) bound = transformed(bound, transform);
}

}  // namespace

void apply_transform(ObjectDesc& object, const core::Transform& transform) {
  if (transform.is_identity()) return;
  turn_box(object, {}, transform);
  move(object, transform);
}

bool accept_transforms(Parser& parser, ObjectDesc& object) {
  auto step = parser.accept_transform();
  if (!step) return false;
  core::Transform all;  // boxes go step by step, all the rest at once
  for (; step; step = parser.accept_transform()) {
    turn_box(object, all, *step);
    all = all.then(*step);
  }
  if (!all.is_identity()) move(object, all);
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
