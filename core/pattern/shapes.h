// Patterns of plain formulae: distances, angles, sines and the user's own function.
// Source: reference manual 3.7, "Gradient", "Onion", "Radial", "Spherical", "Function" ...
#pragma once

#include <functional>
#include <memory>

#include "core/function/function.h"
#include "core/pattern/pattern.h"

namespace lentray::core {

PatternPtr make_gradient(const Vec3& unit_direction);
PatternPtr make_onion();
PatternPtr make_radial();
/// 1 at the centre, axis or plane, 0 at distance 1 and beyond.
PatternPtr make_spherical();
PatternPtr make_cylindrical();
PatternPtr make_planar();
PatternPtr make_boxed();
PatternPtr make_leopard();
PatternPtr make_quilted(double control0, double control1);
/// A function of x, y, z; values above 1 wrap.
PatternPtr make_function(std::shared_ptr<const Function> function);

/// 1 inside of something, 0 outside; asked by any thread.
PatternPtr make_inside(std::function<bool(const Vec3&)> inside);

/// The curve of `quilted`, from 0 at 0, shaped by two controls.
double quilt_curve(double t, double control0, double control1);
/// The point's place in its quilted cell, -1/2..1/2 each, scaled by the curve.
Vec3 quilt_offset(const Vec3& point, double control0, double control1);

}  // namespace lentray::core
