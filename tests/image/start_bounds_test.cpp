// A camera in solids that reach beyond stock's box of them, against stock: whether it begins inside, which tells what
// refracts. Lights cast no shadows.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

testing::AssertionResult start_bounds_looks_the_same(const std::string& objects) {
  return same_as_stock(
      {.sdl = "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 8 }\n"
              "camera { location <1,5,-3.5> angle 42 look_at <0,.7,0> }\n"
              "light_source { <-4,7,-6>, 1 shadowless } background { rgb <.3,.5,.8> }\n"
              "#declare Glass = texture { pigment { rgbt <.2,.8,.9,.6> } }\n"
              "plane { y, -1 pigment { checker rgb .9 rgb .4 } }\n" +
              objects,
       .width = 60,
       .height = 45,
       .arguments = {},
       .files = {}});
}

class ImageStartBounds : public ::testing::TestWithParam<std::string> {};

TEST_P(ImageStartBounds, AsStock) {
  for (const std::string bound :
       {"", "bounded_by { box { <-.7,-2,-2>, <.6,1,2> } }", "bounded_by { sphere { 0, 5.5 } }",
        "bounded_by { box { -6, 6 } plane { y, 2 } box { -2, 2 } }",
        "bounded_by { plane { y, 2 } }", "clipped_by { box { <-.7,-2,-2>, <.6,1,2> } }"}) {
    EXPECT_TRUE(start_bounds_looks_the_same(
        GetParam() + " texture { Glass } interior { ior 1.2 } " + bound + "}"))
        << bound;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageStartBounds,
    ::testing::Values(
        "quadric { <1,-1,1>, 0, 0, -.1", "quadric { <1,0,1>, 0, 0, -17",
        "merge { sphere { 0, .6 } quadric { <1,-1,1>, 0, 0, -.1 }",
        "difference { quadric { <1,-1,1>, 0, 0, -.1 } sphere { .5*y, .6 }",
        "sphere { 0, .6 inverse", "merge { sphere { 0, .6 } box { 0, 1 } inverse",
        "height_field { png \"plasma2.png\" translate <-.5,0,-.5> scale <9,1,9> translate 6*y",
        "sphere { 0, 1 texture { Glass } interior { ior 1.5 } } plane { -y, 1.5"));

}  // namespace
}  // namespace lentray::test
