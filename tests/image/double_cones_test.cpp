// Cones with radii below 0, against stock: of different signs they are two cones that meet in a tip, both below they are
// a cylinder.
#include <gtest/gtest.h>

#include <string>

#include "tests/image/floor_scene.h"

namespace lentray::test {
namespace {

class ImageDoubleCones : public ::testing::TestWithParam<const char*> {};

TEST_P(ImageDoubleCones, AsStock) {
  const std::string cone = "cone { " + std::string(GetParam()) + " pigment { rgb x } ";
  EXPECT_TRUE(same_on_the_floor(
      cone + "scale .6 translate <-.9,.5,0> }" + cone +
      "rotate <40,20,-70> scale <.6,.4,.7> translate .6*y }" + "difference { box { -1, .5 } " +
      cone + "rotate 90*z translate .4 } pigment { rgb z } scale .5 translate <-.8,-.7,0> }" +
      "intersection { " + cone +
      "} box { -1, <1,.5,0> } pigment { rgb z } rotate y*70 scale .7 translate <1,.4,0> }" + cone +
      "pigment { rgbt <1,.7,.7,.8> } interior { ior 1.3 } rotate z*70 scale .6 translate "
      "<.6,-.8,0> }"));
}

INSTANTIATE_TEST_SUITE_P(Radii, ImageDoubleCones,
                         ::testing::Values("-.8*y, -.3, .8*y, .6", "-.8*y, .6, .8*y, -.3",
                                           "-.8*y, -.3, .8*y, .6 open", "-.8*y, -.5, .8*y, .5",
                                           "-.8*y, -.3, .8*y, -.6", "-.8*y, -.6, .8*y, -.6"));

}  // namespace
}  // namespace lentray::test
