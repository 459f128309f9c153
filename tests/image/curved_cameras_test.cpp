// Cameras whose picture is not flat, against stock, in frames that are neither unit nor centred.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

class ImageCurvedCameras : public ::testing::TestWithParam<const char*> {};

TEST_P(ImageCurvedCameras, SeeWhatStockSees) {
  const std::string sdl = std::string("#version 3.7; global_settings { assumed_gamma 1 }\n") +
                          "camera { " + GetParam() + " }\n" + R"(
light_source { <1,2,-1>, 1 }
box { <-6,-2,-6>, <6,4,6> pigment { checker rgb <.9,.8,.3> rgb <.2,.3,.7> scale .7 } }
sphere { <0,0,3>, .8 pigment { rgb <.9,.2,.2> } }
cylinder { <2,-2,1>, <2,3,1>, .3 pigment { rgb <.2,.9,.2> } }
)";
  EXPECT_TRUE(
      same_as_stock({.sdl = sdl, .width = 120, .height = 90, .arguments = {}, .files = {}}));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageCurvedCameras,
    ::testing::Values(
        "fisheye angle 200 location <.2,.3,-1> look_at <.5,.2,3>",
        "fisheye right 1.2*x up .8*y angle 120", "ultra_wide_angle angle 140 look_at <1,.3,3>",
        "ultra_wide_angle right 1.6*x up .7*y angle 90 rotate 20*z",
        "omnimax right 4/3*x look_at <0,1,2>", "omnimax right x*1.1 up y look_at <0,1,2>",
        "omnimax right .8*x up y look_at <0,1,2>", "panoramic look_at <1,.5,3>",
        "panoramic right 2*x up .7*y rotate 15*x", "spherical angle 300 120 look_at <.3,.4,2>",
        "spherical look_at <.3,.4,2>", "cylinder 1 angle 160 look_at <.3,.4,2>",
        "cylinder 2 angle 100 right 2*x up y look_at <.3,.4,2>",
        "cylinder 3 angle 160 up 3*y location <0,.4,0> look_at <.3,.4,2>",
        "cylinder 4 angle 100 right 4*x up y rotate 10*z"));

}  // namespace
}  // namespace lentray::test
