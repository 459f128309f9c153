// bounded_by tighter than the object, against stock: text is cut by it; blobs, height fields and julia
// fractals heed it but in their own braces. Lights cast no shadows: those of stock change with the order of rays.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

SceneText own_bounds_scene(const std::string& objects) {
  return {.sdl =
              "#version 3.7; global_settings { assumed_gamma 1 }\n"
              "camera { location <0,1.5,-6> angle 42 look_at <0,.7,0> }\n"
              "light_source { <-4,7,-6>, .8 shadowless }\n"
              "light_source { <5,9,-7>, .2 shadowless }\n"
              "#default { pigment { rgb <.9,.7,.3> } finish { ambient .2 } }\n"
              "plane { y, -1 pigment { checker rgb .9 rgb .4 } finish { reflection .3 } }\n" +
              objects,
          .width = 100,
          .height = 75,
          .arguments = {},
          .files = {}};
}

testing::AssertionResult own_bounds_looks_the_same(const std::string& objects) {
  return same_as_stock(own_bounds_scene(objects));
}

bool same_picture(const std::string& objects, const std::string& others) {
  return bool(same_bits(lentray_render(own_bounds_scene(objects)),
                        lentray_render(own_bounds_scene(others))));
}

const std::string kBound = " bounded_by { sphere { <.2,.8,0>, .5 } } ";

struct OwnBoundsCase {
  const char* name;
  const char* sdl;
};

class ImageOwnBounds : public ::testing::TestWithParam<OwnBoundsCase> {};

TEST_P(ImageOwnBounds, InItsBraces) {
  EXPECT_TRUE(own_bounds_looks_the_same(GetParam().sdl + kBound + "}"));
}

TEST_P(ImageOwnBounds, InBracesAround) {
  EXPECT_TRUE(
      own_bounds_looks_the_same("object { " + std::string(GetParam().sdl) + "}" + kBound + "}"));
}

/// Where it is heeded it cuts: else the other tests would prove nothing.
TEST_P(ImageOwnBounds, TheBoundMatters) {
  const std::string alone = "object { " + std::string(GetParam().sdl) + "}";
  EXPECT_FALSE(same_picture(alone + kBound + "}", alone + "}"));
}

TEST_P(ImageOwnBounds, OfAPart) {
  EXPECT_TRUE(own_bounds_looks_the_same("merge { " + std::string(GetParam().sdl) + kBound +
                                        "} sphere { 2*x, .2 } }"));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageOwnBounds,
    ::testing::Values(
        OwnBoundsCase{"text",
                      "text { ttf \"crystal.ttf\" \"ABC\" .3, 0 translate -x scale <1.5,2,1>"},
        OwnBoundsCase{"blob", "blob { threshold .3 sphere { y, 1.3, 1 }"},
        OwnBoundsCase{"height_field",
                      "height_field { png \"plasma2.png\" translate <-.5,0,-.5> scale <3,2,3>"},
        OwnBoundsCase{
            "julia_fractal",
            "julia_fractal { <-.2,.8,0,0> quaternion max_iteration 6 precision 20 translate .8*y"},
        OwnBoundsCase{"isosurface",
                      "isosurface { function { x*x+y*y+z*z-1 } contained_by { box { -1.1, 1.1 } }"
                      " max_gradient 4 translate y"}),
    [](const auto& one) { return std::string(one.param.name); });

/// A patch is not cut by what clips it, which only lends its box.
TEST(ImageOwnBounds, ClipsOfAPatch) {
  const std::string patch =
      "bicubic_patch { type 1 u_steps 3 v_steps 3 flatness 0"
      " <-1,.2,-.9>, <-.4,1.2,-.9>, <.4,.1,-.8>, <.9,.6,-.9>, <-1,.5,-.4>, <-.4,1.1,-.3>, "
      "<.3,.3,-.2>,"
      " <.9,1.2,-.4>, <-.9,0,.2>, <-.2,.7,.2>, <.3,1,.2>, <1,.3,.3>, <-.8,.3,.9>, <-.2,1,.8>, "
      "<.2,.1,.9>,"
      " <1,1.1,.8> ";
  for (const char* clip : {"sphere { .5*y, .6 }", "box { -.5, .8 }", "plane { x, 0 }",
                           "box { -.5, .8 inverse }", "box { -.5, .8 } plane { x, 0 }"}) {
    const std::string clipped = patch + "clipped_by { " + std::string(clip) + " } rotate 20*y }";
    EXPECT_TRUE(own_bounds_looks_the_same("object { " + clipped + " translate -1.3*x } union { " +
                                          clipped +
                                          " sphere { x, .2 } }"
                                          "difference { box { <-1,0,-.7>, <.8,.6,1> } " +
                                          clipped + " translate <2,.5,1> }"))
        << clip;
  }
}

