#include "parser/stock/history.h"

#include <variant>

#include "core/numeric/bounds_help.h"
#include "parser/stock/triangle_steps.h"

namespace lentray::parser {
namespace {

using core::Transform;
using Kind = PlacementStep::Kind;

/// A ball's history ends where it stops being one.
void end_ball(ObjectDesc& object, const Transform& since) {
  if (object.transform->steps.is_stored()) return;
  static const Sparse<PlacementSteps> kUnmoved{PlacementSteps{{Kind::kBefore, {}, {}}}};
  if (!object.transform.is_stored() && since.is_identity()) {
    object.transform.edit().steps = kUnmoved;
  } else {
    const Transform before = object.transform->then(since);
    object.transform.edit().steps = PlacementSteps{{Kind::kBefore, before, {}}};
  }
}

/// A box of a box is larger only where both were turned. A text was turned before it was moved at all.
void turn_box(ObjectDesc& object, const Transform& since, const Transform& step) {
  const PlacementSteps& steps = *object.transform->steps;
  if (steps.empty()) {
    const Transform before = object.transform->then(since);
    if (core::keeps_axes(before) || core::keeps_axes(step)) return;
    object.transform.edit().steps =
        PlacementSteps{{Kind::kBefore, before, {}}, {Kind::kTransform, step, {}}};
  } else if (core::keeps_axes(step)) {
    Transform& last = object.transform.edit().steps.edit().back().transform;
    last = last.then(step);
  } else {
    object.transform.edit().steps.edit().push_back({Kind::kTransform, step, {}});
  }
}

/// Of a quadric all counts from the first clip or turn on.
void turn_quadric(ObjectDesc& object, const Transform& since, const Transform& step) {
  if (object.transform->steps->empty()) {
    if (core::keeps_axes(step)) return;
    const Transform before = object.transform->then(since);
    object.transform.edit().steps.edit().push_back({Kind::kBefore, before, {}});
  }
  object.transform.edit().steps.edit().push_back({Kind::kTransform, step, {}});
}

}  // namespace

TransformStep step_of(TransformKind kind, const Transform& transform) {
  const core::Matrix& m = transform.rows();
  switch (kind) {
    case TransformKind::kMove: return {transform, true, false};
    case TransformKind::kScale: return {transform, m[0][0] == m[1][1] && m[0][0] == m[2][2], true};
    case TransformKind::kComposed: return {transform, false, false};
    case TransformKind::kUnknown: break;
  }
  return {transform, core::similarity_scale(transform) > 0.0, true};
}

void note_step(ObjectDesc& object, const Transform& since, const TransformStep& step) {
  if (object.is_any<SphereShape, SphereSweepShape>()) {
    if (!step.keeps_balls) end_ball(object, since);
  } else if (object.is_any<CsgShape, Sparse<TextShape>>()) {
    turn_box(object, since, step.transform);
  } else if (object.is_any<Sparse<QuadricShape>>()) {
    turn_quadric(object, since, step.transform);
  }
  move_triangles(object, since, step.transform, step.scales);
}

void note_clips(ObjectDesc& object) {
  if (!object.is_any<Sparse<QuadricShape>>()) return;
  const Transform so_far = *object.transform;
  object.transform.edit().steps.edit().push_back({Kind::kClips, so_far, object.rare->clipped_by});
}

}  // namespace lentray::parser
