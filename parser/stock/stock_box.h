// POV-Ray's bounding box, which min_extent() and max_extent() return; scenes use it to place objects beside each other.
// A rotated object has the box of its rotated box. A CSG has the box of its parts' boxes. A smaller box of a bounding or
// clipping object replaces the object's own. World space, single precision.
// Source: measured on stock (tests/compat/language/objects.cases, extents.cases).
#pragma once

#include "core/base/bounds.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// Infinite sides are at +-1e10. `is_whole` becomes false if parts have no geometry yet.
core::Bounds stock_box(const ObjectDesc& object, bool& is_whole);
/// The same as POV-Ray stores it: the near corner and the lengths of the sides in single precision. The far corner is
/// their sum, not rounded.
core::Bounds kept_stock_box(const ObjectDesc& object, bool& is_whole);
core::Bounds kept_stock_box(const core::Bounds& box);
/// False for blobs, height fields and julia fractals: POV-Ray computes their boxes after their own braces, without
/// the objects that bound or clip them.
bool heeds_regions(const ObjectDesc& object);
/// As POV-Ray computes it: less than 0 for some boxes whose corners are swapped.
inline double volume(const core::Bounds& b) {
  const core::Vec3 size = b.hi - b.lo;
  return size.x * size.y * size.z;
}

}  // namespace lentray::parser
