// Shadows of clear shapes that do not tell all crossings at once, against stock: the search begins anew behind
// each surface, so that max_trace does not limit what filters the light.
#include "tests/image/shading_scenes.h"

namespace lentray::test {
namespace {

struct BegunAnewCase {
  const char* name;
  const char* sdl;
};

#define CLEAR " pigment { rgbt <1,.6,.4,.6> } "
#define SHELL(more)                                                                                \
  "isosurface { function { abs(sqrt(x*x + y*y + z*z) - .7) - .15 } contained_by { box { -1,1 } } " \
  "max_gradient 2.5 " more " translate y }"
#define WAVES(more)                                                                                \
  "isosurface { function { y + .3*sin(5*x)*sin(5*z) } contained_by { box { -1,1 } } max_gradient " \
  "3 " more " translate y }"
#define SHEET(more)                                                                               \
  "parametric { function { u } function { 1+.2*sin(2*u)*cos(2*v) } function { v } <-1,-1>,<1,1> " \
  "contained_by {"                                                                                \
  " box { <-1.1,.5,-1.1>, <1.1,1.4,1.1> } } accuracy .005 max_gradient 1.2 " more "}"

#define JULIA(more) "julia_fractal { " more " translate y }"

const BegunAnewCase kCases[] = {
    {"alone", SHELL(CLEAR)},
    {"two_surfaces", SHELL("max_trace 2" CLEAR)},
    {"all_surfaces", SHELL("max_trace 10" CLEAR)},
    {"open", SHELL("open max_trace 3" CLEAR)},
    {"waves", WAVES("open" CLEAR)},
    {"clipped", SHELL(CLEAR "clipped_by { plane { x,.3 } }")},
    {"scaled", "object {" SHELL(CLEAR) "translate -y scale <1,.6,1.3> rotate 30 translate y }"},
    {"in_intersection", "intersection {" SHELL("") "plane { x,.3 }" CLEAR "}"},
    {"in_difference",
     "difference { box { <-1.2,.1,-1.2>, <1.2,1.1,1.2> }" SHELL("max_trace 2") CLEAR "}"},
    {"in_merge", "merge {" SHELL("") "sphere { <.8,1,0>, .6 }" CLEAR "}"},
    {"in_union",
     "union {" SHELL("") "sphere { <.8,1,0>, .6 }" CLEAR "clipped_by { plane { y,1.4 } } }"},
    {"parametric", SHEET(CLEAR)},
    {"parametric_turned", "object {" SHEET(CLEAR) "rotate <30,20,0> translate .3*y }"},
    {"julia", JULIA("<-.083,0,-.83,-.025> quaternion sqr max_iteration 8 precision 15" CLEAR)},
    {"julia_cube", JULIA("<-.162,.163,.56,-.599> quaternion cube max_iteration 6 precision 20" CLEAR
                         "interior { ior 1.3 }")},
    {"julia_of_function", JULIA("<-.6,.2,0,.1> hypercomplex exp max_iteration 6 precision 20 "
                                "slice <0,0,0,1>, .1" CLEAR)},
    {"with_interiors", SHELL(CLEAR "interior { ior 1.2 fade_power 2 fade_distance .6 caustics .3 "
                                   "}") "sphere { <-.7,1,-.2>, .6" CLEAR
                                        "interior { ior 1.5 fade_power 1 fade_distance .5 } }"},
};

class ImageBegunAnewShadows : public ::testing::TestWithParam<BegunAnewCase> {};

TEST_P(ImageBegunAnewShadows, AsStock) {
  EXPECT_TRUE(same_as_stock(staged(std::string(GetParam().sdl) + "\n")));
}

INSTANTIATE_TEST_SUITE_P(Each, ImageBegunAnewShadows, ::testing::ValuesIn(kCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
