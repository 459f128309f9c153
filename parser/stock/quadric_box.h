// POV-Ray's bounding box of a quadric that is clipped or intersected. It follows from the box of the clipping objects
// and from the quadric's equation, if that has no products of two coordinates. Some boxes are smaller than the surface,
// and cut it off in pictures. Space: the equation's.
// Source: measured on stock (tests/compat/language/extents.cases). Errors: none. Threads: any.
#pragma once

#include <array>

#include "core/base/bounds.h"
#include "core/base/transform.h"

namespace lentray::parser {

/// The equation of the surface moved by the transform.
std::array<double, 10> moved_quadric(const std::array<double, 10>& c, const core::Transform& t);

bool has_products(const std::array<double, 10>& c);
/// Cones and hyperboloids of one sheet; for an equation without products.
bool is_open_all_around(const std::array<double, 10>& c);

/// The box of the surface within `limits`, for an equation without products; `limits` where none follows from it.
core::Bounds quadric_box(const std::array<double, 10>& c, const core::Bounds& limits);

}  // namespace lentray::parser
