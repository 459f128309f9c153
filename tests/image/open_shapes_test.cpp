// Shapes that are open or hollow as parts of CSG and as clips, against stock: what counts as their inside.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

testing::AssertionResult open_shapes_looks_the_same(const std::string& objects) {
  return same_as_stock(
      {.sdl = "#version 3.7; global_settings { assumed_gamma 1 }\n"
              "camera { location <1,5,-3.5> angle 42 look_at <0,.7,0> }\n"
              "light_source { <-4,7,-6>, .8 } light_source { <5,9,-7>, .2 shadowless }\n"
              "#default { pigment { rgb <.9,.7,.3> } finish { ambient .2 } }\n"
              "plane { y, -1 pigment { checker rgb .9 rgb .4 } }\n" +
              objects,
       .width = 80,
       .height = 60,
       .arguments = {},
       .files = {}});
}

const std::string kBlock = "box { <-1.2,-.8,0>, <1.2,1.53,1.2>";

struct OpenShapesCase {
  const char* name;
  std::string sdl;
};

class ImageOpenShapes : public ::testing::TestWithParam<OpenShapesCase> {};

TEST_P(ImageOpenShapes, Alone) { EXPECT_TRUE(open_shapes_looks_the_same(GetParam().sdl + "}")); }

TEST_P(ImageOpenShapes, Cut) {
  EXPECT_TRUE(open_shapes_looks_the_same("intersection { " + GetParam().sdl +
                                         "} box { -2, <.3,1.12,2> } }"));
  EXPECT_TRUE(open_shapes_looks_the_same("difference { " + GetParam().sdl +
                                         "} box { <-.2,.1,-2>, <2,1.12,.1> } }"));
}

TEST_P(ImageOpenShapes, Cutting) {
  EXPECT_TRUE(open_shapes_looks_the_same("difference { " + kBlock + "} " + GetParam().sdl + "} }"));
  EXPECT_TRUE(open_shapes_looks_the_same("difference { " + kBlock + "} " + GetParam().sdl +
                                         " rotate 35*x } }"));
}

TEST_P(ImageOpenShapes, InAMerge) {
  EXPECT_TRUE(
      open_shapes_looks_the_same("merge { " + GetParam().sdl +
                                 "} sphere { <.5,.8,-.3>, .8 } pigment { rgbt <.2,.8,.9,.6> } }"));
}

TEST_P(ImageOpenShapes, Clipping) {
  EXPECT_TRUE(open_shapes_looks_the_same(kBlock + " clipped_by { " + GetParam().sdl + "} } }"));
  EXPECT_TRUE(
      open_shapes_looks_the_same(kBlock + " clipped_by { " + GetParam().sdl + " inverse } } }"));
}

INSTANTIATE_TEST_SUITE_P(
    Lathes, ImageOpenShapes,
    ::testing::Values(
        OpenShapesCase{"linear", "lathe { linear_spline 4, <.3,-.5>, <1,0>, <.6,1>, <.9,1.8>"},
        OpenShapesCase{"turning_back",
                       "lathe { linear_spline 5, <.3,0>, <1,-.3>, <.9,1.6>, <.5,1.2>, <.6,.4>"},
        OpenShapesCase{"quadratic",
                       "lathe { quadratic_spline 4, <.2,-.8>, <1,-.5>, <.4,.5>, <1,1.5>"},
        OpenShapesCase{"cubic",
                       "lathe { cubic_spline 5, <.5,-.8>, <1.3,-.6>, <.5,.2>, <.5,1.1>, <1.5,1.8>"},
        OpenShapesCase{"bezier",
                       "lathe { bezier_spline 8, <.3,-.5>, <1.4,0>, <1.2,.3>, <.9,.8>,"
                       " <.5,1>, <.2,1.2>, <.9,1.4>, <.3,1.8>"}),
    [](const auto& one) { return std::string(one.param.name); });

/// Half-spaces: rays that miss the box of what they are cut from miss the whole.
INSTANTIATE_TEST_SUITE_P(
    BeyondTheirBoxes, ImageOpenShapes,
    ::testing::Values(OpenShapesCase{"disc", "disc { <0,.8,0>, <.2,.6,-1>, 1.1"},
                      OpenShapesCase{"ring", "disc { <0,.8,0>, <.2,1,-.3>, 1.1, .5"},
                      OpenShapesCase{"scaled_disc",
                                     "disc { <0,.8,0>, <.2,.6,-1>, 1.1 scale <1,.7,1.2>"}),
    [](const auto& one) { return std::string(one.param.name); });

/// The box of a turned CSG is that of its parts' boxes, turned; each time it is turned.
/// Of parts of CSG stock asks no box, but only of the whole, and of the parts of a union that is split.
class ImageOpenPartsOf : public ::testing::TestWithParam<OpenShapesCase> {};

