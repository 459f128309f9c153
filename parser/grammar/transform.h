// Transforms of descriptions: an object takes its material, clips and bounds along, as in stock.
#pragma once

#include "core/base/transform.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

class Parser;

/// Moves everything the object has been given so far: shape, textures, interior, clips, bounds.
/// Textures stay where uv_mapping holds them to the surface.
void apply_transform(ObjectDesc& object, const core::Transform& transform);

/// The same with all transforms that are written next; false if none is.
bool accept_transforms(Parser& parser, ObjectDesc& object);

/// A moved copy; the same object if the transform is the identity.
Ref<ObjectDesc> transformed(const Ref<ObjectDesc>& object, const core::Transform& transform);

}  // namespace lentray::parser
