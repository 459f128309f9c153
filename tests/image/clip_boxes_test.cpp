// What extends beyond the box of an object in stock is seen where rays meet the box, and only there: of some
// quadrics it holds too little, of discs in intersections, and of what a height field clips, which goes down
// without end.
#include <gtest/gtest.h>

#include "tests/support/gates.h"
#include "tests/support/render.h"

namespace lentray::test {
namespace {

std::string clip_boxes_scene(const std::string& objects) {
  return "#version 3.7; global_settings { assumed_gamma 1 }\n"
         "#declare H = height_field { png \"plasma2.png\" translate <-.5,0,-.5> scale <6,2,6> }\n"
         "camera { location <0,6,-9> angle 80 look_at 0 } light_source { <-4,7,-6>, 1 }\n"
         "#default { pigment { rgb <.9,.7,.3> } finish { ambient .2 } }\n" +
         objects;
}

testing::AssertionResult looks_the_same(const std::string& objects) {
  return same_as_stock(
      {.sdl = clip_boxes_scene(objects), .width = 80, .height = 60, .arguments = {}, .files = {}});
}

std::size_t turned_away(const std::string& objects) {
  return rays_that_gates_turn_away(clip_boxes_scene(objects), {0, 6, -9});
}

const std::string kByField = " clipped_by { object { H } } ";
const std::string kFloor = " plane { y, -9 }";

class ImageClipBoxes : public ::testing::TestWithParam<std::string> {};

TEST_P(ImageClipBoxes, Alone) { EXPECT_TRUE(looks_the_same("object { " + GetParam() + " }")); }

/// Without its gates the object looks otherwise: else the other tests would prove nothing.
TEST_P(ImageClipBoxes, GatesMatter) { EXPECT_GT(turned_away("object { " + GetParam() + " }"), 0u); }

TEST_P(ImageClipBoxes, WithAFloor) {
  EXPECT_TRUE(looks_the_same("object { " + GetParam() + " }" + kFloor));
}

INSTANTIATE_TEST_SUITE_P(
    Fields, ImageClipBoxes,
    ::testing::Values(
        "quadric { <1,0,1>, 0, 0, -1" + kByField + "}",
        "cylinder { -30*y, 30*y, 2.5 open" + kByField + "}",
        "torus { 2.5, 1 rotate 90*x" + kByField + "}",
        "intersection { quadric { <1,0,1>, 0, 0, -1 } plane { y, 5 }" + kByField + "}",
        "merge { quadric { <1,0,1>, 0, 0, -4" + kByField + "} sphere { <2,0,1>, 1 } }",
        "quadric { <1,0,1>, 0, 0, -1 clipped_by { union { object { H } sphere { -2*y, 1.5 } } } "
        "}"));

INSTANTIATE_TEST_SUITE_P(
    Quadrics, ImageClipBoxes,
    ::testing::Values(
        "quadric { <1,-1,1>, 0, 0, -4 clipped_by { plane { y, 1 } plane { -y, 1 } } }",
        "quadric { <1,-1,1>, 0, 0, -4 clipped_by { box { <-5,-1,-5>, <5,1,5> } } rotate 30*z }",
        "intersection { quadric { <1,-1,1>, 0, 0, -4 } plane { y, 1 } plane { -y, 1 } rotate 50*x "
        "}",
        "difference { quadric { <1,-1,1>, 0, 0, -4 } plane { y, -1 } plane { -y, -1 }"
        " sphere { <1,0,-1>, 1 } }",
        "quadric { <1,0,1>, 0, <0,-1,0>, -1 clipped_by { plane { y, 3 } } }",
        "quadric { <1,0,1>, 0, <.5,-1,0>, 0 clipped_by { plane { y, 3 } plane { -y, 0 } } }",
        "merge { intersection { quadric { <1,0,1>, 0, <0,-1,0>, -1 } plane { y, 3 } } sphere { "
        "2*x, 1 } }"));

/// Nothing of these extends beyond the box in stock.
TEST(ImageClipBoxesList, HideNothing) {
  for (const std::string shape :
       {"intersection { quadric { <1,0,1>, 0, 0, -1 } object { H } }",
        "quadric { <1,2,1>, 0, 0, -4 clipped_by { plane { y, 0 } } rotate 40*z }"}) {
    EXPECT_TRUE(looks_the_same(shape)) << shape;
    EXPECT_TRUE(looks_the_same(shape + kFloor)) << shape;
    EXPECT_EQ(turned_away(shape), 0u) << shape;
  }
}

/// Half of space counts as the inside of a disc, but in an intersection rays must meet its own flat box: the glass
/// paperweight of the example advanced/desk.
INSTANTIATE_TEST_SUITE_P(
    Discs, ImageClipBoxes,
    ::testing::Values("intersection { sphere { -3*y, 5 } disc { 0, -y, 5.1 } }"));

/// The boxes hide nothing here: a part of a union in the list has its own, and one that is turned grows.
TEST(ImageClipBoxesList, TurnedAndInUnions) {
  for (const std::string& shape :
       {"union { quadric { <1,.1,1>, 0, 0, -1 scale .9" + kByField + "} sphere { <2,0,-2>, .3 } }",
        std::string("intersection { sphere { -3*y, 5 } disc { 0, -y, 5.1 } rotate 20*x }"),
        std::string("union { sphere { 3*y, .5 } intersection { sphere { -3*y, 5 } disc { 0, -y, "
                    "5.1 } } }")}) {
    EXPECT_TRUE(looks_the_same("object { " + shape + " }")) << shape;
    EXPECT_TRUE(looks_the_same("object { " + shape + " }" + kFloor)) << shape;
    EXPECT_EQ(turned_away("object { " + shape + " }"), 0u) << shape;
  }
}

/// Parts of a union of the list are objects of their own, with what they do not show or hide.
TEST(ImageClipBoxesList, PartsOfUnionsKeepTheirLooks) {
  for (const std::string looks : {"no_shadow", "no_image", "no_reflection", ""}) {
    EXPECT_TRUE(looks_the_same("union { union { torus { 2.5, 1 rotate 90*x } " + looks + kByField +
                               "} sphere { <2,1,-2>, .6 } }"
                               " plane { y, -1 finish { reflection .4 } }"))
        << looks;
  }
}

/// The boxes of a CSG's parts are not asked, only that of the whole.
TEST(ImageClipBoxesList, PartsOfACsg) {
  for (const std::string shape :
       {"sphere { 0, 5", "cylinder { -5*y, 5*y, 5", "superellipsoid { <.5,.5> scale 5",
        "blob { threshold .3 sphere { 0, 8, 1 }"}) {
    EXPECT_TRUE(looks_the_same("union { " + shape + kByField +
                               "} sphere { 5*x, .2 } bounded_by { sphere { 0, 99 } } }"))
        << shape;
    EXPECT_TRUE(looks_the_same("merge { " + shape + kByField + "} sphere { 9*x, 1 } }")) << shape;
    EXPECT_TRUE(looks_the_same("difference { " + shape + kByField + "} sphere { 0, 4.9 } }"))
        << shape;
  }
}

}  // namespace
}  // namespace lentray::test
