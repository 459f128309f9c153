// The order of an object's transforms and clips, as far as POV-Ray's bounding box depends on it. A sphere has the box of
// a sphere until it is stretched. The box of a rotated CSG or text is rotated again. A quadric's box is computed when
// the quadric is clipped. Most objects need no record. stock_box.h computes the boxes.
// Source: measured on stock (tests/compat/language/objects.cases, extents.cases). Errors: none. One thread.
#pragma once

#include "core/base/transform.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// How a transform was written.
enum class TransformKind {
  kMove,  ///< translate or rotate
  kScale,
  kComposed,  ///< matrix or transform
  kUnknown,   ///< several in one, or none that was written
};

/// A transform, borrowed, and what follows from how it was written.
struct TransformStep {
  const core::Transform& transform;
  bool keeps_balls;  ///< translate, rotate, or scale alike along all axes
  bool scales;       ///< lengths must be computed anew
};
TransformStep step_of(TransformKind kind, const core::Transform& transform);

/// To be called for each step before it is added to the object's transform. `since`: earlier steps that are not yet in
/// the object's transform. Triangles in the object change at once (triangle_steps.h).
void note_step(ObjectDesc& object, const core::Transform& since, const TransformStep& step);

/// To be called for a `clipped_by` once the object has it.
void note_clips(ObjectDesc& object);

}  // namespace lentray::parser
