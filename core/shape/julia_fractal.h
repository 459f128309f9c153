// julia_fractal: the points of three dimensions whose four-dimensional number, iterated by
// f(q) + parameter, stays within a sphere for so many rounds; quaternions or hypercomplex numbers.
// Found by walking along the ray in steps of the distance that the orbit lets expect, at least
// 1/precision, and halving the step that entered (or left) the set. This loses what is thinner than a
// step and where the estimate errs; scenes are tuned to it.
// Space: object. Throws std::invalid_argument for a function that quaternions do not have.
// Source: reference manual 3.7, "Julia Fractal"; Hart, Sandin, Kauffman, "Ray Tracing Deterministic
// 3-D Fractals", 1989; compared with stock by tests/image/julia_test.cpp.
#pragma once

#include <array>
#include <memory>

#include "core/shape/shape.h"

namespace lentray::core {

enum class JuliaFunction {
  kSqr,
  kCube,
  kReciprocal,
  kExp,
  kLn,
  kSin,
  kAsin,
  kCos,
  kAcos,
  kTan,
  kAtan,
  kSinh,
  kAsinh,
  kCosh,
  kAcosh,
  kTanh,
  kAtanh,
  kPwr,
};

struct JuliaSettings {
  bool hypercomplex = false;  ///< else quaternions, which have kSqr and kCube only
  JuliaFunction function = JuliaFunction::kSqr;
  std::array<double, 4> parameter{1, 0, 0, 0};
  std::array<double, 4> slice{0, 0, 0, 1};  ///< normal of the space cut out; the last is not 0
  double slice_distance = 0.0;              ///< in lengths of the unit normal
  double precision = 20.0;                  ///< 1 / the least step
  int max_iteration = 20;                   ///< at least 1
  Vec2 exponent;                            ///< of kPwr: real and imaginary part
  friend bool operator==(const JuliaSettings&, const JuliaSettings&) = default;
};

/// Radius of the sphere about the origin that orbits must stay in.
double julia_sphere(const std::array<double, 4>& parameter, bool hypercomplex);

std::unique_ptr<Shape> make_julia_fractal(const JuliaSettings& settings);

}  // namespace lentray::core
