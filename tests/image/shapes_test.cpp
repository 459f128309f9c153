// Primitives against stock: each alone, and cut open and joined by CSG, which asks for all hits and
// for inside().
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kShapesStage = R"(#version 3.7; #include "functions.inc"
global_settings { assumed_gamma 1 }
camera { location <2.2,2.6,-4> look_at <0,.4,0> angle 45 }
light_source { <-4,7,-6>, 1 }
light_source { <5,3,-2>, .3 }
plane { y, -1.2 pigment { checker rgb .9 rgb .5 } }
)";

struct ShapesCase {
  const char* name;
  const char* sdl;
  bool with_solids = true;  ///< has an inside
  Grade grade = Grade::exact;
};

// The points of a bicubic patch.
#define PATCH                                                                                     \
  "<-1.4,-.5,-1>,<-.5,.8,-1.2>,<.5,-.6,-1>,<1.4,.4,-1>,<-1.5,.3,-.4>,<-.5,-.5,-.3>,<.5,1.9,-.4>," \
  "<1.5,0,-.2>,<-1.3,-.4,.4>,<-.4,.9,.3>,<.4,-.8,.5>,<1.4,.7,.4>,<-1.4,.5,1.1>,<-.5,-.2,1>,"      \
  "<.5,.6,1.3>,<1.3,-.3,1> "

