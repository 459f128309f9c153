// Escape-time fractals in the x-y plane: mandel, julia and the magnet pair.
// Source: reference manual 3.7, "Mandel", "Julia", "Magnet"; exterior and interior types there.
#pragma once

#include "core/base/vec3.h"
#include "core/pattern/pattern.h"

namespace lentray::core {

struct Fractal {
  bool julia = false;  ///< the point is where the orbit starts; else it is the parameter
  Vec2 parameter;      ///< of julia
  int magnet = 0;      ///< 0: powers; 1, 2: magnetic renormalisation
  int exponent = 2;
  int iterations = 1;
  int exterior_type = 1, interior_type = 0;
  double exterior_factor = 1.0, interior_factor = 1.0;
};
PatternPtr make_fractal(const Fractal& fractal);

}  // namespace lentray::core
