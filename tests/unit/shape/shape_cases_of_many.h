// Shapes and CSG of so many parts that they have hierarchies. In a box of about 4 units.
#pragma once

#include <cstdio>
#include <deque>
#include <random>
#include <string>
#include <vector>

#include "tests/unit/shape/shape_cases.h"

namespace lentray::parser::test {

/// The part at as many random places, which it calls P.
inline std::string repeated(int count, const char* part) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> even(-1.2, 1.2);
  std::string sdl;
  for (int i = 0; i < count; ++i) {
    char place[200];
    const double x = even(random), y = even(random), z = even(random);
    std::snprintf(place, sizeof place, "#declare P = <%.4f,%.4f,%.4f>; ", x, y, z);
    sdl += place + std::string(part) + "\n";
  }
  return sdl;
}

struct ManyParts {
  const char* name;
  const char* head;
  int count;
  const char* part;
};

inline const ManyParts kManyParts[] = {
    {"blob_of_30", "blob { threshold .4", 30, "sphere { P, .5, 1 }"},
    {"blob_of_20_mixed", "blob { threshold .4", 20,
     "sphere { P, .6, 1 } cylinder { P, P.y*x + .2*z, .3, -.5 }"},
    {"union_of_40", "union {", 40,
     "sphere { P, .2 } box { P - .1, P + <.3,.1,.2> rotate 10*P.x*z }"},
    {"union_infinite_parts", "union {", 15,
     "sphere { P, .3 } plane { P, -2 clipped_by { sphere { P, 1 } } }"},
    {"merge_of_40", "merge {", 40, "sphere { P, .4 } cylinder { P, P + .5*y, .1 }"},
    {"difference_of_40", "difference { box { -1.2, 1.2 }", 40, "sphere { P, .25 }"},
    {"intersection_of_12", "intersection { sphere { 0, 1.4 }", 12,
     "sphere { P*.2, 1.3 inverse inverse }"},
    {"intersection_of_inverse", "intersection { box { -1.2, 1.2 }", 12,
     "cylinder { P - y, P + y, .1 inverse }"},
    {"union_of_csg", "union {", 12, "difference { box { P - .2, P + .2 } sphere { P + .1, .2 } }"},
    {"mesh_of_100", "mesh {", 100,
     "triangle { P, P + .4*x, <P.z,P.x,P.y> } smooth_triangle { P, x, P + .3*z, y, <P.y,P.z,P.x>, "
     "z }"},
    {"mesh_inside", "difference { box { -1, 1 } mesh { inside_vector y", 40,
     "#declare X = P + .4*x; #declare Y = P + .3*y; #declare Z = P + .4*z;"
     " triangle { P, X, Y } triangle { P, Y, Z } triangle { P, Z, X } triangle { X, Y, Z }"},
    {"text_of_20",
     "text { ttf \"cyrvetic.ttf\" \"Twenty letters here!\" .4, 0 scale .3 translate -1.2*x", 0, ""},
    {"sphere_sweep_long", "sphere_sweep { linear_spline 60", 60, "P, .15"},
    {"lathe_long", "lathe { quadratic_spline 22", 22, "<abs(P.x) + .1, P.y>"},
    {"prism_star", "prism { linear_spline -.4, .5, 34 <.9,0>", 32, "<P.x, P.z>"},
};

/// Shapes of so many parts that they have hierarchies.
inline std::vector<ShapeCase> shapes_of_many() {
  static std::deque<std::string> texts;  // the cases point into it
  std::vector<ShapeCase> cases;
  for (const ManyParts& m : kManyParts) {
    std::string end = " }";
    if (std::string(m.name) == "prism_star") end = "<.9,0> }";
    if (std::string(m.name) == "mesh_inside") end = " } }";
    texts.push_back(m.head + std::string(" ") + repeated(m.count, m.part) + end);
    cases.push_back({m.name, texts.back().c_str()});
  }
  return cases;
}

}  // namespace lentray::parser::test
