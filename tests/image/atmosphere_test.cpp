// Fog and rainbows against stock: in the open, behind mirrors, in hollow and filled solids.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kStage = R"(
camera { location <0,2,-7> look_at <0,1,0> }
light_source { <-4,7,-6>, 1 }
plane { y, 0 hollow pigment { checker rgb .9 rgb <.5,.2,.1> } finish { reflection .2 } }
sphere { <-1.2,1,0>, 1 pigment { rgb <.9,.5,.3> } finish { reflection .3 } }
sphere { <1.2,1,0>, 1 pigment { rgbf .9 } interior { ior 1.2 } HOLLOW }
cylinder { <0,0,6>, <0,4,6>, .7 pigment { rgb <.2,.6,.3> } }
sky_sphere { pigment { gradient y color_map { [0 rgb <.8,.6,.5>] [1 rgb <.1,.2,.5>] } } }
)";

class ImageAir : public ::testing::TestWithParam<const char*> {};

TEST_P(ImageAir, IsStocks) {
  for (const char* hollow : {"", "hollow"}) {
    std::string text =
        std::string("#version 3.7; global_settings { assumed_gamma 1 }\n") + GetParam() + kStage;
    text.replace(text.find("HOLLOW"), 6, hollow);
    EXPECT_TRUE(
        same_as_stock({.sdl = text, .width = 120, .height = 90, .arguments = {}, .files = {}}));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageAir,
    ::testing::Values(
        "fog { distance 12 rgb <.7,.7,.8> }", "fog { distance 6 rgbft <.7,.4,.8,.5,.3> }",
        "fog { fog_type 2 distance 5 rgb .8 fog_offset .6 fog_alt .7 }",
        "fog { fog_type 2 distance 9 rgbf <.8,.8,.2,.4> fog_offset .1 fog_alt 1.5 up <.3,1,.1> }",
        "fog { distance 9 rgb .8 turbulence <.4,.6,.2> turb_depth .7 octaves 4 omega .6 }",
        "fog { fog_type 2 distance 5 rgb .8 fog_offset .6 fog_alt .7 turbulence .5 }",
        "fog { fog_type 2 distance 26 rgb .8 fog_alt 1.4 turbulence 0 }",
        "fog { distance 9 rgb .8 lambda 2 }",
        "fog { distance 20 rgb .9 } fog { distance 5 fog_type 2 fog_alt .3 rgb <.1,.3,.5> }",
        "rainbow { direction z-.2*y angle 30 width 12 distance 20 color_map {"
        " [0 rgbt <.6,.2,.9,.9>] [.5 rgbt <.2,.9,.2,.7>] [1 rgbft <.9,.2,.1,.3,.8>] } }",
        "rainbow { direction z angle 35 width 9 arc_angle 150 falloff_angle 40 distance 8 up "
        "<.2,1,0>"
        " color_map { [0 rgbt <.6,.2,.9,.5>] [1 rgbt <.9,.2,.1,.8>] } } fog { distance 30 rgb .5 "
        "}"));

// A ray that meets nothing goes on for 2e10, beyond where surfaces end.
TEST(ImageAirFar, OpenAirIsDeep) {
  for (const char* air :
       {"fog { distance 1e7 rgb <.2,.9,.4> }", "fog { distance 3e10 rgb <.2,.9,.4> }",
        "rainbow { direction -y+.2*z angle 80 width 20 distance 1e9 color_map { [0 rgb <.6,.2,.9>]"
        " [1 rgbf <.9,.2,.1,.8>] } }",
        "media { absorption <.1,.3,.5>*1e-10 }"}) {
    const std::string sdl =
        std::string(
            "#version 3.7; global_settings { assumed_gamma 1 } camera { location -4*z }\n"
            "sky_sphere { pigment { rgb <.2,.4,.6> } } plane { y, -1 pigment { rgb 1 } finish {"
            " ambient .5 } }\n") +
        air;
    EXPECT_TRUE(
        same_as_stock({.sdl = sdl, .width = 60, .height = 45, .arguments = {}, .files = {}}));
  }
}

TEST(ImageAirQuality, IsLeftOutBelowNine) {
  const std::string sdl =
      "#version 3.7; global_settings { assumed_gamma 1 }\n"
      "camera { location -4*z } light_source { <-4,7,-6>, 1 } sphere { 0, 1 pigment"
      " { rgb 1 } } fog { distance 3 rgb <1,.5,.2> }";
  for (const char* quality : {"+Q8", "+Q9"}) {
    EXPECT_TRUE(same_as_stock(
        {.sdl = sdl, .width = 60, .height = 45, .arguments = {quality}, .files = {}}));
  }
}

}  // namespace
}  // namespace lentray::test
