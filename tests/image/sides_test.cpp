// Which side of a surface is its inside, for `interior_texture`, against stock: triangles, which turn round with the
// steps of their transforms, quadrics, and shapes whose surface has textures of its own.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "tests/image/floor_scene.h"

namespace lentray::test {
namespace {

const std::string kSidesLooks = " pigment { rgb x } interior_texture { pigment { rgb y } } ";

const std::vector<std::string> kSteps{"scale 1.2",
                                      "rotate 107*x",
                                      "rotate <107,26,-132>",
                                      "rotate 40*z rotate 160*x",
                                      "scale <-1,1,1>",
                                      "rotate 180*x",
                                      "matrix <1,0,0,0,1,0,0,0,-1,0,0,0>",
                                      "translate .1 translate -.1",
                                      "rotate 90*y scale <1,-1,1>"};

/// One of each kind of steps, side by side; `last` is the step that puts them there.
std::string sides_row(const std::string& one, const std::string& around, const std::string& last) {
  std::string all;
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    const std::string place =
        "translate <" + std::to_string(i % 3) + "-1," + std::to_string(i / 3) + "*.7-.8,0>";
    all += around + "{ " + one + kSteps[i] + " } scale .4 " + last + " " + place + " }\n";
  }
  return all;
}

TEST(ImageTriangleSides, TurnWithEachStep) {
  for (const char* corner : {"<.383,.944,.228>", "<.383,-.3,.228>"}) {
    const std::string one = "triangle { " + std::string(corner) +
                            ", <.522,-.687,.628>, <.596,-.056,.978>" + kSidesLooks;
    EXPECT_TRUE(same_on_the_floor(sides_row(one, "object", "")));
    EXPECT_TRUE(same_on_the_floor(sides_row(one, "union", "rotate 170*y")));
    EXPECT_TRUE(same_on_the_floor(
        sides_row(one, "union { sphere { 0, .1 } union", "} rotate 100*x rotate 90*y")));
  }
}

/// As a normal comes over to the other side of its triangle, stock drops the triangle for good.
TEST(ImageTriangleSides, SmoothOnesAreDropped) {
  const std::string one =
      "smooth_triangle { <-.06,.025,.927>, <.652,.251,.595>, <-.452,-.745,-.828>, <.17,.533,.682>,"
      " <-.665,-.275,-.742>, <.306,.795,.944> pigment { rgb x } ";
  const std::string first = "scale <1.111,.805,.688> ", second = "scale <1.157,.945,.88> ",
                    composed = "matrix <1.111,0,0,0,.805,0,0,0,.688,0,0,0> ";
  std::string all;
  int i = 0;
  for (const std::string& steps :
       {std::string(), first, second, first + second, composed + second}) {
    const std::string place = "translate <" + std::to_string(i++) + "*.6-1.2,0,0>";
    all += one + steps + "scale .6 " + place + " }\n";
    all += "union { " + one + "} sphere { x, .2 } " + steps + "scale .6 " + place +
           " translate .8*y }\n";
  }
  EXPECT_TRUE(same_on_the_floor(all));
}

struct SidesCase {
  const char* name;
  const char* sdl;
};

class ImageSides : public ::testing::TestWithParam<SidesCase> {};

TEST_P(ImageSides, OfTheInverse) {
  const std::string part = std::string(GetParam().sdl) + kSidesLooks,
                    box = "box { <-1.2,-1.2,-.4>, <1.2,.31,.33> pigment { rgb z } } ";
  const std::string place[] = {"scale .5 translate <-1.1,.5,0> }", "scale .5 translate <.1,.5,0> }",
                               "scale .5 translate <-.6,-.7,0> }",
                               "scale .5 translate <.6,-.7,0> }"};
  EXPECT_TRUE(same_on_the_floor(
      part + place[0] + part + "clipped_by { plane { x+z, .1 inverse } } " + place[1] +
      "difference { " + box + part + "} " + place[2] + "difference { " + box +
      "difference { box { -2, <2,.3,2> } " + part + "} } " + place[3]));
  EXPECT_TRUE(same_on_the_floor(part + "inverse clipped_by { box { -1, .9 } } " + place[0] +
                                "intersection { " + box + part + "} " + place[1] + "difference { " +
                                box + part + "inverse } " + place[2] + "intersection { " + box +
                                part + "inverse } " + place[3]));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageSides,
    ::testing::Values(
        SidesCase{"sphere", "sphere { 0, .7"}, SidesCase{"plane", "plane { x+y, .1"},
        SidesCase{"cone", "cone { -x, .2, x, .7"},
        SidesCase{"double_cone", "cone { -x, -.4, x, .7"},
        SidesCase{"open_double_cone", "cone { -x, -.4, x, .7 open"},
        SidesCase{"poly", "poly { 2, <1,.3,.2,0,2,.1,.1,1.5,0,-.5>"},
        SidesCase{"blob", "blob { threshold .4 sphere { -.3*x, .8, 1 } sphere { .3*x, .8, 1 }"},
        SidesCase{"blob_of_textures",
                  "blob { threshold .4 sphere { -.3*x, .8, 1 pigment { rgb <.5,.5,1> } }"
                  " sphere { .3*x, .8, 1 } sphere { 0, .3, -1.5 pigment { rgb x+y } }"}),
    [](const auto& one) { return std::string(one.param.name); });

/// Quadrics, and meshes without an inside, whose sides differ from stock's once they are inverse (docs/language.md).
class ImageSidesAsTheyStand : public ::testing::TestWithParam<SidesCase> {};

TEST_P(ImageSidesAsTheyStand, Alone) {
  const std::string part = std::string(GetParam().sdl) + kSidesLooks;
  EXPECT_TRUE(
      same_on_the_floor(part + "scale .5 translate <-1.1,.3,0> }" + part +
                        "clipped_by { plane { x+z, .1 inverse } } scale .5 translate <.1,.3,0> }"
                        "intersection { box { -1, <1,.4,1> pigment { rgb z } } " +
                        part + "} scale .5 translate <1.1,.3,0> }"));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageSidesAsTheyStand,
    ::testing::Values(
        SidesCase{"quadric", "quadric { <1,2,1.5>, <.3,.2,.1>, <0,.1,0>, -.5"},
        SidesCase{"hyperboloid", "quadric { <-.7,-.4,1.4>, <.36,.85,.53>, <.2,.28,.13>, -.24"},
        SidesCase{"mesh",
                  "mesh { triangle { <-1,-.06,0>, <1,.03,0>, <-1,1,.3> } triangle { <1,.03,0>, "
                  "<-1,1,.3>, <1,1,-.4> }"},
        SidesCase{"mesh_of_textures",
                  "mesh2 { vertex_vectors { 4, <-1,-.06,0>, <1,.03,0>, <-1,1,.3>, <1,1,-.4> } "
                  "texture_list { 2,"
                  " texture { pigment { rgb x+z } }, texture { pigment { rgb z } } }"
                  " face_indices { 2, <0,1,2>, 0, 1, 1, <1,2,3>, 1 }"}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