/// Surfaces of other parts are seen inside a bounded part beyond its bounds, as far as the whole has stock's box.
class ImageBoundsOfCutParts : public ::testing::TestWithParam<OwnBoundsCase> {};

TEST_P(ImageBoundsOfCutParts, InAnIntersection) {
  EXPECT_TRUE(own_bounds_looks_the_same("intersection { " + std::string(GetParam().sdl) + kBound +
                                        "} box { -2, <.3,1.1,2> } }"));
}

TEST_P(ImageBoundsOfCutParts, InUnions) {
  const std::string part = std::string(GetParam().sdl) + kBound + "} ";
  EXPECT_TRUE(own_bounds_looks_the_same("intersection { union { " + part +
                                        "sphere { x, .3 } } box { -2, <1.3,1.1,2> } }"));
  EXPECT_TRUE(own_bounds_looks_the_same("union { sphere { 2*x, .3 } intersection { " + part +
                                        "box { -2, <.3,1.1,2> } } }"));
}

TEST_P(ImageBoundsOfCutParts, InADifference) {
  EXPECT_TRUE(own_bounds_looks_the_same("difference { box { <-2,-.9,-1>, <1,1.1,1> } " +
                                        std::string(GetParam().sdl) + kBound + "} }"));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageBoundsOfCutParts,
    ::testing::Values(
        OwnBoundsCase{"sphere", "sphere { .8*y, 1"},
        OwnBoundsCase{"box", "box { <-1,0,-1>, <1,1.8,1> rotate 20*y"},
        OwnBoundsCase{"union", "union { sphere { .8*y, 1 } box { 0, 1.3 }"},
        OwnBoundsCase{"disc", "disc { <0,.8,0>, <.2,.3,-1>, 1.2"},
        OwnBoundsCase{"cubic", "cubic { <1,0,0,0,0,0,0,0,0,1,0,0,0,1,0,0,0,-1,0,0> translate .3*y"},
        OwnBoundsCase{"sor", "sor { 6, <.6,-.5>, <.8,0>, <1,.5>, <.6,1>, <.8,1.5>, <.5,2>"},
        OwnBoundsCase{"lathe",
                      "lathe { linear_spline 6, <0,-.5>, <.8,0>, <1,.5>, <.6,1>, <.8,1.5>, <0,2>"},
        OwnBoundsCase{
            "prism",
            "prism { linear_sweep linear_spline 0, 1.5, 5, <-1,-1>, <1,-1>, <1.2,1>, <-.8,.9>, "
            "<-1,-1> scale .9"},
        OwnBoundsCase{"superellipsoid", "superellipsoid { <.4,.3> translate .8*y"},
        OwnBoundsCase{"sphere_sweep",
                      "sphere_sweep { linear_spline 3, <-1,0,0>, .4, <0,1.6,0>, .5, <1,.3,0>, .3"}),
    [](const auto& one) { return std::string(one.param.name); });

/// Bounds of quadrics become boxes but for products of two coordinates, cones and hyperboloids of one sheet.
class ImageQuadricBounds : public ::testing::TestWithParam<const char*> {};

TEST_P(ImageQuadricBounds, AsStock) {
  EXPECT_TRUE(own_bounds_looks_the_same("quadric { " + std::string(GetParam()) + kBound + "}"));
}

#define BOX " clipped_by { box { -2, <2,1.6,2> } }"
INSTANTIATE_TEST_SUITE_P(
    Each, ImageQuadricBounds,
    ::testing::Values("<1,1,1>, 0, <0,-2,0>, 0", "<1,0,1>, 0, 0, -.6", "<1,0,1>, 0, 0, -.6" BOX,
                      "<1,0,1>, 0, 0, -.6 rotate 30*z", "<1,0,1>, 0, <0,-1,0>, 0",
                      "<0,0,1>, 0, 0, -.01", "<-1,1,-1>, 0, 0, -.1", "<1,-1,1>, 0, 0, 0",
                      "<1,-1,1>, 0, 0, 0" BOX,
                      "<1,-1,1>, 0, 0, 0 clipped_by { plane { y+.2*x, 1.6 } }",
                      "<1,-1,1>, 0, 0, 0 clipped_by { sphere { y, .3 inverse } }",
                      "<1,-1,1>, 0, 0, -.1 rotate 30*z", "<1,1,1>, <.2,.1,0>, <0,-2,0>, 0",
                      "<1,1,1>, <.2,.1,0>, <0,-2,0>, 0" BOX));
#undef BOX

}  // namespace
}  // namespace lentray::test
