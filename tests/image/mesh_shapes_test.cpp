// Meshes against stock: every list of mesh2, textures of faces and of corners, uv, normals, solids in CSG.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr int kAround = 9, kUp = 5;

/// A closed ring of kAround x kUp corners; `mesh2` lists or triangles are made of it.
std::string corner(int i, int j, double grow) {
  const double u = 2.0 * 3.14159265358979 * i / kAround, v = 2.0 * 3.14159265358979 * j / kUp;
  const double tube = .4 * grow, r = .9 + tube * std::cos(v);
  std::ostringstream text;
  text << '<' << r * std::cos(u) << ',' << tube * std::sin(v) << ',' << r * std::sin(u) << '>';
  return text.str();
}

std::string normal(int i, int j) {
  const double u = 2.0 * 3.14159265358979 * i / kAround, v = 2.0 * 3.14159265358979 * j / kUp;
  std::ostringstream text;
  text << '<' << std::cos(v) * std::cos(u) << ',' << std::sin(v) + .2 * std::sin(3 * u) << ','
       << std::cos(v) * std::sin(u) << '>';
  return text.str();
}

/// "name { count, each(0,0), each(0,1) ... }"
template <class Each>
std::string list(const std::string& name, Each&& each) {
  std::string all = name + " { " + std::to_string(kAround * kUp);
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kUp; ++j) all += ", " + each(i, j);
  }
  return all + " } ";
}

/// Faces with `textures` numbers behind each, of three textures; `shift` turns the corners' numbers.
std::string faces(const std::string& name, int textures, int shift) {
  std::string all = name + " { " + std::to_string(2 * kAround * kUp);
  const auto index = [&](int i, int j) {
    return std::to_string(((i + shift) % kAround) * kUp + j % kUp);
  };
  int n = 0;
  const auto face = [&](const std::string& a, const std::string& b, const std::string& c) {
    all += ", <" + a + "," + b + "," + c + ">";
    for (int k = 0; k < textures; ++k) all += ", " + std::to_string((n + k * n) % 3);
    ++n;
  };
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kUp; ++j) {
      face(index(i, j), index(i + 1, j), index(i + 1, j + 1));
      face(index(i, j), index(i + 1, j + 1), index(i, j + 1));
    }
  }
  return all + " } ";
}

const std::string kVertices =
    list("vertex_vectors", [](int i, int j) { return corner(i, j, 1.0); });
const std::string kNormals = list("normal_vectors", normal);
const std::string kUv = list("uv_vectors", [](int i, int j) {
  return "<" + std::to_string(i * .23) + "," + std::to_string(j * .31) + ">";
});
const std::string kTextures =
    "texture_list { 3, texture { pigment { rgb <.9,.2,.2> } } texture { pigment { checker rgb 1 "
    "rgb z scale .1 } finish { phong 1 } }"
    " texture { pigment { rgb <.2,.9,.3> } normal { bumps .8 scale .1 } } } ";

std::string triangles(bool smooth, const std::string& end) {
  std::string all;
  const auto point = [&](int i, int j) {
    return corner(i % kAround, j % kUp, 1.0) + (smooth ? ", " + normal(i % kAround, j % kUp) : "");
  };
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kUp; ++j) {
      const std::string kind = smooth ? "smooth_triangle { " : "triangle { ";
      all +=
          kind + point(i, j) + ", " + point(i + 1, j) + ", " + point(i + 1, j + 1) + end + " }\n";
      all +=
          kind + point(i, j) + ", " + point(i + 1, j + 1) + ", " + point(i, j + 1) + end + " }\n";
    }
  }
  return all;
}

struct MeshShapesCase {
  const char* name;
  std::string sdl;
};