const ShapesCase kShapesCases[] = {
    {"text", "text { ttf \"cyrvetic.ttf\" \"R&g8\" .4, <.05,.02,0> scale 1.3 translate -1.4*x }"},
    {"text_timrom", "text { internal 1 \"AVoid\" .3, 0 translate -1.3*x }"},
    {"prism_linear",
     "prism { -.5, .7, 10 <-1,-1>,<1,-1>,<1,1>,<0,.2>,<-1,1>,<-1,-1>"
     " <-.3,-.7>,<.3,-.7>,<0,0>,<-.3,-.7> }"},
    {"prism_quadratic",
     "prism { quadratic_spline 0, .6, 7 <-1,1>,<-1,-1>,<1,-1>,<1.2,.4>,<0,1>,<-1,-1>,<0,0> }"},
    {"prism_cubic",
     "prism { cubic_spline 0, .6, 7 <0,1>,<-1,-1>,<1,-1>,<1.2,.4>,<0,1>,<-1,-1>,<1,-1> }"},
    {"prism_bezier",
     "prism { bezier_spline 0, .6, 8 <0,-1>,<1.5,-1>,<1,.5>,<0,.6>"
     " <0,.6>,<-1,.5>,<-1.5,-1>,<0,-1> rotate x*-20 }"},
    {"prism_open", "prism { 0, .8, 5 <-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1> open }", false},
    {"prism_conic",
     "prism { conic_sweep linear_spline .2, 1, 5 <-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1>"
     " translate -.4*y }"},
    {"prism_conic_cubic",
     "prism { conic_sweep cubic_spline 0, 1, 7 <0,1>,<-1,-1>,<1,-1>,<1.2,.4>,"
     "<0,1>,<-1,-1>,<1,-1> rotate x*180 translate .6*y }"},
    {"superellipsoid", "superellipsoid { <.3,.5> }"},
    {"superellipsoid_sharp", "superellipsoid { <1.8,.2> scale <1,1,.6> rotate 20*x }"},
    {"superellipsoid_concave", "superellipsoid { <2.6,2.2> scale 1.2 }"},
    {"quartic_torus",
     "quartic { <1,0,0,0,2,0,0,2,0,-2.32,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,1.68,0,0,0,0,"
     "1,0,-2.32,0,.7056> bounded_by { box { -2, 2 } } }"},
    {"cubic",
     "cubic { <1,0,0,0,0,0,0,0,0,0,0,0,-1,0,0,0,0,-.3,0,0> clipped_by { sphere { 0, 1.4 } } }",
     false},
    {"poly6",
     "poly { 6, <1,0,0,0,3,0,0,3,0,0,0,0,0,0,0,0,0,0,0,0,3,0,0,-12,0,0,0,0,0,0,3,0,0,0,0,0,0,0,"
     "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,3,0,0,0,0,0,0,3,0,0,0,0,0,0,0,0,0,0,"
     "1,0,0,0,0,0,-1> scale 1.1 }"},
    {"blob",
     "blob { threshold .5 sphere { <.4,0,0>, 1, 1 } cylinder { <-1,-.2,0>, <.5,.9,.2>, .6, 1.1 }"
     " sphere { <0,.5,-.5>, .5, -.8 scale <1,1.4,1> } }"},
    {"blob_textures",
     "blob { threshold .4 sphere { <.5,0,0>, 1, 1 pigment { rgb x } }"
     " cylinder { <-1,-.2,0>, <.5,.9,.2>, .6, 1 texture { pigment { rgb z }"
     " finish { phong 1 } } rotate 10*y } sphere { <0,-.6,0>, .7, 1 } rotate 30*y }"},
    {"isosurface",
     "isosurface { function { x*x + y*y*2 + z*z - 1 + .1*sin(x*15)*sin(z*14) }"
     " max_gradient 6 contained_by { box { -1.2, 1.2 } } }"},
    {"isosurface_cut",
     "isosurface { function { sqrt(x*x + y*y) - .3 - .2*abs(z) } max_gradient 2 all_intersections"
     " contained_by { sphere { 0, 1.1 } } rotate 40*y }"},
    {"isosurface_open",
     "isosurface { function { y + f_noise3d(x*3, 0, z*3)*.6 } max_gradient 3 open"
     " contained_by { box { <-1.2,-.9,-1.2>, <1.2,.5,1.2> } } }",
     false},
    {"isosurface_evaluate_begins_at_max_gradient",
     "isosurface { function { 6*y - sin(3*x)*2 - z*z } max_gradient 9"
     " evaluate 1, 1, 1 contained_by { box { -1, 1 } } }",
     false},
    {"isosurface_evaluate",
     "isosurface { function { f_ridged_mf(x, 0, z, .8, 2, 5, .9, 2, 3)*.4 - .5 - y + y*y }"
     " evaluate 2, 1.1, .8 threshold -.2 contained_by { box { -1, 1 } } }",
     false},
    {"bicubic_patch", "bicubic_patch { type 1 u_steps 3 v_steps 4 " PATCH "}", false},
    {"patch_many_steps", "bicubic_patch { type 1 u_steps 9 v_steps 9 " PATCH "}", false},
    {"patch_many_u", "bicubic_patch { type 1 u_steps 12 v_steps 1 " PATCH "}", false},
    {"patch_flatness", "bicubic_patch { type 1 flatness .1 u_steps 4 v_steps 4 " PATCH "}", false},
    {"patch_flatness_type_0", "bicubic_patch { type 0 flatness .5 u_steps 5 v_steps 5 " PATCH "}",
     false},
    {"patch_flatness_more_v", "bicubic_patch { type 1 flatness .02 u_steps 1 v_steps 5 " PATCH "}",
     false},
    {"patch_flatness_more_u", "bicubic_patch { type 0 flatness .05 u_steps 5 v_steps 2 " PATCH "}",
     false},
    {"patch_flatness_scaled",
     "bicubic_patch { type 1 flatness .02 u_steps 5 v_steps 5 " PATCH
     " scale <.9,.3,.8> rotate 20*y }",
     false},
    {"patch_flatness_mirrored",
     "union { bicubic_patch { type 1 flatness .2 u_steps 5 v_steps 5 " PATCH
     " scale <-1,1,1> } rotate 50*x }",
     false},
    {"patch_flatness_point",
     "bicubic_patch { type 1 flatness .1 u_steps 4 v_steps 4 <0,1,0>,<0,1,0>,<0,1,0>,"
     "<0,1,0>,<-1,1,-1>,<-.5,1,-1.2>,<.5,1,-1>,<1,1,-1>,<-1.4,.5,-.4>,<-.5,.5,-1.6>,"
     "<.5,.6,-1.4>,<1.4,.2,-1>,<-1.4,-1,-.3>,<-.5,-1,-1.4>,<.5,-1,-1.4>,<1.4,-.9,-1> }",
     false},
    {"lathe_linear", "lathe { 5 <0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9> }"},
    {"lathe_quadratic",
     "lathe { quadratic_spline 6 <.3,-1>,<0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9> }"},
    {"lathe_cubic",
     "lathe { cubic_spline 7 <.3,-1>,<0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9>,<.2,1> }"},
    {"lathe_bezier",
     "lathe { bezier_spline 8 <0,-.9>,<1,-1>,<1,-.3>,<.5,0> <.5,0>,<.3,.5>,<1,.8>,<0,.9>"
     " rotate 20*x }"},
    {"sor", "sor { 7 <0,-1>,<.5,-.9>,<.9,-.3>,<.3,.2>,<.6,.8>,<.2,1>,<0,1.1> }"},
    {"sor_open",
     "sor { 6 <.4,-1.2>,<.5,-.9>,<1,-.2>,<.4,.4>,<.7,.9>,<.9,1.1> open sturm rotate 25*x }", false},
    {"ovus", "ovus { .8, .45 translate -.3*y }"},
    {"ovus_top_heavy", "ovus { .5, .8 rotate 160*z translate .3*y }"},
    {"ovus_sphere", "ovus { .4, .9 }"},
    {"sweep_linear",
     "sphere_sweep { linear_spline 4 <-1,-.6,0>,.3 <0,.8,-.3>,.15 <.9,-.4,.4>,.4"
     " <1.2,.6,0>,.1 }"},
    {"sweep_linear_square", "sphere_sweep { linear_spline 3 <-1,0,0>,.3 <1,0,0>,.3 <1,1,0>,.2 }"},
    {"sweep_cubic",
     "sphere_sweep { cubic_spline 6 <-2,0,0>,.2 <-1,-.6,0>,.3 <0,.8,-.3>,.15"
     " <.9,-.4,.4>,.4 <1.2,.6,0>,.1 <2,1,0>,.2 tolerance 1e-5 }"},
    {"sweep_b",
     "sphere_sweep { b_spline 6 <-2,0,0>,.2 <-1,-.9,0>,.3 <0,1.4,-.3>,.25 <.9,-.8,.4>,.4"
     " <1.2,.9,0>,.3 <2,1,0>,.2 rotate 20*z }",
     true, Grade::match},
    {"height_field",
     "height_field { png \"plasma3.png\" water_level .2 scale <2.4,1.2,2.4>"
     " translate <-1.2,-.6,-1.2> }",
     true, Grade::match},
    {"height_field_wrapped",
     "height_field { function 20, 16 { x*3 - 1 } scale <2.4,1.2,2.4> translate <-1.2,-.6,-1.2> }"},
    {"height_field_gamma",
     "#fopen F \"h.pgm\" write #write (F, \"P2\\n3 3\\n255\\n10 127 200 90 250 60 170 30 "
     "220\\n\")\n#fclose F\n"
     "height_field { pgm \"h.pgm\" gamma 2.2 scale <2.4,1.2,2.4> translate <-1.2,-.6,-1.2> }"},
    {"height_field_smooth",
     "height_field { function 40, 30 { .5 + .4*sin(x*9)*cos(y*8) } smooth"
     " scale <2.4,1.2,2.4> translate <-1.2,-.6,-1.2> rotate 15*z }"},
};