TEST_P(ImageOpenPartsOf, WhatJoinsThem) {
  const auto [name, around] = GetParam();
  const auto joined = [&around = around](const std::string& parts) {
    std::string sdl = around;
    return open_shapes_looks_the_same(sdl.replace(sdl.find('*'), 1, parts));
  };
  EXPECT_TRUE(
      joined("sphere { -x, .5 } intersection { disc { <0,.3,0>, <.1,1,.2>, 1, .2 } plane { "
             "<-.1,.5,-.6>, .29 } }"));
  EXPECT_TRUE(
      joined("sphere { x, .6 } merge { sphere { -x, .4 } difference { disc { 0, y, 1, .2 } plane { "
             "y+x, -1 } } }"));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageOpenPartsOf,
    ::testing::Values(
        OpenShapesCase{"merge", "merge { * }"},
        OpenShapesCase{"turned_merge", "merge { * rotate <10,0,20> }"},
        OpenShapesCase{"union", "union { * }"},
        OpenShapesCase{"whole_union", "union { * split_union off }"},
        OpenShapesCase{"clipped_union", "union { * clipped_by { box { -1.5, 1.5 } } }"},
        OpenShapesCase{"cut_union", "intersection { union { * } box { -1.3, 1.4 } }"},
        OpenShapesCase{"notched_union", "difference { union { * } box { -1.5, <1.5,.1,1.5> } }"},
        OpenShapesCase{"union_of_a_merge", "union { merge { * } sphere { 2*y, .1 } }"}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(ImageOpenShapesTurned, HaveTheBoxOfABox) {
  const std::string disc = "disc { <.1,0,.25>, <.6,.2,.9>, .7, .2 }",
                    cut = disc + " box { <-.6,-.6,-.6>, <.6,.4,.6> }";
  for (const std::string& object :
       {"difference { " + cut + " rotate 30 }",
        "difference { " + cut + " matrix <1,.3,0,0,1,.1,.2,0,1,0,.1,0> }",
        "union { difference { " + cut + " rotate 30 } sphere { 2*y, .5 } rotate 20*y }",
        "difference { difference { " + cut + " rotate 30 } sphere { 1, 1 } rotate 20*y }"}) {
    const std::string sdl =
        "#version 3.7; global_settings { assumed_gamma 1 }\n"
        "camera { location <-1,2.2,-3.8> look_at 0 angle 50 } light_source { <-4,7,-6>, 1 }\n"
        "plane { y, -1.6 pigment { checker rgb .9 rgb .5 } } #default { pigment { rgb <1,.5,.3> } "
        "}\n" +
        object;
    EXPECT_TRUE(
        same_as_stock({.sdl = sdl, .width = 100, .height = 75, .arguments = {}, .files = {}}))
        << object;
  }
}

/// As bounds. Lights cast no shadows.
class ImageOpenBounds : public ::testing::TestWithParam<OpenShapesCase> {};

TEST_P(ImageOpenBounds, OfCsg) {
  const auto looks_the_same = [](const std::string& objects) {
    return same_as_stock({.sdl = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                                 "camera { location <1,5,-3.5> angle 42 look_at <0,.7,0> }\n"
                                 "light_source { <-4,7,-6>, 1 shadowless }\n"
                                 "plane { y, -1 pigment { checker rgb .9 rgb .4 } }\n" +
                                 objects,
                          .width = 80,
                          .height = 60,
                          .arguments = {},
                          .files = {}});
  };
  const std::string rest =
      " bounded_by { " + GetParam().sdl + "} } pigment { rgbt <.2,.8,.9,.6> } }";
  EXPECT_TRUE(looks_the_same(
      "merge { box { <-1.2,-.8,0>, <1.2,1.53,1.2> } sphere { <.2,.6,0>, .7 }" + rest));
  EXPECT_TRUE(looks_the_same(
      "difference { box { <-1.2,-.8,0>, <1.2,1.53,1.2> } sphere { <.2,.6,0>, .7 }" + rest));
  EXPECT_TRUE(looks_the_same("box { <-1.2,-.8,0>, <1.2,1.53,1.2>" + rest));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageOpenBounds,
    ::testing::Values(
        OpenShapesCase{"tilted_cylinder", "cylinder { <0,-.6,0>, <.2,1.4,0>, .8"},
        OpenShapesCase{"torus", "torus { .8, .3 rotate 20*x translate .5*y"},
        OpenShapesCase{
            "bezier_prism",
            "prism { linear_sweep bezier_spline -.5, 1.5, 8, <-1,-1>,<0,-1.5>,<.5,-.5>,<1,-1>,"
            " <1,-1>,<1.5,1>,<-1.5,1.5>,<-1,-1> open scale .8"}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
