// Triangles and smooth triangles are transformed step by step: POV-Ray stores their corners, and computes normals
// and sides anew after each transform of a statement.
#pragma once

#include "core/base/transform.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// Whether the shape is a triangle, smooth or not, or CSG with one somewhere in it.
bool has_triangles(const ShapeDesc& shape);

/// Applies the next step to the object's triangles: their sides, the weights of their normals, whether they are
/// dropped. `all`: the steps of this object that are not applied yet;
/// `step`: the next one; `scale`: whether that is a `scale`. Measured: tests/image/sides_test.cpp.
void move_triangles(ObjectDesc& object, const core::Transform& all, const core::Transform& step,
                    bool scale);

}  // namespace lentray::parser
