// One production a shape, as shapes.def lists them: called behind the opening brace, reads up to the
// modifiers.
// Source: reference manual 3.7, "Finite Solid Primitives", "Finite Patch Primitives",
// "Infinite Solid Primitives", "Constructive Solid Geometry".
#pragma once

#include "parser/descriptions/object.h"
#include "parser/grammar/context.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

#define LENTRAY_SHAPE(keyword, production) ShapeDesc production(Parser& parser, Context& context);
#define LENTRAY_CSG(keyword, operation)
#include "parser/grammar/shapes.def"
#undef LENTRAY_SHAPE
#undef LENTRAY_CSG

ShapeDesc parse_csg(Parser& parser, Context& context, CsgOperation operation);

/// It has no inside: triangles, bicubic patches, parametrics, meshes without an inside_vector,
/// lights, and any CSG that holds one of these.
bool is_patch(const ObjectDesc& object);

}  // namespace lentray::parser
