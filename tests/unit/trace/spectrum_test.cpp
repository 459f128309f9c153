// Dispersion: what bands of light look like, and how they are refracted.
#include "core/trace/spectrum.h"

#include <gtest/gtest.h>

#include "core/trace/refraction.h"

namespace lentray::core::test {
namespace {

TEST(UnitSpectrum, AllBandsTogetherAreWhite) {
  for (const int bands : {1, 2, 7, 50}) {
    Rgb sum;
    for (int band = 0; band < bands; ++band) sum += band_hue(band, bands);
    // What lies beyond 380 and 730 nm is lost, as in stock.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / bands, 1.0, 0.008) << bands << " " << c;
  }
}

TEST(UnitSpectrum, HuesGoFromBlueThroughGreenToRed) {
  const Rgb blue = band_hue(1, 7), green = band_hue(3, 7), red = band_hue(6, 7);
  EXPECT_GT(blue.b, blue.r);
  EXPECT_GT(green.g, green.r);
  EXPECT_GT(green.g, green.b);
  EXPECT_EQ(red.g, 0.0f);
  EXPECT_GT(red.r, 0.0f);
}

TEST(UnitSpectrum, DispersionIsTheRatioOfTheEnds) {
  EXPECT_NEAR(dispersed_ior(1.5, 1.1, 380.0) / dispersed_ior(1.5, 1.1, 730.0), 1.1, 1e-12);
  EXPECT_EQ(dispersed_ior(1.5, 1.1, 555.0), 1.5);
  EXPECT_EQ(band_wavelength(0, 1), 555.0);
}

TEST(UnitSpectrum, SurfacesBendByWhatLiesOnBothSides) {
  Interior glass, core;
  glass.ior = 1.5;
  glass.dispersion = 1.1;
  core.ior = 1.2;
  core.dispersion = 1.3;
  core.dispersion_samples = 12;
  const InteriorEntry outer{2, &glass, true}, inner{4, &core, true};
  InteriorTable table;
  InteriorsId stack = InteriorsId::kOpen;
  Bend bend = enter(outer, 1.0, table, stack);
  EXPECT_DOUBLE_EQ(bend.dispersion, 1.0 / 1.1);
  EXPECT_EQ(bend.bands, 7);
  bend = enter(inner, 1.0, table, stack);
  EXPECT_DOUBLE_EQ(bend.dispersion, 1.1 / 1.3);
  EXPECT_EQ(bend.bands, 12);
  bend = enter(inner, 1.0, table, stack);
  EXPECT_DOUBLE_EQ(bend.dispersion, 1.3 / 1.1);
  bend = enter(outer, 1.0, table, stack);
  EXPECT_DOUBLE_EQ(bend.dispersion, 1.1);
  EXPECT_EQ(stack, InteriorsId::kOpen);
}

}  // namespace
}  // namespace lentray::core::test
