#include "camera/lens_profiles.h"

#include <cmath>

#include "camera/text.h"

namespace lentray::camera {
namespace {

LensProfile nominal(double lpi) {
  constexpr double kPolystyrene = 1.59;
  LensProfile out;
  out.name = format(lpi) + "lpi";
  out.data.lpi = lpi;
  out.data.ior = kPolystyrene;
  const double least = kPolystyrene * (25.4 / lpi) / (2.0 * (kPolystyrene - 1.0));
  out.data.thickness = std::ceil(100.0 * least) / 100.0;
  out.nominal = true;
  out.source = "nominal: the least thickness that focuses";
  return out;
}

}  // namespace

std::vector<LensProfile> common_lens_sheets() {
  std::vector<LensProfile> out;
  for (const double lpi : {10.0, 15.0, 20.0, 30.0, 40.0, 50.0, 60.0, 62.0, 75.0}) {
    out.push_back(nominal(lpi));
  }
  LensProfile described;
  described.name = "75lpi-0.457mm";
  described.data.pitch = 0.33665;
  described.data.thickness = 0.457;
  described.data.radius = 0.1905;
  described.data.ior = 1.557;
  described.data.angle = 64.6;
  described.source = "Wikipedia, \"Lenticular optics\"";
  out.push_back(described);
  for (const double lpi : {100.0, 161.0, 200.0}) out.push_back(nominal(lpi));
  return out;
}

}  // namespace lentray::camera
