// projected_through and area_illumination against stock.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kProjectedLightsStage = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,3,-7> look_at <0,.5,0> angle 45 }
plane { y, -1 pigment { checker rgb .9 rgb <.5,.6,.3> } }
sphere { <-1,0,0>, 1 pigment { rgb <.9,.5,.3> } finish { phong .7 } }
sphere { <1.5,.5,1>, .8 pigment { rgbf <.4,.9,.6,.7> } finish { specular .5 } }
box { <-.3,2.2,-.3>, <.3,2.4,.3> pigment { rgb 1 } }
)";

class ImageLightKinds : public ::testing::TestWithParam<const char*> {};

TEST_P(ImageLightKinds, AreStocks) {
  EXPECT_TRUE(same_as_stock({.sdl = std::string(kProjectedLightsStage) + GetParam(),
                             .width = 100,
                             .height = 75,
                             .arguments = {},
                             .files = {}}));
}

INSTANTIATE_TEST_SUITE_P(
    Projected, ImageLightKinds,
    ::testing::Values(
        "light_source { <0,6,-2>, 1.2 projected_through { disc { <0,3,-.5>, y, 1.2 } } }",
        "light_source { <0,6,-2>, 1.2 projected_through { difference { box { <-1.5,3,-1.5>, "
        "<1.5,3.1,1.5> } cylinder { 2*y, 4*y, .6 } } translate .3*x } }",
        "light_source { <0,6,-2>, 1.2 shadowless projected_through { disc { <0,2,0>, y, 1.6 } } }",
        "light_source { <0,6,-2>, 1.2 spotlight point_at 0 falloff 30 projected_through { box { "
        "<-1,1.5,-1>, <1,1.6,1> } } rotate 10*y }",
        "light_source { <0,6,-2>, 1 area_light x, z, 3, 3 projected_through { disc { <0,3,-.5>, y, "
        "1.2 } } }",
        "light_source { <0,6,-2>, .6 projected_through { disc { <0,9,-.5>, y, 9 } } }"
        "light_source { <3,6,-2>, .6 }"));

INSTANTIATE_TEST_SUITE_P(
    AreaIllumination, ImageLightKinds,
    ::testing::Values(
        "light_source { <0,4,-2>, 1 area_light 3*x, 3*z, 4, 4 area_illumination }",
        "light_source { <0,4,-2>, 1 area_light 3*x, 3*z, 5, 3 adaptive 1 circular orient "
        "area_illumination on }",
        "light_source { <0,4,-2>, 1 area_light 2*x, 2*z, 3, 3 area_illumination fade_distance 3 "
        "fade_power 2 }",
        "light_source { <0,4,-2>, 1 spotlight point_at 0 radius 15 falloff 25 area_light 2*x, 2*z, "
        "3, 3 area_illumination }",
        "light_source { <0,-.4,-3>, 1 area_light 3*x, 3*y, 4, 4 area_illumination }",
        "light_source { <0,4,-2>, 1 shadowless area_light 3*x, 3*z, 4, 4 area_illumination }"));

}  // namespace
}  // namespace lentray::test
