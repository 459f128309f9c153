// tolerance of a sphere_sweep, against stock: rays do not meet the sweep before it, so that shadows begin beyond it.
#include <gtest/gtest.h>

#include <string>

#include "tests/image/floor_scene.h"

namespace lentray::test {
namespace {

class ImageSweepTolerance : public ::testing::TestWithParam<const char*> {};

TEST_P(ImageSweepTolerance, AsStock) {
  const std::string sweep =
      "sphere_sweep { linear_spline 4, <-.8,-.5,0>, .3, <.8,-.3,0>, .2, <-.3,.7,0>, .3, "
      "<.7,.6,-.3>, .1"
      " tolerance " +
      std::string(GetParam());
  const std::string opaque = " pigment { rgb <.9,.5,.2> } ",
                    clear = " pigment { rgbt <.9,.5,.2,.7> } interior { ior 1.3 } ";
  EXPECT_TRUE(same_on_the_floor("global_settings { max_trace_level 10 }\n" + sweep + opaque +
                                "scale .7 translate <-.9,.5,0> }\n" + sweep + clear +
                                "scale <.8,.5,.7> rotate 20 translate <.7,.5,0> }\n" +
                                "difference { " + sweep + "} plane { z, -.1 }" + opaque +
                                "scale .7 translate <-.7,-.7,0> }\n" +
                                "difference { box { -1, 1 } " + sweep + " translate -.9*z }" +
                                opaque + "scale .5 translate <.7,-.7,0> }\n"));
}

INSTANTIATE_TEST_SUITE_P(Lengths, ImageSweepTolerance,
                         ::testing::Values("1e-6", "1e-3", ".02", ".1"));

}  // namespace
}  // namespace lentray::test