class ImageShapes : public ::testing::TestWithParam<ShapesCase> {};

TEST_P(ImageShapes, Alone) {
  const std::string sdl = std::string(kShapesStage) + "object { " + GetParam().sdl +
                          " pigment { rgb <.9,.5,.3> } finish { specular .4 reflection .2 } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl, .width = 120, .height = 90, .arguments = {}, .files = {}},
                            GetParam().grade));
}

using ImageShapesSolids = ImageShapes;

TEST_P(ImageShapesSolids, InCsg) {
  const std::string one = std::string("object { ") + GetParam().sdl + " }";
  const std::string sdl = std::string(kShapesStage) + "difference { " + one +
                          " sphere { <.4,.4,-.8>, .7 } pigment { rgb <.3,.7,.9> } }\n"
                          "intersection { " +
                          one +
                          " box { <-2,-.1,-2>, <2,.1,2> }"
                          " translate <-1.2,1.4,1.5> pigment { rgb <.8,.9,.3> } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl, .width = 120, .height = 90, .arguments = {}, .files = {}},
                            GetParam().grade));
}

/// Normals of smooth triangles become units with `scale`, not with `matrix` or `transform`.
TEST(ImageShapesSmoothTriangle, Transformed) {
  const std::string triangle =
      "smooth_triangle { "
      "<-.5,-.5,0>,<-.6,-.4,-.5>,<.5,-.5,.1>,<.7,-.1,-.4>,<0,.5,-.1>,<.1,.9,-.5> ";
  const std::string shear = "matrix <1,0,0,.5,1,0,.6,0,1,0,0,0> ";
  const std::vector<std::string> moves = {shear,
                                          shear + "scale <1,1,2>",
                                          "scale <1,1,3> " + shear,
                                          "scale <2,1,.5> rotate 20*z",
                                          "matrix <1,0,0,0,1,0,0,0,3,0,0,0>",
                                          "transform { scale <1,1,.4> rotate 20*z }",
                                          "scale <1,1,2> " + shear + "scale <1,.8,1> rotate 10*x"};
  std::string sdl = kShapesStage;
  for (std::size_t i = 0; i < 2 * moves.size(); ++i) {
    const std::string& move = moves[i % moves.size()];
    sdl +=
        i < moves.size() ? triangle + move : "union { " + triangle + "} sphere { 9*y, .1 } " + move;
    sdl += " translate <" + std::to_string(.9 * double(i % 5) - 1.8) + "," +
           std::to_string(.9 * double(i / 5) - .8) +
           ",0> pigment { rgb <.9,.5,.3> } finish { phong .8 } }\n";
  }
  EXPECT_TRUE(
      same_as_stock({.sdl = sdl, .width = 160, .height = 120, .arguments = {}, .files = {}}));
}