const MeshShapesCase kMeshShapesCases[] = {
    {"plain",
     "mesh2 { " + kVertices + faces("face_indices", 0, 0) + "pigment { rgb <.9,.6,.3> } }"},
    {"normals", "mesh2 { " + kVertices + kNormals + faces("face_indices", 0, 0) +
                    "pigment { rgb <.9,.6,.3> } finish { specular .5 } }"},
    {"normal_indices", "mesh2 { " + kVertices + kNormals + faces("face_indices", 0, 0) +
                           faces("normal_indices", 0, 3) +
                           "pigment { rgb <.9,.6,.3> } finish { specular .5 } }"},
    {"uv", "mesh2 { " + kVertices + kUv + faces("face_indices", 0, 0) +
               "uv_mapping pigment { checker rgb 1 rgb x scale .2 } }"},
    {"uv_indices", "mesh2 { " + kVertices + kNormals + kUv + faces("face_indices", 0, 0) +
                       faces("uv_indices", 0, 2) +
                       "texture { uv_mapping pigment { gradient x color_map { [0 rgb z] [1 rgb y] "
                       "} scale .3 } } }"},
    {"all_indices", "mesh2 { " + kVertices + kNormals + kUv + kTextures +
                        faces("face_indices", 1, 0) + faces("normal_indices", 0, 1) +
                        faces("uv_indices", 0, 2) + "scale <1,1.3,.8> rotate <20,30,0> }"},
    {"texture_of_faces", "mesh2 { " + kVertices + kTextures + faces("face_indices", 1, 0) + "}"},
    {"textures_of_corners",
     "mesh2 { " + kVertices + kNormals + kTextures + faces("face_indices", 3, 0) + "}"},
    {"moved", "mesh2 { " + kVertices + kNormals + faces("face_indices", 0, 0) +
                  "pigment { checker rgb 1 rgb .3 scale .3 } normal { bumps .5 scale .2 } scale "
                  "<1,1.6,.7> rotate <30,0,20> }"},
    {"without_hierarchy", "mesh2 { " + kVertices + faces("face_indices", 0, 0) +
                              "hierarchy off pigment { rgb <.9,.6,.3> } }"},
    {"solid_cut",
     "difference { mesh2 { " + kVertices + kNormals + faces("face_indices", 0, 0) +
         "inside_vector <.1,1,.2> } sphere { <.6,.2,-.6>, .6 } pigment { rgb <.9,.6,.3> } }"},
    {"solid_cuts", "difference { box { <-1.4,-.3,-1.4>, <1.4,.2,1.4> } mesh2 { " + kVertices +
                       faces("face_indices", 0, 0) +
                       "inside_vector y } pigment { rgb <.3,.6,.9> } }"},
    {"solid_inverse",
     "intersection { mesh2 { " + kVertices + faces("face_indices", 0, 0) +
         "inside_vector y inverse } sphere { 0, 1.2 } pigment { rgb <.3,.9,.6> } }"},
    {"solid_glass", "mesh2 { " + kVertices + kNormals + faces("face_indices", 0, 0) +
                        "inside_vector y pigment { rgbt <.9,.9,1,.8> } interior { ior 1.3 } }"},
    {"copies",
     "#declare M = mesh2 { " + kVertices + kNormals + faces("face_indices", 0, 0) +
         "}\n"
         "object { M pigment { rgb x } } object { M rotate 90*x scale .6 pigment { rgb y } }"
         " union { object { M } object { M rotate 90*z } scale .4 translate <.8,.9,-.8> pigment { "
         "rgb z } }"},
    {"mesh", "mesh { " + triangles(false, "") + "pigment { rgb <.9,.6,.3> } }"},
    {"smooth_mesh", "mesh { " + triangles(true, "") +
                        "pigment { rgb <.9,.6,.3> } finish { phong .6 } rotate 20*z }"},
    {"mesh_uv", "mesh { " + triangles(true, " uv_vectors <0,0>, <.7,.1>, <.6,.9>") +
                    "uv_mapping pigment { checker rgb 1 rgb .2 scale .25 } }"},
    {"mesh_solid", "intersection { mesh { " + triangles(true, "") +
                       "inside_vector <.3,1,0> } plane { y, .15 } pigment { rgb <.9,.6,.3> } }"},
};

class ImageMeshShapes : public ::testing::TestWithParam<MeshShapesCase> {};

TEST_P(ImageMeshShapes, AsStock) {
  const std::string sdl = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <2.2,2.6,-4> look_at <0,.1,0> angle 40 }
light_source { <-4,7,-6>, 1 } light_source { <5,3,-2>, .3 } plane { y, -1.2 pigment { checker rgb .9 rgb .5 } }
)" + GetParam().sdl;
  EXPECT_TRUE(
      same_as_stock({.sdl = sdl, .width = 120, .height = 90, .arguments = {}, .files = {}}));
}

INSTANTIATE_TEST_SUITE_P(Each, ImageMeshShapes, ::testing::ValuesIn(kMeshShapesCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
