// One production a shape: called behind the opening brace, reads up to the modifiers.
// Source: reference manual 3.7, "Finite Solid Primitives", "Finite Patch Primitives",
// "Infinite Solid Primitives", "Constructive Solid Geometry".
#pragma once

#include "parser/descriptions/object.h"
#include "parser/grammar/context.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

ShapeDesc parse_sphere(Parser& parser, Context& context);
ShapeDesc parse_box(Parser& parser, Context& context);
ShapeDesc parse_plane(Parser& parser, Context& context);
ShapeDesc parse_cylinder(Parser& parser, Context& context);
ShapeDesc parse_cone(Parser& parser, Context& context);
ShapeDesc parse_torus(Parser& parser, Context& context);
ShapeDesc parse_disc(Parser& parser, Context& context);
ShapeDesc parse_triangle(Parser& parser, Context& context);
ShapeDesc parse_smooth_triangle(Parser& parser, Context& context);
ShapeDesc parse_polygon(Parser& parser, Context& context);
ShapeDesc parse_quadric(Parser& parser, Context& context);
ShapeDesc parse_mesh(Parser& parser, Context& context);
ShapeDesc parse_mesh2(Parser& parser, Context& context);
ShapeDesc parse_csg(Parser& parser, Context& context, CsgOperation operation);

/// It has no inside: triangles, bicubic patches, parametrics, meshes without an inside_vector,
/// lights, and any CSG that holds one of these.
bool is_patch(const ObjectDesc& object);

ShapeDesc parse_bicubic_patch(Parser& parser, Context& context);
ShapeDesc parse_blob(Parser& parser, Context& context);
ShapeDesc parse_height_field(Parser& parser, Context& context);
ShapeDesc parse_isosurface(Parser& parser, Context& context);
ShapeDesc parse_julia_fractal(Parser& parser, Context& context);
ShapeDesc parse_lathe(Parser& parser, Context& context);
ShapeDesc parse_ovus(Parser& parser, Context& context);
ShapeDesc parse_parametric(Parser& parser, Context& context);
ShapeDesc parse_poly(Parser& parser, Context& context, int order);  ///< 0: the text gives it
ShapeDesc parse_polynomial(Parser& parser, Context& context);
ShapeDesc parse_prism(Parser& parser, Context& context);
ShapeDesc parse_sor(Parser& parser, Context& context);
ShapeDesc parse_sphere_sweep(Parser& parser, Context& context);
ShapeDesc parse_superellipsoid(Parser& parser, Context& context);
ShapeDesc parse_text(Parser& parser, Context& context);

}  // namespace lentray::parser
