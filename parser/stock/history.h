// The order in which an object was placed and clipped, kept as far as stock's boxes depend on it: a ball stays a
// ball until it is stretched, the box of a turned CSG or text is turned again, a quadric's box is found when it is clipped.
// Nothing is kept of objects with a usual history. Geometry comes later, see stock_box.h.
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
  bool scales;       ///< lengths are to be worked out anew
};
TransformStep step_of(TransformKind kind, const core::Transform& transform);

/// To be called for each step before it is added to the object's transform. `since`: what came in between and is not
/// yet in that. Triangles in the object change at once (triangle_steps.h).
void note_step(ObjectDesc& object, const core::Transform& since, const TransformStep& step);

/// To be called for a `clipped_by` once the object has it.
void note_clips(ObjectDesc& object);

}  // namespace lentray::parser
