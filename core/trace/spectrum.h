// Dispersion: light in bands of wavelengths, each refracted by its own ior. Wavelengths in nm. Pure
// functions.
// Source: reference manual 3.7, "Dispersion"; bands and hues measured on stock
// (tests/image/dispersion_test.cpp).
#pragma once

#include "core/base/color.h"

namespace lentray::core {

/// The middle of one of so many equal bands of the visible light, violet first.
double band_wavelength(int band, int bands);
/// What the band looks like; the mean over all bands is white.
Rgb band_hue(int band, int bands);
/// `dispersion`: the ior of violet over that of red.
double dispersed_ior(double ior, double dispersion, double wavelength);

}  // namespace lentray::core
