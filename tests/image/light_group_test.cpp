// light_group against stock: who is lit by what, and the shadows that grouped objects take and give.
#include "tests/image/shading_scenes.h"

using namespace lentray::test;

namespace {

/// Boxes in a row, each seen face on: the colour says which lights it has. Global light: red.
SceneText row(const std::string& objects) {
  SceneText scene;
  scene.sdl = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> look_at 0 right 8*x up 2*y }
#default { finish { ambient 0 diffuse 0.4 } pigment { rgb 1 } }
#macro Light(C) light_source { <0, 0, -1000> rgb C } #end
#macro Box(I) box { <-4 + I, -1, 0>, <-3.1 + I, 1, 1> } #end
light_source { <0, 0, -1000> rgb x }
)" + objects;
  scene.width = 64;
  scene.height = 8;
  return scene;
}

struct LightGroupCase {
  const char* name;
  const char* objects;
};

class ImageLightGroup : public testing::TestWithParam<LightGroupCase> {};

TEST_P(ImageLightGroup, AsStock) { EXPECT_TRUE(same_as_stock(row(GetParam().objects))); }

const LightGroupCase kLightGroupCases[] = {
    {"Simple", "Box(0) light_group { Light(y) Box(1) union { Box(2) Box(3) } } Box(4)"},
    {"GlobalLights",
     "light_group { Light(y) Box(1) global_lights on }"
     "light_group { Light(z) Box(2) global_lights off }"},
    {"SeveralLights", "light_group { Light(y) Box(0) Light(y / 2) Light(z) }"},
    {"WithoutLights", "light_group { Box(0) } Box(1)"},
    {"WithoutObjects", "light_group { Light(y) } Box(1)"},
    {"NestedDirectly",
     "light_group { Light(y) Box(0) light_group { Light(z) Box(1) union { Box(2) } } }"},
    {"NestedByName",
     "#declare Inner = light_group { Light(z) Box(1) union { Box(2) } }"
     "light_group { Light(y) Box(0) object { Inner } }"},
    {"NestedBare",
     "#declare Inner = light_group { Light(z) Box(1) union { Box(2) } }"
     "light_group { Light(y) Box(0) light_group { Inner } }"},
    {"NestedThenCopied",
     "#declare Outer = light_group { Light(y) Box(0) light_group { Light(z) Box(1) union { Box(2) "
     "} } }"
     "#declare Both = union { object { Outer } Box(4) } object { Both }"},
    {"NestedThrice",
     "#declare Third = light_group { Light(x) light_group { Light(y) Box(0)"
     "  light_group { Light(z) Box(1) union { Box(2) } } union { Box(3) } } Box(4) }"
     "object { Third } object { Third translate -2.4 * y scale <1, 0.4, 1> }"},
    {"InnerInUnion",
     "light_group { Light(y) Box(0) union { light_group { Light(z) Box(1) } Box(2) } }"},
    {"GlobalInside",
     "light_group { Light(y) Box(0) light_group { Light(z) Box(1) global_lights on } }"},
    {"GlobalOutside",
     "light_group { Light(y) Box(0) light_group { Light(z) Box(1) global_lights off }"
     "  global_lights on }"},
    {"LightInUnion", "light_group { union { Light(y) Box(0) } Box(1) Light(z) } Box(2)"},
    {"InnerWithoutLights", "light_group { Light(y) light_group { Box(0) } Box(1) }"},
    {"LightByName",
     "#declare L = light_source { <0, 0, -1000> rgb z }"
     "light_group { light_source { L } Box(0) object { L translate x } } Box(1)"},
    {"LooksLike",
     "light_group { light_source { <0, 0, -1000> rgb y"
     "  looks_like { box { <-4, -1, 1000>, <-3.1, 1, 1001> } } } Box(1) }"},
    {"LooksLikeInUnion",
     "light_group { Light(y) union { light_source { <0, 0, -1000> rgb z"
     "  looks_like { box { <-4, -1, 1000>, <-3.1, 1, 1001> } } } Box(1) } }"},
    {"InCsg",
     "difference { light_group { Light(y) Box(0) } box { <-10, 0, -1>, <10, 10, 2> } }"
     "intersection { light_group { Light(z) Box(2) } box { <-10, -10, -1>, <10, 10, 2> } }"},
    {"AroundCsg",
     "light_group { Light(y) difference { Box(0) sphere { <-3.5, 0, 0>, 0.3 } }"
     "  intersection { Box(1) box { -10, 10 } } merge { Box(2) Box(3) } }"},
    {"ClippedAndWhole",
     "union { light_group { Light(y) Box(0) } clipped_by { box { -9, <9, 0.5, 9> } } }"
     "union { light_group { Light(z) Box(2) } split_union off }"},
    {"Mesh",
     "light_group { Light(y) mesh { triangle { <-4, -1, 0>, <-3, -1, 0>, <-3.5, 3, 0> } } }"},
    {"Moved",
     "light_group { light_source { <0, 0, -20> rgb y spotlight point_at <-3.5, 0, 0> radius 0.5"
     "  falloff 1.2 } Box(0) translate 2 * x rotate 10 * z }"},
};
INSTANTIATE_TEST_SUITE_P(All, ImageLightGroup, testing::ValuesIn(kLightGroupCases),
                         [](const auto& about) { return about.param.name; });

const char* kInShadow =
    "light_group { light_source { <5, 6, -4> rgb <0.2, 0.4, 0.9> }"
    "  sphere { <0, 1, 0>, 0.8 pigment { rgb 0.9 } finish { specular 0.4 } }"
    "  box { <0.9, 0, -1.4>, <1.4, 0.8, -0.9> pigment { rgb 0.7 } } global_lights }"
    "cylinder { <1.6, 0, -0.6>, <1.6, 2, -0.6>, 0.15 pigment { rgb <0.5, 0.8, 0.3> } }"
    "sphere { <-0.9, 0.5, -1.2>, 0.35 pigment { rgbf <0.9, 0.4, 0.3, 0.7> } }";

TEST(ImageLightGroupShadows, FromAllObjects) { EXPECT_TRUE(same_as_stock(staged(kInShadow))); }

TEST(ImageLightGroupShadows, AreaLightFadingAndShadowless) {
  EXPECT_TRUE(same_as_stock(staged(
      "light_group { light_source { <5, 6, -4> rgb 0.8 area_light <2, 0, 0>, <0, 0, 2>, 5, 5 }"
      "  light_source { <-4, 3, -5> rgb 0.5 fade_distance 5 fade_power 2 }"
      "  light_source { <0, 8, 0> rgb <0.3, 0.1, 0.1> shadowless }"
      "  sphere { <0, 1, 0>, 0.8 pigment { rgb 0.9 } finish { phong 0.6 } } }"
      "box { <0.9, 0, -1.4>, <1.4, 1.8, -0.9> pigment { rgb 0.7 } }")));
}

TEST(ImageLightGroupShadows, MirrorsGlassAndLayers) {
  EXPECT_TRUE(same_as_stock(
      staged("light_group { light_source { <5, 6, -4> rgb 0.8 }"
             "  sphere { <0.3, 1, 0>, 0.8 texture { pigment { rgb 0.9 } finish { reflection 0.4 } }"
             "    texture { pigment { rgbf <1, 0.8, 0.6, 0.5> } finish { specular 0.5 } } }"
             "  sphere { <-1.2, 0.6, -0.8>, 0.5 pigment { rgbf 0.8 } finish { specular 0.6 }"
             "    interior { ior 1.4 } } global_lights on }"
             "plane { z, 3 pigment { rgb <0.4, 0.6, 0.9> } }")));
}

}  // namespace
