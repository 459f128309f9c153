// The box stock keeps for a quadric: found when the quadric is clipped or cut by its siblings in an
// intersection, from its equation without products of two coordinates and from what those leave.
// Some boxes are smaller than the surface, which pictures show, too. Space: the equation's.
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

/// Of the surface within `limits`, for an equation without products. Where nothing is known it is
/// `limits`.
core::Bounds quadric_box(const std::array<double, 10>& c, const core::Bounds& limits);

}  // namespace lentray::parser
