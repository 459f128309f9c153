// The box that min_extent() and max_extent() answer with: stock's bounding box, which scenes lean on
// where they place one object beside another. It is a box of boxes: a turned object has the box of
// its turned box, a CSG the box of its parts' boxes; what bounds or clips it lends its own box if that
// is smaller. In the space of the scene, single precision.
// Source: measured on stock (tests/compat/language/objects.cases, extents.cases).
#pragma once

#include "core/base/bounds.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// Infinite sides are at +-1e10. `is_whole` becomes false if parts have no geometry yet.
core::Bounds stock_box(const ObjectDesc& object, bool& is_whole);
/// False: what bounds or clips the object has no part in its box, which stock finds later: that of blobs,
/// height fields and julia fractals in their own braces.
bool heeds_regions(const ObjectDesc& object);

/// Stock finds a quadric's box when it is clipped and moves the box from then on: to be called when
/// the object has got a clip.
void keep_clipped_box(ObjectDesc& object);
/// Boxes of quadrics and CSG grow with every turn: to be called with each statement, and with what came since
/// the object's own transform was composed. Spheres and sphere sweeps keep their balls while statements are
/// `plain`: rotate, translate, or scale alike along all axes, not matrix or transform.
void turn_box(ObjectDesc& object, const core::Transform& since, const core::Transform& turn, bool plain);

}  // namespace lentray::parser
