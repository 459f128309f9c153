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
/// The same as stock keeps it: single precision of a corner and of the lengths of the sides. The
/// far corner, which is their sum, is not rounded.
core::Bounds kept_stock_box(const ObjectDesc& object, bool& is_whole);
core::Bounds kept_stock_box(const core::Bounds& box);
/// False: what bounds or clips the object has no part in its box, which stock finds later: that of blobs,
/// height fields and julia fractals in their own braces.
bool heeds_regions(const ObjectDesc& object);
/// Less than 0 for some boxes that are inside out, as stock counts.
inline double volume(const core::Bounds& b) {
  const core::Vec3 size = b.hi - b.lo;
  return size.x * size.y * size.z;
}

}  // namespace lentray::parser
