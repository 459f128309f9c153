#include "core/trace/spectrum.h"

#include <algorithm>
#include <cmath>

namespace lentray::core {
namespace {

constexpr double kViolet = 380.0, kRed = 730.0, kWidth = kRed - kViolet;

double smooth_step(double from, double to, double x) {
  const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return (3.0 - 2.0 * s) * s * s;
}

/// How much of each channel lies below a wavelength. Source: that of POV-Ray 3.7, met to 0.0006.
Rgb below(double wavelength) {
  constexpr double kRedInViolet = 0.0404;
  const double red = kRedInViolet * smooth_step(374.0, 442.0, wavelength) +
                     (1.0 - kRedInViolet) * smooth_step(569.9, 737.7, wavelength);
  return {static_cast<float>(red), static_cast<float>(smooth_step(492.6, 674.6, wavelength)),
          static_cast<float>(smooth_step(372.6, 567.9, wavelength))};
}

}  // namespace

double band_wavelength(int band, int bands) { return kViolet + kWidth * (band + 0.5) / bands; }

Rgb band_hue(int band, int bands) {
  const double half = 0.5 * kWidth / bands, middle = band_wavelength(band, bands);
  return (below(middle + half) - below(middle - half)) * static_cast<float>(bands);
}

double dispersed_ior(double ior, double dispersion, double wavelength) {
  return ior * std::pow(dispersion, (0.5 * (kViolet + kRed) - wavelength) / kWidth);
}

}  // namespace lentray::core
