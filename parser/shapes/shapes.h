// Shape descriptions -> shapes of the kernel, in the space of their statement.
#pragma once

#include <memory>

#include "core/shape/mesh.h"
#include "core/shape/shape.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// Null if this kind of shape is not rendered yet (or is no shape: CSG, light).
std::unique_ptr<core::Shape> build_shape(const ObjectDesc& object);

/// The mesh of a mesh or mesh2, textures not set; null for other shapes.
std::unique_ptr<core::Mesh> build_mesh(const ObjectDesc& object,
                                       const core::Transform& to_world = core::Transform());

}  // namespace lentray::parser
