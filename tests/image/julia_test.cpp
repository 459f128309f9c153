// Julia fractals against stock: every function of both algebras, alone and in CSG.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kStage = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.2,2.6,-4> look_at <0,.2,0> angle 40 }
light_source { <-4,7,-6>, 1 }
light_source { <5,3,-2>, .3 }
plane { y, -1.6 pigment { checker rgb .9 rgb .5 } }
)";

struct Case {
  const char* name;
  const char* sdl;
  Grade grade = Grade::exact;
};

const Case kCases[] = {
    {"quaternion_sqr", "<-.083,0,-.83,-.025> quaternion sqr max_iteration 8 precision 15"},
    {"quaternion_sqr_fine", "<-.745,.113,.01,.01> quaternion max_iteration 30 precision 200"},
    {"quaternion_slice", "<.28,.56,.1,.2> slice <.2,-.3,.4,.8>, .2 max_iteration 10 precision 60"},
    {"quaternion_cube", "<-.5,.6,.1,.2> quaternion cube max_iteration 7 precision 80"},
    {"hypercomplex_sqr", "<-.162,.163,.56,-.599> hypercomplex sqr max_iteration 8 precision 40"},
    {"hypercomplex_cube", "<-.162,.163,.56,-.599> hypercomplex cube max_iteration 8 precision 40"},
    {"hypercomplex_slice", "<-.16,.16,.3,-.2> hypercomplex slice <.1,.2,.3,1>, .1 precision 30"},
    {"reciprocal", "<.1,.8,-.1,.02> hypercomplex reciprocal max_iteration 6 precision 40"},
    {"exp", "<-1.1,.5,.2,.1> hypercomplex exp max_iteration 6 precision 40"},
    {"ln", "<.2,-.9,.3,.1> hypercomplex ln max_iteration 6 precision 40"},
    {"sin", "<.7,.4,.2,-.2> hypercomplex sin max_iteration 6 precision 40"},
    {"asin", "<.7,.4,.2,-.2> hypercomplex asin max_iteration 6 precision 40"},
    {"cos", "<.5,.5,.1,.2> hypercomplex cos max_iteration 6 precision 40"},
    {"acos", "<.5,.5,.1,.2> hypercomplex acos max_iteration 6 precision 40"},
    {"tan", "<.3,.4,.1,.2> hypercomplex tan max_iteration 5 precision 40"},
    {"atan", "<.9,.9,.1,.2> hypercomplex atan max_iteration 6 precision 40"},
    {"sinh", "<.7,.4,.2,-.2> hypercomplex sinh max_iteration 6 precision 40"},
    {"asinh", "<.7,.4,.2,-.2> hypercomplex asinh max_iteration 6 precision 40"},
    {"cosh", "<.5,.5,.1,.2> hypercomplex cosh max_iteration 6 precision 40"},
    {"acosh", "<.5,.5,.1,.2> hypercomplex acosh max_iteration 6 precision 40"},
    {"tanh", "<.3,.4,.1,.2> hypercomplex tanh max_iteration 5 precision 40"},
    {"atanh", "<.9,.9,.1,.2> hypercomplex atanh max_iteration 6 precision 40"},
    {"pwr", "<.3,.5,.1,.2> hypercomplex pwr(1.5,.8) max_iteration 6 precision 40"},
    {"pwr_whole", "<.3,.5,.1,.2> hypercomplex pwr(4,0) max_iteration 6 precision 40"},
};

class ImageJulia : public ::testing::TestWithParam<Case> {};

TEST_P(ImageJulia, Alone) {
  const std::string sdl = std::string(kStage) + "julia_fractal { " + GetParam().sdl +
                          " pigment { rgb <.9,.5,.3> } finish { specular .4 reflection .2 } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl, .width = 120, .height = 90, .arguments = {}, .files = {}},
                            GetParam().grade));
}

TEST_P(ImageJulia, InCsg) {
  const std::string one = std::string("julia_fractal { ") + GetParam().sdl + " }";
  const std::string sdl = std::string(kStage) + "difference { " + one +
                          " sphere { <.4,.4,-.8>, .7 } pigment { rgb <.3,.7,.9> } }\n"
                          "intersection { " + one + " box { <-2,-.1,-2>, <2,.1,2> }"
                          " translate <-1.2,1.4,1.5> pigment { rgb <.8,.9,.3> } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl, .width = 120, .height = 90, .arguments = {}, .files = {}},
                            GetParam().grade));
}

INSTANTIATE_TEST_SUITE_P(Each, ImageJulia, ::testing::ValuesIn(kCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
