// The geometry of a description's shape alone, as objects of the kernel without materials.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/bounds.h"
#include "core/base/transform.h"
#include "core/object/object.h"
#include "parser/descriptions/object.h"
#include "parser/shapes/text_shape.h"

namespace lentray::parser {

/// SDL's word for what a function of the shape asks for and is not evaluated yet; empty: nothing.
/// Such a function would be 0, and the shape no likeness.
std::string missing_function(const ObjectDesc& object);

/// One leaf a glyph, in the space that `to_world` leads to.
std::vector<std::unique_ptr<core::Object>> text_glyphs(TextLayout& fonts, const TextShape& text,
                                                       const core::Transform& to_world);

/// The boxes that the font gives the glyphs, in the space of the statement; empty without a glyph.
/// Throws BuildError at `where`.
core::Bounds text_box(const TextShape& text, const Location& where);

/// In the space of its statement: without material, clips and bounds, and not moved. Null if there is no
/// geometry (CSG, lights, texts) or none is rendered yet, for which `is_whole` becomes false. Throws
/// BuildError.
std::unique_ptr<core::Object> shape_geometry(const ObjectDesc& object, bool& is_whole);

}  // namespace lentray::parser
