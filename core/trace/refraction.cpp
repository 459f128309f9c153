#include "core/trace/refraction.h"

#include <algorithm>
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

Bend enter(const InteriorEntry& entry, double atmosphere_ior, InteriorTable& table,
           InteriorsId& inside) {
  const double ior = entry.ior(atmosphere_ior), dispersion = entry.dispersion();
  if (inside == InteriorsId::kOpen) {
    inside = table.push(inside, entry);
    return {atmosphere_ior / ior, 1.0 / dispersion, entry.bands()};
  }
  if (table.back(inside).key == entry.key) {
    inside = table.remove(inside, entry.key);
    if (inside == InteriorsId::kOpen) return {ior / atmosphere_ior, dispersion, entry.bands()};
    const InteriorEntry& around = table.back(inside);
    return {ior / around.ior(atmosphere_ior), dispersion / around.dispersion(),
            std::max(entry.bands(), around.bands())};
  }
  const InteriorsId left = table.remove(inside, entry.key);
  if (left != inside) {
    inside = left;
    return {};
  }
  const InteriorEntry around = table.back(inside);
  inside = table.push(inside, entry);
  return {around.ior(atmosphere_ior) / ior, around.dispersion() / dispersion, entry.bands()};
}

double relative_ior(const InteriorEntry& entry, const InteriorTable& table, InteriorsId inside,
                    double atmosphere_ior) {
  const double ior = entry.ior(atmosphere_ior);
  if (inside == InteriorsId::kOpen) return ior / atmosphere_ior;
  const double innermost = table.back(inside).ior(atmosphere_ior);
  if (!table.contains(inside, entry.key)) return ior / innermost;
  return (table.size(inside) == 1 ? atmosphere_ior : innermost) / ior;
}

Rgb fade_in_interior(const Interior& interior, double depth) {
  if (std::fabs(interior.fade_distance) <= kNoDistance) return Rgb(1.0f);
  const double relative = depth / interior.fade_distance;
  const Rgb& c = interior.fade_colour;
  return {channel(c.r, relative, interior.fade_power), channel(c.g, relative, interior.fade_power),
          channel(c.b, relative, interior.fade_power)};
}

}  // namespace lentray::core
