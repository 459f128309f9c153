// Julia fractals against stock: every function of both algebras, alone and in CSG.
// The lights throw no shadows where the fractal is seen: on such surfaces stock's shadow cache, which
// takes blockers from 1e-4 on where its search takes them from 1e-3, darkens pixels by the order of
// scanning. Shadows are compared where they fall on something else.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kJuliaStage = R"(
global_settings { assumed_gamma 1 }
camera { CAMERA() }
light_source { <-4,7,-6>, 1 LIGHT() }
light_source { <5,3,-2>, .3 LIGHT() }
plane { y, -1.6 pigment { checker rgb .9 rgb .5 } }
)";

struct JuliaCase {
  const char* name;
  const char* sdl;
  Grade grade = Grade::exact;
  /// Match: stock takes later hits for nearer than they are, by up to a step, which can hide others.
  Grade in_csg = Grade::exact;
};

const JuliaCase kJuliaCases[] = {
    {"quaternion_sqr", "<-.083,0,-.83,-.025> quaternion sqr max_iteration 8 precision 15",
     Grade::exact, Grade::match},
    {"quaternion_sqr_fine", "<-.745,.113,.01,.01> quaternion max_iteration 30 precision 200",
     Grade::exact, Grade::match},
    {"quaternion_slice", "<.28,.56,.1,.2> slice <.2,-.3,.4,.8>, .2 max_iteration 10 precision 60",
     Grade::exact, Grade::match},
    {"quaternion_cube", "<-.5,.6,.1,.2> quaternion cube max_iteration 7 precision 80"},
    {"hypercomplex_sqr", "<-.162,.163,.56,-.599> hypercomplex sqr max_iteration 8 precision 20"},
    {"hypercomplex_cube", "<-.162,.163,.56,-.599> hypercomplex cube max_iteration 8 precision 20"},
    {"hypercomplex_slice", "<-.16,.16,.3,-.2> hypercomplex slice <.1,.2,.3,1>, .1 precision 30"},
    {"reciprocal", "<.1,.8,-.1,.02> hypercomplex reciprocal max_iteration 6 precision 20"},
    {"exp", "<-1.1,.5,.2,.1> hypercomplex exp max_iteration 6 precision 20"},
    {"ln", "<.2,-.9,.3,.1> hypercomplex ln max_iteration 6 precision 20"},
    {"sin", "<.7,.4,.2,-.2> hypercomplex sin max_iteration 6 precision 20"},
    {"asin", "<.7,.4,.2,-.2> hypercomplex asin max_iteration 6 precision 20"},
    {"cos", "<.5,.5,.1,.2> hypercomplex cos max_iteration 6 precision 20"},
    {"acos", "<.5,.5,.1,.2> hypercomplex acos max_iteration 6 precision 20"},
    {"tan", "<.3,.4,.1,.2> hypercomplex tan max_iteration 5 precision 20"},
    {"atan", "<.9,.9,.1,.2> hypercomplex atan max_iteration 6 precision 20"},
    {"sinh", "<.7,.4,.2,-.2> hypercomplex sinh max_iteration 6 precision 20"},
    {"asinh", "<.7,.4,.2,-.2> hypercomplex asinh max_iteration 6 precision 20"},
    {"cosh", "<.5,.5,.1,.2> hypercomplex cosh max_iteration 6 precision 20"},
    {"acosh", "<.5,.5,.1,.2> hypercomplex acosh max_iteration 6 precision 20"},
    {"tanh", "<.3,.4,.1,.2> hypercomplex tanh max_iteration 5 precision 20"},
    {"atanh", "<.9,.9,.1,.2> hypercomplex atanh max_iteration 6 precision 20"},
    {"pwr", "<.3,.5,.1,.2> hypercomplex pwr(1.5,.8) max_iteration 6 precision 20"},
    {"pwr_whole", "<.3,.5,.1,.2> hypercomplex pwr(4,0) max_iteration 6 precision 20"},
};

constexpr std::size_t kWithin = 7;  ///< as many do not reach the sphere

class ImageJulia : public ::testing::TestWithParam<JuliaCase> {};

/// Rays that need no rounding are equal in both renderers to the last bit, which decides where a set
/// fills the sphere that rays start from.
constexpr const char* kAlongAxis = "orthographic location <0,0,-6> direction z right x*6 up y*3";
constexpr const char* kOblique = "location <2.2,2.6,-4> look_at <0,.2,0> angle 40";

SceneText julia_scene(const std::string& camera, const std::string& light, const std::string& sdl) {
  return {.sdl = "#version 3.7; #macro LIGHT() " + light + " #end #macro CAMERA() " + camera +
                 " #end\n" + kJuliaStage + sdl,
          .width = 64,
          .height = 32,
          .arguments = {},
          .files = {}};
}

TEST_P(ImageJulia, Alone) {
  const std::string sdl = std::string("julia_fractal { ") + GetParam().sdl +
                          " pigment { rgb <.9,.5,.3> } finish { specular .4 } }";
  EXPECT_TRUE(same_as_stock(julia_scene(kAlongAxis, "shadowless", sdl), GetParam().grade));
}

/// Sets that do not fill their sphere can be seen from anywhere.
class ImageJuliaWithin : public ::testing::TestWithParam<JuliaCase> {};

TEST_P(ImageJuliaWithin, Lit) {
  const std::string sdl = std::string("julia_fractal { ") + GetParam().sdl +
                          " pigment { rgb <.9,.5,.3> } finish { specular .4 }"
                          " rotate <10,20,30> scale <1.1,.9,1> }";
  EXPECT_TRUE(same_as_stock(julia_scene(kOblique, "shadowless", sdl), GetParam().grade));
}

TEST_P(ImageJuliaWithin, InCsg) {
  const std::string one = std::string("julia_fractal { ") + GetParam().sdl + " }";
  const std::string sdl = "difference { " + one +
                          " sphere { <.4,.4,-.8>, .7 }"
                          " box { <-5,-.2,-5>, <5,.1,5> } pigment { rgb <.3,.7,.9> } }\n"
                          "intersection { " +
                          one +
                          " box { <-5,-.15,-5>, <5,.05,5> }"
                          " pigment { rgb <.8,.9,.3> } }";
  EXPECT_TRUE(same_as_stock(julia_scene(kOblique, "shadowless", sdl), GetParam().in_csg));
}

TEST_P(ImageJuliaWithin, Shadow) {
  const std::string sdl = std::string("julia_fractal { ") + GetParam().sdl + " no_image }";
  EXPECT_TRUE(same_as_stock(julia_scene(kOblique, "", sdl), GetParam().grade));
}

const auto name_of = [](const auto& one) { return std::string(one.param.name); };
INSTANTIATE_TEST_SUITE_P(Each, ImageJuliaWithin,
                         ::testing::ValuesIn(std::vector<JuliaCase>(kJuliaCases,
                                                                    kJuliaCases + kWithin)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Each, ImageJulia, ::testing::ValuesIn(kJuliaCases), name_of);

}  // namespace
}  // namespace lentray::test
