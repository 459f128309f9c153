#include "core/render/interior_stack.h"

#include <cmath>

namespace lentray::core {
namespace {

constexpr double kNoDistance = 1e-10;
constexpr double kExponentialPower = 1000.0;  ///< from here on the fading is exponential

float channel(double colour, double depth, double power) {
  if (power >= kExponentialPower) return static_cast<float>(std::exp(-(1.0 - colour) * depth));
  return static_cast<float>(colour + (1.0 - colour) / (1.0 + std::pow(depth, power)));
}

}  // namespace

Rgb fade_in_interior(const Interior& interior, double depth) {
  if (std::fabs(interior.fade_distance) <= kNoDistance) return Rgb(1.0f);
  const double relative = depth / interior.fade_distance;
  const Rgb& c = interior.fade_colour;
  return {channel(c.r, relative, interior.fade_power), channel(c.g, relative, interior.fade_power),
          channel(c.b, relative, interior.fade_power)};
}

}  // namespace lentray::core
