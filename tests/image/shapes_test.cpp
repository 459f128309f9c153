// Primitives against stock: each alone, and cut open and joined by CSG, which asks for all hits and
// for inside().
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kStage = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.2,2.6,-4> look_at <0,.4,0> angle 45 }
light_source { <-4,7,-6>, 1 }
light_source { <5,3,-2>, .3 }
plane { y, -1.2 pigment { checker rgb .9 rgb .5 } }
)";

struct Case {
  const char* name;
  const char* sdl;
  bool with_solids = true;  ///< has an inside
  Grade grade = Grade::exact;
};

const Case kCases[] = {
    {"text", "text { ttf \"cyrvetic.ttf\" \"R&g8\" .4, <.05,.02,0> scale 1.3 translate -1.4*x }", true,
     Grade::match},
    {"text_timrom", "text { internal 1 \"AVoid\" .3, 0 translate -1.3*x }", true, Grade::match},
    {"prism_linear", "prism { -.5, .7, 10 <-1,-1>,<1,-1>,<1,1>,<0,.2>,<-1,1>,<-1,-1>"
                     " <-.3,-.7>,<.3,-.7>,<0,0>,<-.3,-.7> }"},
    {"prism_quadratic", "prism { quadratic_spline 0, .6, 7 <-1,1>,<-1,-1>,<1,-1>,<1.2,.4>,<0,1>,<-1,-1>,<0,0> }"},
    {"prism_cubic", "prism { cubic_spline 0, .6, 7 <0,1>,<-1,-1>,<1,-1>,<1.2,.4>,<0,1>,<-1,-1>,<1,-1> }"},
    {"prism_bezier", "prism { bezier_spline 0, .6, 8 <0,-1>,<1.5,-1>,<1,.5>,<0,.6>"
                     " <0,.6>,<-1,.5>,<-1.5,-1>,<0,-1> rotate x*-20 }"},
    {"prism_open", "prism { 0, .8, 5 <-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1> open }", false},
    {"prism_conic", "prism { conic_sweep linear_spline .2, 1, 5 <-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1>"
                    " translate -.4*y }"},
    {"prism_conic_cubic", "prism { conic_sweep cubic_spline 0, 1, 7 <0,1>,<-1,-1>,<1,-1>,<1.2,.4>,"
                          "<0,1>,<-1,-1>,<1,-1> rotate x*180 translate .6*y }"},
    {"superellipsoid", "superellipsoid { <.3,.5> }"},
    {"superellipsoid_sharp", "superellipsoid { <1.8,.2> scale <1,1,.6> rotate 20*x }"},
    {"superellipsoid_concave", "superellipsoid { <2.6,2.2> scale 1.2 }"},
    {"quartic_torus", "quartic { <1,0,0,0,2,0,0,2,0,-2.32,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,1.68,0,0,0,0,"
                      "1,0,-2.32,0,.7056> bounded_by { box { -2, 2 } } }"},
    {"cubic", "cubic { <1,0,0,0,0,0,0,0,0,0,0,0,-1,0,0,0,0,-.3,0,0> clipped_by { sphere { 0, 1.4 } } }",
     false},
    {"poly6", "poly { 6, <1,0,0,0,3,0,0,3,0,0,0,0,0,0,0,0,0,0,0,0,3,0,0,-12,0,0,0,0,0,0,3,0,0,0,0,0,0,0,"
              "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,3,0,0,0,0,0,0,3,0,0,0,0,0,0,0,0,0,0,"
              "1,0,0,0,0,0,-1> scale 1.1 }"},
    {"height_field", "height_field { png \"plasma3.png\" water_level .2 scale <2.4,1.2,2.4>"
                     " translate <-1.2,-.6,-1.2> }", true, Grade::match},
    {"height_field_smooth", "height_field { function 40, 30 { .5 + .4*sin(x*9)*cos(y*8) } smooth"
                            " scale <2.4,1.2,2.4> translate <-1.2,-.6,-1.2> rotate 15*z }"},
};

class ImageShapes : public ::testing::TestWithParam<Case> {};

TEST_P(ImageShapes, Alone) {
  const std::string sdl = std::string(kStage) + "object { " + GetParam().sdl +
                          " pigment { rgb <.9,.5,.3> } finish { specular .4 reflection .2 } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl, .width = 120, .height = 90, .arguments = {}, .files = {}},
                            GetParam().grade));
}

TEST_P(ImageShapes, InCsg) {
  if (!GetParam().with_solids) return;
  const std::string one = std::string("object { ") + GetParam().sdl + " }";
  const std::string sdl = std::string(kStage) + "difference { " + one +
                          " sphere { <.4,.4,-.8>, .7 } pigment { rgb <.3,.7,.9> } }\n"
                          "intersection { " + one + " box { <-2,-.1,-2>, <2,.1,2> }"
                          " translate <-1.2,1.4,1.5> pigment { rgb <.8,.9,.3> } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl, .width = 120, .height = 90, .arguments = {}, .files = {}},
                            GetParam().grade));
}

INSTANTIATE_TEST_SUITE_P(Each, ImageShapes, ::testing::ValuesIn(kCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace lentray::test
