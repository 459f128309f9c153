// Triangles and smooth triangles change with each step of their transforms, not with all of them at
// once: stock keeps their corners, and works out anew what follows from them.
#pragma once

#include "core/base/transform.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// Whether the shape is a triangle, smooth or not, or CSG with one somewhere in it.
bool has_triangles(const ShapeDesc& shape);

/// Changes the object's triangles as stock's next step does: which way they point, how much their normals
/// weigh, whether they are dropped. `all`: the steps of this object that it has not been moved by yet;
/// `step`: the next one; `scale`: whether that is a `scale`. Measured: tests/image/sides_test.cpp.
void move_triangles(ObjectDesc& object, const core::Transform& all, const core::Transform& step,
                    bool scale);

}  // namespace lentray::parser
