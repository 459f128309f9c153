// A blob near the start of a ray: hits within a hundredth of a unit do not count, whatever the blob's scale.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

// The surface of Drop is at a distance of 1.0824 from its middle.
constexpr const char* kBlobStartStage = R"(#version 3.7; global_settings { assumed_gamma 1 }
light_source { <-1,1.5,-9>, 1 }
#declare Drop = blob { threshold .5 sphere { 0, 2, 1 } pigment { rgb <.9,.6,.2> } };
#declare Hilly = blob { threshold .4 sphere { -.5*x, 1.2, 1 } cylinder { 0, <.6,.4,0>, .8, .9 }
  pigment { rgb <.2,.7,.5> } };
#declare Front = camera { orthographic location -5*z look_at 0 right 2.4*x up 1.8*y };
)";

struct BlobStartCase {
  const char* name;
  const char* sdl;
};

const BlobStartCase kBlobStartCases[] = {
    {"clear_pane", "camera { Front } object { Drop } plane { z, -1.06 pigment { rgbt .8 } }"},
    {"clear_pane_hilly",
     "camera { Front } object { Hilly } plane { z, -.7 pigment { rgbt .8 } rotate 5*y }"},
    {"shadow", "camera { Front } object { Drop no_image } plane { -z, 1.06 pigment { rgb 1 } }"},
    {"large",
     "camera { Front } object { Drop scale 20 translate 20.6*z }"
     " plane { z, -1.05 pigment { rgbt .8 } }"},
    {"small",
     "camera { Front } union { #for (X, -5, 5) object { Drop scale .05 translate"
     " <X*.2,X*.1,0> } #end } plane { z, -.05 pigment { rgbt .8 } }"},
    {"mirror",
     "camera { Front } object { Drop no_image }"
     " plane { -z, 1.06 pigment { rgb .1 } finish { reflection .8 } }"},
    {"csg",
     "camera { Front } difference { object { Drop } box { <-2,-2,-2>, <0,2,2> }"
     " pigment { rgb x } } plane { z, -1.06 pigment { rgbt .8 } }"},
    {"cut_from",
     "camera { Front } difference { box { <-2,-2,-1.04>, 2 } object { Drop }"
     " pigment { rgb .8 } } plane { z, -1.045 pigment { rgbt .8 } }"},
    {"camera_near",
     "camera { location -1.085*z look_at 0 angle 100 } object { Drop }"
     " background { rgb z }"},
    {"camera_inside",
     "camera { location -1.076*z look_at -9*z angle 110 } object { Drop }"
     " background { rgb z }"},
};

class ImageBlobStart : public ::testing::TestWithParam<BlobStartCase> {};

TEST_P(ImageBlobStart, AsInStock) {
  EXPECT_TRUE(same_as_stock({.sdl = std::string(kBlobStartStage) + GetParam().sdl,
                             .width = 120,
                             .height = 90,
                             .arguments = {},
                             .files = {}},
                            Grade::exact));
}

INSTANTIATE_TEST_SUITE_P(Each, ImageBlobStart, ::testing::ValuesIn(kBlobStartCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
