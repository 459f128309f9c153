// Every kind of finite shape, with several settings, and three ways to place it.
#pragma once

#include <cmath>

#include "core/base/transform.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser::test {

using core::Vec2;
using core::Vec3;

/// Where text finds its fonts.
inline ParserOptions with_fonts() {
  ParserOptions options;
  options.library_paths.push_back("/usr/share/povray-3.7/include");
  return options;
}

struct ShapeCase {
  const char* name;
  const char* sdl;
  /// For what is slow to meet with rays: the surface itself over lo..hi.
  Vec3 (*surface)(double u, double v) = nullptr;
  Vec2 lo{}, hi{};
};

/// In a box of 6 units about the origin.
inline const ShapeCase kShapeCases[] = {
    {"sphere", "sphere { <.3,.2,.1>, 1.2 }"},
    {"ellipsoid", "sphere { 0, 1 scale <1,.3,2> }"},
    {"box", "box { <-1,-.5,-.2>, <.7,1,1.4> }"},
    {"cylinder", "cylinder { <-.5,-1,.2>, <.6,1.2,-.3>, .5 }"},
    {"cylinder_open", "cylinder { -y, y, .7 open }"},
    {"cone", "cone { <-.3,-1,.2>, 1.1, <.4,1.2,-.3>, .2 }"},
    {"cone_pointed", "cone { -y, .8, y, 0 }"},
    {"cone_open", "cone { <0,-1,1>, .2, <0,1,-.5>, .9 open }"},
    {"cone_double", "cone { <-.3,-1,.2>, -.5, <.4,1.2,-.3>, .9 }"},
    {"cone_double_open", "cone { <0,-1,1>, -.7, <0,1,-.5>, .4 open }"},
    {"torus", "torus { 1, .3 }"},
    {"torus_thick", "torus { .6, .8 }"},
    {"disc", "disc { <.2,.3,.1>, <1,2,-.5>, 1.3, .4 }"},
    {"triangle", "triangle { <-1,-.5,0>, <1.2,.1,.3>, <.1,1,-1> }"},
    {"smooth_triangle",
     "smooth_triangle { <-1,-.5,0>, -z, <1.2,.1,.3>, <.2,0,-1>, <.1,1,-1>, <0,-.1,-1> }"},
    {"polygon", "polygon { 6, <-1,-.5>, <1.2,.1>, <.5,1>, <0,.2>, <-.7,.9>, <-1,-.5> }"},
    {"mesh",
     "mesh { triangle { <-1,0,-1>, <1,0,-1>, <0,1.3,0> } triangle { <1,0,-1>, <0,0,1>, <0,1.3,0> }"
     " smooth_triangle { <0,0,1>, y, <-1,0,-1>, y, <0,1.3,0>, y } }"},
    {"mesh2",
     "mesh2 { vertex_vectors { 4, <-1,0,-1>, <1,0,-1>, <0,1.3,0>, <0,-.4,1> }"
     " face_indices { 4, <0,1,2>, <1,3,2>, <3,0,2>, <0,1,3> } inside_vector x }"},
    {"quadric_ellipsoid", "quadric { <1,2,3>, <.2,.1,.3>, <.1,-.2,.3>, -1 }"},
    {"superellipsoid", "superellipsoid { <.3,.5> }"},
    {"superellipsoid_sharp", "superellipsoid { <1.8,.2> }"},
    {"superellipsoid_concave", "superellipsoid { <2.6,2.2> }"},
    {"blob",
     "blob { threshold .5 sphere { <.4,0,0>, 1, 1 } cylinder { <-1,-.2,0>, <.5,.9,.2>, .6, 1.1 }"
     " sphere { <0,.5,-.5>, .5, -.8 scale <1,1.4,1> } }"},
    {"blob_sphere", "blob { threshold .3 sphere { <.2,0,.1>, 1.5, 1 } }"},
    {"blob_far_parts",
     "blob { threshold .6 sphere { x, .8, 1 } sphere { -x, 1, 2 } cylinder { -y, y, .4, 1 } }"},
    {"blob_too_weak_alone", "blob { threshold .6 sphere { 1.4*x, 1, .4 } sphere { 0, 1.2, 1.5 } }"},
    {"lathe_linear", "lathe { 5 <0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9> }"},
    {"lathe_quadratic",
     "lathe { quadratic_spline 6 <.3,-1>,<0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9> }"},
    {"lathe_cubic",
     "lathe { cubic_spline 7 <.3,-1>,<0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9>,<.2,1> }"},
    {"lathe_bezier",
     "lathe { bezier_spline 8 <0,-.9>,<1,-1>,<1,-.3>,<.5,0> <.5,0>,<.3,.5>,<1,.8>,<0,.9> }"},
    {"sor", "sor { 7 <0,-1>,<.5,-.9>,<.9,-.3>,<.3,.2>,<.6,.8>,<.2,1>,<0,1.1> }"},
    {"sor_open", "sor { 6 <.4,-1.2>,<.5,-.9>,<1,-.2>,<.4,.4>,<.7,.9>,<.9,1.1> open }"},
    {"ovus", "ovus { .8, .45 }"},
    {"ovus_top_heavy", "ovus { .5, .8 }"},
    {"ovus_sphere", "ovus { .4, .9 }"},
    {"prism_linear",
     "prism { -.5, .7, 10 <-1,-1>,<1,-1>,<1,1>,<0,.2>,<-1,1>,<-1,-1>"
     " <-.3,-.7>,<.3,-.7>,<0,0>,<-.3,-.7> }"},
    {"prism_triangle", "prism { 0, 2, 4 <-1,-1>,<1,-1>,<0,1>,<-1,-1> }"},
    {"prism_quadratic",
     "prism { quadratic_spline 0, .6, 7 <-1,1>,<-1,-1>,<1,-1>,<1.2,.4>,<0,1>,<-1,-1>,<0,0> }"},
    {"prism_cubic",
     "prism { cubic_spline 0, .6, 7 <0,1>,<-1,-1>,<1,-1>,<1.2,.4>,<0,1>,<-1,-1>,<1,-1> }"},
    {"prism_bezier",
     "prism { bezier_spline 0, .6, 8 <0,-1>,<1.5,-1>,<1,.5>,<0,.6>"
     " <0,.6>,<-1,.5>,<-1.5,-1>,<0,-1> }"},
    {"prism_conic",
     "prism { conic_sweep linear_spline .2, 1, 5 <-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1> }"},
    {"prism_conic_cubic",
     "prism { conic_sweep cubic_spline -1, 1, 7 <0,1>,<-1,-1>,<1,-1>,<1.2,.4>,"
     "<0,1>,<-1,-1>,<1,-1> }"},
    {"text", "text { ttf \"cyrvetic.ttf\" \"R&g\" .4, <.05,.02,0> }"},
    {"sphere_sweep_linear",
     "sphere_sweep { linear_spline 4 <-1,-.6,0>,.3 <0,.8,-.3>,.15 <.9,-.4,.4>,.4"
     " <1.2,.6,0>,.1 }"},
    {"sphere_sweep_cubic",
     "sphere_sweep { cubic_spline 6 <-2,0,0>,.2 <-1,-.6,0>,.3 <0,.8,-.3>,.15"
     " <.9,-.4,.4>,.4 <1.2,.6,0>,.1 <2,1,0>,.2 }"},
    {"sphere_sweep_b",
     "sphere_sweep { b_spline 6 <-2,0,0>,.2 <-1,-.9,0>,.3 <0,1.4,-.3>,.25 <.9,-.8,.4>,.4"
     " <1.2,.9,0>,.3 <2,1,0>,.2 }"},
    {"bicubic_patch",
     "bicubic_patch { type 1 u_steps 3 v_steps 4 <-1.4,-.5,-1>,<-.5,.8,-1.2>,<.5,-.6,-1>,"
     "<1.4,.4,-1>,<-1.5,.3,-.4>,<-.5,-.5,-.3>,<.5,1.9,-.4>,<1.5,0,-.2>,<-1.3,-.4,.4>,"
     "<-.4,.9,.3>,<.4,-.8,.5>,<1.4,.7,.4>,<-1.4,.5,1.1>,<-.5,-.2,1>,<.5,.6,1.3>,<1.3,-.3,1> }"},
    {"height_field", "height_field { function 40, 30 { .5 + .4*sin(x*9)*cos(y*8) } scale 2 }"},
    {"height_field_water",
     "height_field { function 40, 30 { .5 + .4*sin(x*9)*cos(y*8) } water_level .6 smooth"
     " translate -.5 }"},
    {"isosurface",
     "isosurface { function { x*x + y*y*2 + z*z - 1 } max_gradient 6 contained_by { box { -1, 1 } "
     "} }"},
    {"isosurface_in_sphere",
     "isosurface { function { sqrt(x*x + y*y) - .3 - .2*abs(z) } max_gradient 2"
     " contained_by { sphere { 0, 1.1 } } }"},
    {"parametric",
     "parametric { function { sin(u)*cos(v) }, function { sin(u)*sin(v) }, function { cos(u) }"
     " <0,0>, <2*pi,pi> contained_by { box { -3, 3 } } max_gradient 4 accuracy .01 }",
     [](double u, double v) {
       return Vec3{std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u)};
     },
     {0, 0},
     {2 * M_PI, M_PI}},
    {"parametric_precomputed",
     "parametric { function { u*v*sin(15*v) }, function { v }, function { u*v*cos(15*v) }"
     " <0,-1>, <1,1> contained_by { box { -1, 1 } } max_gradient 20 accuracy .01 precompute 10, "
     "x,y,z }",
     [](double u, double v) {
       return Vec3{u * v * std::sin(15 * v), v, u * v * std::cos(15 * v)};
     },
     {0, -1},
     {1, 1}},
    {"julia_square",
     "julia_fractal { <-.083,0,-.83,-.025> quaternion max_iteration 8 precision 30 }"},
    {"julia_default", "julia_fractal { <-.5,.3,.2,0> quaternion max_iteration 6 precision 30 }"},
    {"julia_slice",
     "julia_fractal { <-.2,.6,.2,.2> quaternion max_iteration 8 precision 30 slice <.2,.4,.1,1>, "
     ".2 }"},
    {"julia_cube", "julia_fractal { <-.4,.3,.2,.1> quaternion cube max_iteration 8 precision 30 }"},
    {"julia_hypercomplex",
     "julia_fractal { <-.16,.16,.4,-.3> hypercomplex sqr max_iteration 8 precision 30 }"},
    {"julia_reciprocal",
     "julia_fractal { <.5,.3,.2,.1> hypercomplex reciprocal max_iteration 6 precision 30 }"},
    {"julia_exp", "julia_fractal { <-.6,.2,.2,.1> hypercomplex exp max_iteration 6 precision 30 }"},
};

inline const struct {
  const char* name;
  const char* sdl;
  core::Transform place;
} kPlacings[] = {
    {"plain", "", {}},
    {"turned", "rotate <20,35,50>", core::Transform::rotation({20, 35, 50})},
    {"sheared", "matrix <1,.3,0, 0,.6,.2, .1,0,1.4, 0,0,0>",
     core::Transform::matrix({{{1, .3, 0}, {0, .6, .2}, {.1, 0, 1.4}, {0, 0, 0}}})},
};

}  // namespace lentray::parser::test