/// The solid goes down without end, below the field's box too.
TEST(ImageShapesHeightField, SolidBelowItsBox) {
  const std::string field =
      "height_field { function 40, 30 { .5 + .2*sin(x*9)*cos(y*8) } scale <2.4,1.2,2.4>";
  const std::string sdl = std::string(kShapesStage) + "intersection { " + field +
                          " translate <-1.2,-.3,-1.2> } box { <-.8,-1.1,-.8>, <.8,.5,.8> }"
                          " pigment { rgb <.3,.7,.9> } }\n"
                          "difference { box { <-2,-1.1,1.3>, <2,1,3> } " +
                          field +
                          " translate <-1.2,-.6,.8> }"
                          " pigment { rgb <.9,.7,.3> } }";
  EXPECT_TRUE(
      same_as_stock({.sdl = sdl, .width = 120, .height = 90, .arguments = {}, .files = {}}));
}

std::vector<ShapesCase> shapes_with_solids() {
  std::vector<ShapesCase> solids;
  std::copy_if(std::begin(kShapesCases), std::end(kShapesCases), std::back_inserter(solids),
               [](const ShapesCase& c) { return c.with_solids; });
  return solids;
}

std::string shapes_name(const ::testing::TestParamInfo<ShapesCase>& one) { return one.param.name; }

INSTANTIATE_TEST_SUITE_P(Each, ImageShapes, ::testing::ValuesIn(kShapesCases), shapes_name);
INSTANTIATE_TEST_SUITE_P(Each, ImageShapesSolids, ::testing::ValuesIn(shapes_with_solids()),
                         shapes_name);

}  // namespace
}  // namespace lentray::test
