// What is seen through surfaces: filtering, refraction, total reflection, fading interiors.
#include "tests/image/shading_scenes.h"

using namespace lentray::test;

namespace {

const char* kBehind =
    "sphere { <0.5, 0.7, 2>, 0.7 pigment { rgb <0.9, 0.3, 0.2> } }"
    "background { rgb <0.3, 0.5, 0.8> }";

SceneText glass(const std::string& object, const std::string& settings = "") {
  return staged(object + kBehind, "light_source { <-6, 9, -7> rgb 1 }", settings);
}

TEST(ImageShadingTransparency, FilterAndTransmit) {
  EXPECT_TRUE(same_as_stock(
      glass("box { <-1.2, 0.2, 0>, <0, 1.8, 0.2> pigment { rgbf <1, 0.6, 0.3, 0.9> } }"
            "box { <0, 0.2, 0>, <1.2, 1.8, 0.2> pigment { rgbt <0.2, 0.6, 0.3, 0.5> } }")));
}

TEST(ImageShadingTransparency, FilterBeforeVersion37) {
  SceneText scene =
      glass("box { <-1.2, 0.2, 0>, <1, 1.8, 0.2> pigment { rgbft <1, 0.6, 0.3, 0.6, 0.2> } }");
  scene.sdl.replace(0, std::string("#version 3.7;").size(), "#version 3.6;");
  EXPECT_TRUE(same_as_stock(scene));
}

TEST(ImageShadingTransparency, RefractingSphere) {
  EXPECT_TRUE(
      same_as_stock(glass("sphere { <0, 1, 0>, 0.9 pigment { rgbf <0.95, 1, 0.97, 0.95> }"
                          " finish { ambient 0 diffuse 0.1 specular 0.6 } interior { ior 1.5 } }",
                          "max_trace_level 12")));
}

TEST(ImageShadingTransparency, GlassWithMirrorFinish) {
  EXPECT_TRUE(same_as_stock(
      glass("sphere { <0, 1, 0>, 0.9 pigment { rgbt <1, 1, 1, 0.9> }"
            " finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy }"
            " interior { ior 1.5 } }",
            "max_trace_level 10")));
}

// What a finish of old scenes says: each surface multiplies the light that goes through.
TEST(ImageShadingTransparency, RefractionOfAFinish) {
  const auto box = [](const std::string& finish, const std::string& more = "") {
    return glass(
        "box { <-1.2, 0.2, -0.3>, <1, 1.8, 0.2> pigment { rgbf <0.5, 1, 0.9, 0.6> } finish { " +
        finish + " } " + more + " rotate 20*y }");
  };
  for (const char* finish : {"refraction 0", "refraction 0.5", "refraction 1.2 ior 1.3",
                             "refraction 1.4 reflection 0.2", "refraction 0.8 ior 1.8"}) {
    EXPECT_TRUE(same_as_stock(box(finish))) << finish;
  }
  EXPECT_TRUE(
      same_as_stock(box("refraction 0.7", "interior { ior 1.2 fade_distance 1 fade_power 1 }")));
  EXPECT_TRUE(
      same_as_stock(glass("union { sphere { <-0.8, 1, 0>, 0.6 } box { <0, 0.3, 0>, 1 } pigment "
                          "{ rgbt 0.8 } finish { refraction 1.3 } }")));
  EXPECT_TRUE(same_as_stock(
      glass("sphere { <0, 1, 0>, 0.9 texture { pigment { rgbt 0.9 } finish { refraction 0.5 } } "
            "texture { pigment { rgbt <1, 0.5, 0, 0.8> } finish { refraction 0.9 } } }")));
}

TEST(ImageShadingTransparency, RefractionOfAFinishBeforeVersion31) {
  SceneText scene = glass(
      "sphere { <0, 1, 0>, 0.9 pigment { rgbf <0.2, 0.5, 0.6, 0.8> }"
      " finish { phong 1 reflection 0.3 refraction 1.2 ior 1.8 } }");
  scene.sdl.replace(0, std::string("#version 3.7;").size(), "#version 3.0;");
  EXPECT_TRUE(same_as_stock(scene));
}

TEST(ImageShadingTransparency, TotalInternalReflection) {
  EXPECT_TRUE(same_as_stock(
      glass("box { -0.8, 0.8 rotate <20, 35, 10> translate 1*y pigment { rgbt <0.9, 1, 1, 0.95> }"
            " finish { ambient 0 diffuse 0.1 reflection 0.05 } interior { ior 2.2 } }",
            "max_trace_level 15")));
}

TEST(ImageShadingTransparency, NestedAndOverlappingGlass) {
  EXPECT_TRUE(same_as_stock(
      glass("sphere { <0, 1, 0>, 0.9 pigment { rgbt 1 } interior { ior 1.3 } }"
            "sphere { <0, 1, 0>, 0.5 pigment { rgbt <1, 1, 1, 0.95> } interior { ior 1.8 } }"
            "sphere { <0.9, 1, -0.3>, 0.4 pigment { rgbt <1, 1, 1, 0.95> } interior { ior 1.1 } }",
            "max_trace_level 20")));
}

TEST(ImageShadingTransparency, BubbleWithoutInteriorInGlass) {
  EXPECT_TRUE(
      same_as_stock(glass("sphere { <0, 1, 0>, 0.9 pigment { rgbt 1 } interior { ior 1.5 } }"
                          "sphere { <0.2, 1, 0>, 0.4 pigment { rgbt <0.9, 1, 0.9, 0.9> } }",
                          "max_trace_level 20")));
}

TEST(ImageShadingTransparency, CameraInsideGlass) {
  EXPECT_TRUE(same_as_stock(
      glass("sphere { <0, 2, -5>, 3 pigment { rgbt <0.95, 1, 1, 0.95> } interior { ior 1.2 } }",
            "max_trace_level 10")));
}

TEST(ImageShadingTransparency, FresnelInsideAHollowWorld) {
  EXPECT_TRUE(same_as_stock(glass(
      "sphere { 0, 100 hollow pigment { gradient y color_map { [0 rgb 1][1 rgb <0, 0.2, 1>] }"
      " scale 30 } finish { ambient 1 diffuse 0 } no_shadow }"
      "sphere { <0, 1, 0>, 0.9 pigment { rgbt 1 } finish { diffuse 0 reflection { 0, 1 fresnel } }"
      " interior { ior 1.5 } }",
      "max_trace_level 8")));
}

TEST(ImageShadingTransparency, FadingInterior) {
  EXPECT_TRUE(same_as_stock(
      glass("box { <-1.2, 0.1, -0.6>, <1.2, 1.5, 0.6> pigment { rgbt 1 }"
            " interior { ior 1.3 fade_distance 0.8 fade_power 2 fade_color rgb <0.9, 0.3, 0.1> } }",
            "max_trace_level 10")));
  EXPECT_TRUE(same_as_stock(
      glass("box { <-1.2, 0.1, -0.6>, <1.2, 1.5, 0.6> pigment { rgbt 1 }"
            " interior { fade_distance 1.5 fade_power 1001 fade_color rgb <0.2, 0.7, 0.3> } }",
            "max_trace_level 10")));
}

TEST(ImageShadingTransparency, LayeredGlass) {
  EXPECT_TRUE(same_as_stock(glass(
      "sphere { <0, 1, 0>, 0.9"
      " texture { pigment { rgbf <0.9, 0.9, 1, 0.9> } finish { specular 0.4 } }"
      " texture { pigment { checker rgbt <1, 0.2, 0.2, 0.7> rgbf <0.4, 1, 0.4, 0.8> scale 0.3 }"
      "  finish { reflection 0.1 } } interior { ior 1.2 } }",
      "max_trace_level 10")));
}

TEST(ImageShadingTransparency, InteriorTexture) {
  EXPECT_TRUE(same_as_stock(
      glass("difference { sphere { <0, 1, 0>, 0.9 } box { <-1, 0, -1>, <1, 2, -0.3> }"
            " texture { pigment { rgb <0.8, 0.7, 0.2> } }"
            " interior_texture { pigment { rgb <0.2, 0.7, 0.9> } } }"
            "cylinder { <-1.8, 0, 0>, <-1.8, 1, 0>, 0.5 open pigment { rgb <1, 0.5, 0.5> }"
            " interior_texture { pigment { rgb <0.3, 1, 0.3> } } }")));
}

TEST(ImageShadingTransparency, BlendedTextures) {
  EXPECT_TRUE(same_as_stock(
      glass("sphere { <0, 1, 0>, 0.9 texture { gradient y texture_map {"
            " [0.2 pigment { rgb <1, 0.8, 0.3> } finish { specular 0.5 }]"
            " [0.8 pigment { rgbf <0.4, 0.7, 1, 0.8> } finish { reflection 0.4 }] } scale 2 } }")));
}

TEST(ImageShadingTransparency, BumpyMirrorAndBumpyGlass) {
  EXPECT_TRUE(same_as_stock(
      glass("sphere { <0, 1, 0>, 1 pigment { rgb <0.8, 0.4, 0.2> } normal { bumps 1.5 scale 0.3 }"
            " finish { reflection 0.5 specular 0.5 phong 0.3 } }",
            "max_trace_level 8")));
  EXPECT_TRUE(same_as_stock(glass(
      "sphere { <0, 1, 0>, 1 pigment { rgbt <0.8, 0.9, 0.9, 0.9> }"
      " normal { bumps 0.6 scale 0.3 }"
      " finish { reflection { 0, 1 fresnel } specular 0.5 conserve_energy } interior { ior 1.5"
      " fade_distance 1 fade_power 1 fade_color rgb <0.9, 0.5, 0.3> } }",
      "max_trace_level 8")));
}

TEST(ImageShadingTransparency, LightInsideGlass) {
  EXPECT_TRUE(same_as_stock(
      glass("sphere { <0, 1, 0>, 1 pigment { rgbt <0.8, 0.9, 0.9, 0.9> } interior { ior 1.5 } }"
            "light_source { <0.2, 1.1, -0.2> rgb 0.6 }",
            "max_trace_level 8")));
}

TEST(ImageShadingTransparency, GlassByCsg) {
  const std::string looks =
      " pigment { rgbf <0.9, 1, 1, 0.8> } interior { ior 1.4 } finish { reflection 0.1 } }";
  for (const std::string object :
       {"union { sphere { <-0.6, 1, 0>, 0.8 } sphere { <0.5, 1, 0>, 0.7 }",
        "merge { sphere { <-0.6, 1, 0>, 0.8 } sphere { <0.5, 1, 0>, 0.7 }",
        "difference { sphere { <0, 1, 0>, 1 } sphere { <0, 1, 0>, 0.8 }"
        " cylinder { -2*z, 2*z, 0.4 translate y }"}) {
    EXPECT_TRUE(same_as_stock(glass(object + looks, "max_trace_level 8"))) << object;
  }
}

TEST(ImageShadingTransparency, ObjectsUnderWater) {
  EXPECT_TRUE(same_as_stock(
      glass("box { <-3, -0.5, -3>, <3, 1.2, 3> pigment { rgbt <0.8, 0.9, 1, 0.9> } hollow"
            " interior { ior 1.33 fade_distance 2 fade_power 2 fade_color rgb <0.3, 0.6, 0.8> } }"
            "sphere { <0, 0.6, 0>, 0.5 pigment { rgb <1, 0, 0> } finish { specular 0.5 } }"
            "sphere { <1, 0.6, -0.5>, 0.4 pigment { rgbt 1 } interior { ior 1.0 } }",
            "max_trace_level 8")));
}

TEST(ImageShadingTransparency, PartsOfOneObjectDiffer) {
  EXPECT_TRUE(
      same_as_stock(glass("intersection { sphere { <0, 1, 0>, 1 } box { <-1, 0, -1>, <1, 1.5, 1>"
                          " pigment { rgb <1, 0, 0> } } pigment { rgbt <0, 1, 0, 0.5> } }")));
}

TEST(ImageShadingTransparency, TexturesOfMeshFaces) {
  EXPECT_TRUE(same_as_stock(glass(
      "mesh2 { vertex_vectors { 4, <-1.5, 0.2, 0>, <1.5, 0.2, 0.5>, <0, 2.2, 0>, <2, 2.4, 1> }"
      " texture_list { 3, texture { pigment { rgb <1, 0, 0> } }"
      "  texture { pigment { rgb <0, 1, 0> } finish { specular 0.6 } }"
      "  texture { pigment { rgbt <0, 0, 1, 0.6> } finish { reflection 0.3 } } }"
      " face_indices { 2, <0, 1, 2>, 0, 1, 2, <1, 2, 3>, 1, 2, 1 } pigment { rgb 1 } }")));
}

}  // namespace
