// Dispersion against stock: glass whose ior depends on the wavelength.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kDispersionStage =
    R"(#version 3.7; global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0,1.5,-5> look_at 0 angle 40 }
light_source { <4,7,-5>, 1 }
plane { y, -1 pigment { checker rgb 1 rgb .1 } finish { ambient .4 } }
plane { z, 8 pigment { gradient x color_map { [.5 rgb 1] [.5 rgb 0] } } finish { ambient 1 diffuse 0 } }
#declare Glass = texture { pigment { rgbf <.95,1,.98,.9> } finish { ambient 0 diffuse .05 reflection .05 } }
)";

class ImageDispersion : public ::testing::TestWithParam<const char*> {};

TEST_P(ImageDispersion, IsStocks) {
  EXPECT_TRUE(same_as_stock({.sdl = std::string(kDispersionStage) + GetParam(),
                             .width = 100,
                             .height = 75,
                             .arguments = {},
                             .files = {}},
                            Grade::match));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageDispersion,
    ::testing::Values("sphere { 0, 1 texture { Glass } interior { ior 1.5 dispersion 1.1 } }",
                      "sphere { 0, 1 texture { Glass } interior { ior 1.5 dispersion 1.05 "
                      "dispersion_samples 20 } }",
                      "sphere { 0, 1 texture { Glass } interior { ior 1.5 dispersion 1.3 "
                      "dispersion_samples 2 } }",
                      "sphere { 0, 1 texture { Glass } interior { dispersion 1.2 } }",
                      "box { -1, 1 rotate 40*y rotate 20*x texture { Glass } interior { ior 1.6 "
                      "dispersion 1.15 } }",
                      "sphere { 0, 1 texture { Glass } interior { ior 1.5 dispersion 1.1 } }"
                      " sphere { <.2,0,0>, .5 texture { Glass } interior { ior 1.2 dispersion .9 "
                      "dispersion_samples 9 } }",
                      "sphere { 0, 1 texture { Glass } interior { ior .8 dispersion 1.2 } }"));

}  // namespace
}  // namespace lentray::test
