// What asks the surface and not only the point: uv_mapping, slope, aoi, thin films; and densities
// from files.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kSurfacePatternsStage = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1.6,2.2,-4> look_at <0,.1,0> angle 42 }
light_source { <-4,7,-6>, 1 }
light_source { <5,3,-2>, .3 }
plane { y, -1.2 pigment { rgb .7 } }
#declare Squares = pigment { checker rgb <.9,.2,.1> rgb <.1,.4,.9> scale <.125,.25,1> };
#declare Steep = color_map { [0 rgb x] [.3 rgb y] [.6 rgb z] [1 rgb 1] };
)";

struct SurfacePatternsCase {
  const char* name;
  const char* sdl;
  Grade grade = Grade::exact;
};

const SurfacePatternsCase kSurfacePatternsCases[] = {
    {"uv_sphere", "sphere { 0, 1 pigment { uv_mapping Squares } rotate <20,30,10> }"},
    {"uv_box", "box { -.8, .8 texture { uv_mapping pigment { Squares } } rotate 25*y }"},
    {"uv_torus", "torus { .8, .35 pigment { uv_mapping Squares } rotate -30*x }"},
    {"uv_lathe",
     "lathe { 5 <0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9> pigment { uv_mapping Squares } }"},
    {"uv_lathe_bezier",
     "lathe { bezier_spline 8 <0,-.9>,<.9,-.9>,<.9,-.3>,<.4,0>,<.4,0>,<.1,.4>,<1,.7>,<0,.9>"
     " pigment { uv_mapping Squares } }"},
    {"uv_sor",
     "sor { 7 <0,-1>,<.5,-.9>,<.9,-.3>,<.3,.2>,<.6,.8>,<.2,1>,<0,1.1>"
     " pigment { uv_mapping Squares } }"},
    {"uv_ovus", "ovus { .7, .5 pigment { uv_mapping Squares } rotate 20*z }"},
    {"uv_patch",
     "bicubic_patch { type 1 u_steps 3 v_steps 3 uv_vectors <0,0>,<1,0>,<1,1>,<0,1>"
     " <-1.4,-.5,-1>,<-.5,.8,-1.2>,<.5,-.6,-1>,<1.4,.4,-1>,<-1.5,.3,-.4>,<-.5,-.5,-.3>,"
     "<.5,1.9,-.4>,<1.5,0,-.2>,<-1.3,-.4,.4>,<-.4,.9,.3>,<.4,-.8,.5>,<1.4,.7,.4>,"
     "<-1.4,.5,1.1>,<-.5,-.2,1>,<.5,.6,1.3>,<1.3,-.3,1> pigment { uv_mapping Squares } }"},
    {"uv_mesh2",
     "mesh2 { vertex_vectors { 4 <-1,-1,0>,<1,-1,0>,<1,1,.5>,<-1,1,.2> }"
     " uv_vectors { 4 <0,0>,<1,0>,<1,1>,<0,1> } face_indices { 2 <0,1,2>,<0,2,3> }"
     " uv_mapping pigment { Squares } rotate 10*y }"},
    {"uv_mesh_without",
     "mesh { triangle { <-1,-1,0>, <1,-1,0>, <1,1,.5> } triangle { <-1,-1,0>, <1,1,.5>, <-1,1,.2>"
     " uv_vectors <.2,.5>, <.5,.5>, <.7,.9> } pigment { uv_mapping Squares } rotate 10*y }"},
    {"uv_plane_takes_x_y", "cylinder { -.9*y, .9*y, .8 pigment { uv_mapping Squares } }"},
    {"uv_object",
     "sphere { 0, 1 uv_mapping texture { pigment { Squares } finish { phong .6 } }"
     " rotate <20,30,10> scale 1.1 }"},
    {"uv_csg",
     "union { box { -.9, -.1 } sphere { .3, .5 pigment { rgb <.5,.9,.5> } }"
     " sphere { <-.4,.5,-.2>, .5 } uv_mapping pigment { Squares } rotate 20*y }"},
    {"uv_texture_map",
     "sphere { 0, 1 texture { uv_mapping gradient x texture_map {"
     " [.3 pigment { rgb <.9,.8,.1> }] [.7 pigment { Squares } finish { phong 1 }] } }"
     " rotate 30*y }"},
    {"uv_normal",
     "sphere { 0, 1 pigment { rgb .8 } normal { uv_mapping gradient x 1 scale .1 }"
     " finish { phong .5 } rotate 20*x }"},
    {"uv_texture_normal_turned",
     "sphere { 0, 1 texture { uv_mapping pigment { rgb .9 } normal { bumps .5 scale <.1,.03,1> } }"
     " rotate 40*y }"},
    {"uv_texture_normal_stretched",
     "sphere { 0, 1 texture { uv_mapping pigment { rgb .9 } normal { bumps .5 scale <.1,.03,1> } }"
     " scale <1,.6,1.2> rotate 30*x }"},
    {"uv_shadow",
     "sphere { 0, .9 hollow pigment { uv_mapping checker rgbf <1,.2,.2,.9> rgbt <.2,.3,1,.7>"
     " scale .2 } }"},
    {"slope", "sphere { 0, 1 pigment { slope y color_map { Steep } } rotate 40*z }"},
    {"slope_range", "sphere { 0, 1 pigment { slope { <1,2,-1>, .2, .8 } color_map { Steep } } }"},
    {"slope_point_at",
     "box { -.8, .8 pigment { slope { point_at <2,3,-1> } color_map { Steep } } rotate 30 }"},
    {"slope_altitude",
     "torus { .7, .4 pigment { slope { y*2, 0, .9 altitude y, -1, 1 } color_map { Steep } }"
     " rotate 50*x }"},
    {"slope_texture",
     "sphere { 0, 1 texture { slope y texture_map { [.4 pigment { rgb .2 } finish { phong 1 }]"
     " [.7 pigment { rgb <.9,.7,.2> }] } } }"},
    {"slope_of_lower_layer",
     "sphere { 0, 1 texture { pigment { slope y color_map { Steep } } }"
     " texture { pigment { rgbt .6 } normal { gradient x 2 scale .3 } } }"},
    {"aoi", "sphere { 0, 1 pigment { aoi color_map { Steep } } }"},
    {"aoi_shadow",
     "sphere { 0, 1 pigment { aoi color_map { [.5 rgbt <1,0,0,.2>] [1 rgbt <1,1,0,1>] } } }"},
    // A layer's pigment sees the normal that the layer itself makes.
    {"slope_own_bumps",
     "sphere { 0, 1 pigment { slope y color_map { Steep } } normal { bumps .8 scale .3 } }"},
    {"slope_own_bumps_turned",
     "sphere { 0, 1 texture { pigment { slope { <1,2,-1>, .2, .8 } color_map { Steep } }"
     " normal { wrinkles .9 scale <.2,.5,1> rotate 40 } rotate 30*z } scale <1,.7,1.2> }"},
    {"slope_own_bumps_in_layers",
     "box { -.8, .8 texture { pigment { slope y color_map { [.3 rgb x] [.9 rgb y] } }"
     " normal { dents .7 scale .2 } }"
     " texture { pigment { slope { y, .3, .9 } color_map { [.4 rgbt 1] [.6 rgbt <1,1,1,.3>] } } }"
     " texture { pigment { slope { x } color_map { [.4 rgbt 1] [.6 rgbt <0,1,1,.5>] } }"
     " normal { granite .6 scale .4 } } rotate 30 }"},
    {"slope_own_bumps_in_a_map",
     "torus { .7, .4 texture { gradient x texture_map {"
     " [.3 pigment { slope y color_map { Steep } } normal { bumps .6 scale .2 }]"
     " [.7 pigment { slope x color_map { Steep } } normal { ripples .8 frequency 9 }] }"
     " scale 1.5 rotate 25*y } rotate -50*x }"},
    {"slope_above_in_a_turned_map",
     "#declare Two = texture { pigment { slope y color_map { Steep } } }"
     " texture { pigment { slope x color_map { [.3 rgbt <1,0,0,.2>] [.6 rgbt 1] } }"
     " normal { bumps .6 scale .2 } }"
     " sphere { 0, 1 texture { gradient x texture_map { [.5 Two] [.5 Two] } rotate <20,30,40> } }"},
    {"slope_own_bumps_average",
     "sphere { 0, 1 pigment { average pigment_map { [1 slope x color_map { Steep }]"
     " [2 checker rgb 1 rgb 0 scale .3] } } normal { average normal_map {"
     " [1 bumps .8 scale .2] [1 gradient y .7 scale .4] } } }"},
    {"slope_own_bumps_isosurface",
     "isosurface { function { y + .2*sin(x*5)*cos(z*4) } contained_by { box { -1, 1 } }"
     " max_gradient 2 pigment { slope { -y, .02, .5 } color_map { Steep } }"
     " normal { wrinkles .5 scale .1 } }"},
    {"slope_own_bumps_csg",
     "difference { sphere { 0, 1 } box { <-.4,-.3,-2>, <.4,1.2,2>"
     " pigment { slope { y*2, 0, .9 altitude y, -1, 1 } color_map { Steep } }"
     " normal { dents .9 scale .15 } }"
     " pigment { slope z color_map { Steep } } normal { bumps .5 scale .1 } rotate 20*y }"},
    {"slope_facets",
     "sphere { 0, 1 pigment { slope y color_map { Steep } } normal { facets coords .3 } }"},
    {"slope_own_bumps_shadow",
     "sphere { 0, 1 pigment { slope y color_map { [0 rgbt <1,0,0,.1>] [.5 rgbt <1,1,0,.9>]"
     " [1 rgbt <0,0,1,.2>] } } normal { bumps 1 scale .3 } }"},
    {"slope_own_bumps_mirror",
     "sphere { 0, 1 pigment { slope y color_map { Steep } } normal { bumps .6 scale .3 }"
     " finish { reflection .5 metallic reflection { .3 metallic } } }"},
    {"aoi_own_bumps",
     "sphere { 0, 1 pigment { aoi color_map { Steep } } normal { bumps .7 scale .2 } }"},
    {"aoi_uv_bump_map",
     "sphere { 0, 1 uv_mapping pigment { aoi color_map { [.5 rgb x] [1 rgb y] } }"
     " normal { bump_map { function 40, 20 { .5 + .5*sin(x*60)*cos(y*40) } bump_size 3 } } }"},
    {"irid", "sphere { 0, 1 pigment { rgb .6 } finish { irid { .6 thickness .4 } phong .6 } }"},
    {"irid_turbulent",
     "sphere { 0, 1 pigment { rgb .6 } finish { diffuse .8 irid { .35 thickness .3 turbulence .7 }"
     " reflection .4 } } global_settings { irid_wavelength rgb <.3,.2,.1> }"},
    {"irid_total_reflection",
     "torus { .8, .4 pigment { rgbt .8 } finish { irid { .3 thickness 2 } phong .6 } interior { "
     "ior 1.3 }"
     " rotate 60*x }"},
    {"density",
     "box { .02, .97 pigment { density_file df3 \"spiral.df3\" color_map { Steep } }"
     " translate -.5 scale 1.8 rotate 20*y }"},
    {"density_linear",
     "box { .01, .99 pigment { density_file df3 \"spiral.df3\" interpolate 1 }"
     " translate -.5 scale 1.8 rotate 20*y }"},
    {"density_cubic",
     "box { .1, .9 pigment { density_file df3 \"spiral.df3\" interpolate 2 }"
     " translate -.5 scale 1.8 rotate 20*y }"},
};

class ImageSurfacePatterns : public ::testing::TestWithParam<SurfacePatternsCase> {};

TEST_P(ImageSurfacePatterns, AsInStock) {
  EXPECT_TRUE(same_as_stock({.sdl = std::string(kSurfacePatternsStage) + GetParam().sdl,
                             .width = 120,
                             .height = 90,
                             .arguments = {},
                             .files = {}},
                            GetParam().grade));
}

INSTANTIATE_TEST_SUITE_P(Each, ImageSurfacePatterns, ::testing::ValuesIn(kSurfacePatternsCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
