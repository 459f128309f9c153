// The picture is the same, bit for bit, with light buffers and without them (+UL, -UL).
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

void expect_same_without(const SceneText& scene) {
  const StoredImage with = lentray_render(scene, {"+UL"});
  const StoredImage without = lentray_render(scene, {"-UL"});
  EXPECT_TRUE(same_bits(with, without));
}

SceneText text(const std::string& sdl) {
  SceneText scene;
  scene.sdl = "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 6 }\n" + sdl;
  scene.width = 240;
  scene.height = 180;
  scene.bits = 16;
  return scene;
}

const char* kRoom = R"(
camera { location <0, 2, -6> look_at <0, 1, 0> }
plane { y, 0 pigment { checker rgb 1, rgb 0.6 } finish { reflection 0.2 } }
sphere { <-1.5, 1, 0>, 0.9 pigment { rgbf <1, 0.8, 0.7, 0.7> } interior { ior 1.4 } }
box { <-0.5, 0, -0.5>, <0.5, 1.2, 0.5> rotate 30*y pigment { rgb <0.2, 0.5, 0.9> } }
box { <0.8, 0, -1>, <1.3, 0.5, -0.5> pigment { rgb <0.9, 0.5, 0.2> } }
difference { sphere { <2, 1, 0.5>, 1 } box { <1.5, 0, -1>, <2.5, 3, 0.3> } pigment { rgb 0.8 } }
torus { 0.6, 0.2 rotate 70*x translate <0, 2.2, 0.5> pigment { rgbt <0.4, 0.9, 0.5, 0.3> } }
cylinder { <-3, 0, 1>, <-2.6, 2.5, 1>, 0.2 pigment { rgb <0.8, 0.8, 0.3> } clipped_by { plane { y, 1.7 } } }
cone { <-0.5, 0, -2>, 0.3, <-0.5, 0.8, -2>, 0 pigment { rgb <0.9, 0.2, 0.3> } no_shadow }
polygon { 8, <-1, 0, 0>, <1, 0, 0>, <1, 1, 0>, <0.4, 1, 0>, <0.4, 0.3, 0>, <-0.4, 0.3, 0>, <-0.4, 1, 0>,
  <-1, 1, 0> rotate <20, 40, 0> translate <1, 1.6, -1.4> pigment { rgb <0.6, 0.3, 0.8> } }
mesh { triangle { <-2, 0.1, -2>, <-1, 0.1, -2.2>, <-1.5, 0.9, -1.8> }
  triangle { <-2, 0.1, -2>, <-1.5, 0.9, -1.8>, <-2.4, 0.7, -1.5> } pigment { rgb <0.3, 0.8, 0.8> } }
union { #for (I, 0, 40) sphere { <3*sin(I), 3 + 0.4*cos(3*I), 3*cos(I*1.7)>, 0.12 } #end
  pigment { rgb <0.9, 0.9, 0.2> } }
)";

TEST(ImageLightBuffer, LightsOutsideAndInside) {
  expect_same_without(
      text(std::string(kRoom) +
           "light_source { <5, 9, -6> rgb 0.6 } light_source { <0.2, 1.6, -1> rgb 0.5 }"));
}

TEST(ImageLightBuffer, SpotsAndOtherKinds) {
  expect_same_without(text(std::string(kRoom) + R"(
light_source { <3, 6, -5> rgb 0.6 spotlight point_at <0, 0, 0> radius 15 falloff 22 }
light_source { <-4, 5, -3> rgb 0.4 cylinder point_at <0, 1, 0> radius 1 falloff 2 }
light_source { <-4, 5, 3> rgb 0.3 parallel point_at <0, 0, 0> }
light_source { <4, 5, 3> rgb 0.3 area_light x, z, 3, 3 adaptive 1 })"));
}

TEST(ImageLightBuffer, LightInAnObjectAndOnASurface) {
  expect_same_without(
      text(std::string(kRoom) +
           "light_source { <-1.5, 1, 0> rgb 0.6 } light_source { <0, 1e-4, -3> rgb 0.5 }"
           "light_source { <1, 0.5, -0.7> rgb 0.5 }"));
}

/// Surfaces that coincide: which of them filters the light must not depend on who finds it.
TEST(ImageLightBuffer, TouchingGlass) {
  const SceneText scene = text(
      "camera { location <0, 2.2, -6> look_at <0, 0.9, 0> angle 42 }"
      "light_source { <-6, 9, -7> rgb 1 } plane { y, 0 pigment { rgb 0.9 } }"
      "box { <-1.2, 0.2, 0>, <0, 1.8, 0.2> pigment { rgbf <1, 0.6, 0.3, 0.9> } }"
      "box { <0, 0.2, 0>, <1.2, 1.8, 0.2> pigment { rgbt <0.2, 0.6, 0.3, 0.5> } }"
      "box { <0, 0.2, 0.2>, <1.2, 1.8, 0.5> pigment { rgbf <0.2, 0.9, 0.9, 0.7> } }");
  expect_same_without(scene);
  EXPECT_TRUE(same_bits(lentray_render(scene), lentray_render(scene, {"Accelerator=list"})));
  EXPECT_TRUE(same_as_stock(scene));
}

TEST(ImageLightBuffer, FarFromTheOrigin) {
  expect_same_without(
      text("#declare Far = <2e5, -3e5, 1e5>; union {" +
           std::string("sphere { 0, 1 } box { <-2, -1.2, -2>, <2, -1, 2> } torus { 1.5, 0.2 }") +
           "pigment { rgb 0.8 } translate Far }"
           "camera { location Far + <0, 2, -6> look_at Far }"
           "light_source { Far + <4, 6, -5> rgb 1 }"));
}

}  // namespace
}  // namespace lentray::test
