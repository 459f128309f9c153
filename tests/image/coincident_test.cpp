// Surfaces that coincide, of objects and of parts of CSG. Of objects shows the one whose box the ray enters first.
// Parts of CSG: merged or intersected, stock shows specks and holes there, as rounding
// decides which surface is within the other; the reference is its picture of the solid that they make. What is cut
// away with a wall of its own on a wall of the rest keeps that wall, in both.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kCoincidentStage = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1.2,1.9,-4> look_at 0 angle 50 }
light_source { <-4,7,-6>, 1 } light_source { <5,3,-2>, .3 }
plane { y, -1.7 pigment { checker rgb .9 rgb .5 } }
#default { pigment { rgb <1,.6,.3> } finish { specular .3 } }
)";

SceneText coincident_scene(const std::string& sdl) {
  return {.sdl = kCoincidentStage + sdl, .width = 100, .height = 75, .arguments = {}, .files = {}};
}

struct Twins {
  const char* name;
  std::string shape;
};

class ImageCoincident : public ::testing::TestWithParam<Twins> {};

TEST_P(ImageCoincident, AreOne) {
  const std::string& shape = GetParam().shape;
  const StoredImage alone =
      stock_render(coincident_scene("object { " + shape + " rotate <10,20,0> }"));
  for (const std::string csg : {"merge", "intersection"}) {
    const std::string both =
        csg + " { object { " + shape + " } object { " + shape + " } rotate <10,20,0> }";
    EXPECT_TRUE(reaches(lentray_render(coincident_scene(both)), alone, Grade::exact)) << csg;
    const std::string mirrored = csg + " { object { " + shape + " } object { " + shape +
                                 " rotate 180*y scale <-1,1,-1> } rotate <10,20,0> }";
    EXPECT_TRUE(reaches(lentray_render(coincident_scene(mirrored)), alone, Grade::exact))
        << csg << ", the second as if turned";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageCoincident,
    ::testing::Values(
        Twins{"sphere", "sphere { 0, 1 }"}, Twins{"box", "box { -1, 1 }"},
        Twins{"torus", "torus { .8, .3 }"}, Twins{"cylinder", "cylinder { -y, y, .8 }"},
        Twins{"cone", "cone { -y, 1, y, .2 }"},
        Twins{"lathe", "lathe { 4 <0,-1>,<1,-1>,<.5,1>,<0,1> }"},
        Twins{"prism", "prism { -1, 1, 5 <-1,-1>,<1,-.9>,<1,1>,<-1,1>,<-1,-1> }"},
        Twins{"superellipsoid", "superellipsoid { <.4,.6> }"},
        Twins{"quadric", "quadric { <1,2,1.5>, <.2,.1,0>, <0,.1,0>, -1 }"},
        Twins{"sor", "sor { 7 <0,-1>,<.5,-.9>,<.9,-.3>,<.3,.2>,<.6,.8>,<.2,1>,<0,1.1> }"},
        Twins{"sphere_sweep",
              "sphere_sweep { linear_spline 3 <-1,-.6,0>,.3 <0,.8,-.3>,.15 <.9,-.4,.4>,.4 }"},
        Twins{"text", "text { ttf \"cyrvetic.ttf\" \"R&\" .4, 0 translate <-.7,-.3,-.2> }"},
        Twins{"ovus", "ovus { .8, .45 translate -.3*y }"}),
    [](const auto& one) { return std::string(one.param.name); });

/// Walls of one plane, roofs and floors apart.
TEST(ImageCoincidentWalls, OfStackedParts) {
  const std::string outline = ", 5 <-1,-1>,<1,-.9>,<1,1>,<-1,1>,<-1,-1> }";
  const std::string low = "prism { -1, .5" + outline, high = "prism { -.5, 1" + outline;
  const auto is = [](const std::string& csg, const std::string& whole) {
    return reaches(lentray_render(coincident_scene(csg)), stock_render(coincident_scene(whole)),
                   Grade::exact);
  };
  EXPECT_TRUE(is("merge { " + low + high + " rotate 30*y }",
                 "object { prism { -1, 1" + outline + " rotate 30*y }"));
  EXPECT_TRUE(is("merge { " + low + high + "}", "prism { -1, 1" + outline));
  EXPECT_TRUE(is("intersection { " + low + high + "}", "prism { -.5, .5" + outline));
  EXPECT_TRUE(is("merge { box { -1, <1,.5,1> } box { <-1,-.5,-1>, 1 } }", "box { -1, 1 }"));
  EXPECT_TRUE(is("intersection { box { -1, <1,.5,1> } box { <-1,-.5,-1>, 1 } }",
                 "box { <-1,-.5,-1>, <1,.5,1> }"));
  EXPECT_TRUE(
      is("merge { cylinder { -y, .5*y, 1 } cylinder { -.5*y, y, 1 } }", "cylinder { -y, y, 1 }"));
}

TEST(ImageCoincidentWalls, StayWhereTheyAreCut) {
  for (const std::string cut : {"box { -1, 1 } box { <-1,-.5,-1>, <1,1.4,1> }",
                                "cylinder { -y, y, 1 } cylinder { -.5*y, 1.5*y, 1 }",
                                "torus { .7, .3 } torus { .7, .3 }"}) {
    EXPECT_TRUE(same_as_stock(coincident_scene("difference { " + cut + " rotate 20*y }"))) << cut;
  }
}

/// What is clear and stands on a table, in either order: a ray leaves it before it comes to the table.
TEST(ImageCoincidentObjects, GlassOnATable) {
  const std::string checks = "pigment { checker rgb <.8,.6,.3> rgb <.3,.1,.1> scale .4 } }";
  const std::string glass =
      "texture { pigment { rgbf <.9,1,.95,.9> } finish { reflection .05 } } interior { ior 1.4 } }";
  const std::string glow = "hollow pigment { rgbt 1 } interior { media { emission .5 } } }";
  const std::string parts[] = {"box { <-.8,-.7,-.8>, <.8,.4,.8> " + glass,
                               "box { <-.8,-.7,-.8>, <.8,.4,.8> " + glow,
                               "prism { -.7, .4, 4 <-.8,-.8>, <.8,-.8>, <0,.8>, <-.8,-.8> " + glow};
  for (const std::string& table :
       {"box { <-2,-1,-2>, <2,-.7,2> " + checks,
        "union { box { <-2,-1,-2>, <2,-.7,2> } box { <-2,-2,-2>, <-1.7,-.7,2> } " + checks}) {
    for (const std::string& part : parts) {
      for (const std::string& both : {table + part, part + table}) {
        const SceneText scene = coincident_scene(both);
        EXPECT_TRUE(same_as_stock(scene)) << both;
        const StoredImage picture = lentray_render(scene);
        for (const char* accelerator : {"Accelerator=list", "Accelerator=grid"})
          EXPECT_TRUE(same_bits(picture, lentray_render(scene, {accelerator}))) << both;
      }
    }
  }
}

/// Round ends are where their planes are, to the last bit: no specks of a floor below the end.
TEST(ImageCoincidentObjects, RoundEndsOnAFloor) {
  const std::string floor = "plane { y, 0 pigment { checker rgb .9 rgb .2 } } ";
  const std::string glow = "hollow pigment { rgbt 1 } interior { media { emission .3 } } }";
  for (const std::string part : {"cylinder { 0, 1.3*y, .8 ", "cone { 0, .9, 1.3*y, .3 "}) {
    const StoredImage together = lentray_render(coincident_scene(floor + part + glow));
    // Of the plane and what stands on it a ray comes to the plane first, as if the solid went on below.
    const std::string deeper =
        part[1] == 'y' ? "cylinder { -y, 1.3*y, .8 " : "cone { -1.3*y, 1.5, 1.3*y, .3 ";
    const StoredImage through = lentray_render(coincident_scene(floor + deeper + glow));
    EXPECT_TRUE(reaches(together, through, Grade::exact)) << part;
  }
}

}  // namespace
}  // namespace lentray::test
