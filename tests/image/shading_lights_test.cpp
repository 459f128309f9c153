// Every kind of light against stock.
#include "tests/image/shading_scenes.h"

using namespace lentray::test;

namespace {

const char* kSubject =
    "sphere { <0, 1, 0>, 0.8 pigment { rgb <0.9, 0.5, 0.2> } finish { specular 0.4 } }"
    "box { <-2.2, 0, -0.5>, <-1.4, 1.2, 0.4> pigment { rgb <0.3, 0.7, 0.4> } }";

SceneText lit_by(const std::string& light) { return staged(kSubject, light); }

TEST(ImageShadingLights, Point) {
  EXPECT_TRUE(same_as_stock(
      lit_by("light_source { <-6, 9, -7> rgb <1, 0.8, 0.6> } light_source { <5, 3, -2> rgb <0.1, "
             "0.2, 0.5> }")));
}

TEST(ImageShadingLights, Shadowless) {
  EXPECT_TRUE(same_as_stock(lit_by(
      "light_source { <-6, 9, -7> rgb 0.7 } light_source { <5, 6, -3> rgb 0.5 shadowless }")));
}

TEST(ImageShadingLights, Spotlight) {
  EXPECT_TRUE(same_as_stock(lit_by(
      "light_source { <-3, 6, -4> rgb 1 spotlight point_at <0, 0.5, 0> radius 9 falloff 17 }")));
  EXPECT_TRUE(same_as_stock(
      lit_by("light_source { <-3, 6, -4> rgb 1 spotlight point_at <0, 0.5, 0> radius 20 "
             "falloff 28 tightness 30 }")));
  EXPECT_TRUE(
      same_as_stock(lit_by("light_source { <-3, 6, -4> rgb 1 spotlight point_at <0, 0.5, 0> }")));
}

TEST(ImageShadingLights, Cylinder) {
  EXPECT_TRUE(same_as_stock(lit_by(
      "light_source { <-3, 6, -4> rgb 1 cylinder point_at <0, 0.5, 0> radius 0.8 falloff 1.6 }")));
  EXPECT_TRUE(same_as_stock(
      lit_by("light_source { <-3, 6, -4> rgb 1 cylinder point_at <0, 0.5, 0> radius 1 falloff 2 "
             "tightness 3 }")));
}

TEST(ImageShadingLights, Parallel) {
  EXPECT_TRUE(
      same_as_stock(lit_by("light_source { <-3, 6, -4> rgb 1 parallel point_at <0, 0.5, 0> }")));
  EXPECT_TRUE(same_as_stock(
      lit_by("light_source { <0, 1, -0.4> rgb 1 parallel point_at <0.3, 0.5, 0.5> }")))
      << "points behind its plane are lit";
}

TEST(ImageShadingLights, Fading) {
  EXPECT_TRUE(
      same_as_stock(lit_by("light_source { <-3, 5, -3> rgb 1.5 fade_distance 4 fade_power 2 }")));
  EXPECT_TRUE(
      same_as_stock(lit_by("light_source { <-3, 5, -3> rgb 1.5 fade_distance 2 fade_power 1.5 "
                           "spotlight point_at <0, 0, 0> radius 25 falloff 35 }")));
}

TEST(ImageShadingLights, AreaLight) {
  for (const char* modifiers : {"", "adaptive 0", "adaptive 1", "adaptive 3"}) {
    EXPECT_TRUE(same_as_stock(
        lit_by(std::string("light_source { <-5, 7, -4> rgb 1 area_light <2, 0, 0>, <0, 1, 2>, 5, "
                           "7 ") +
               modifiers + " }")))
        << modifiers;
  }
}

TEST(ImageShadingLights, AreaLightCircularAndOriented) {
  for (const char* modifiers : {"circular", "circular orient", "adaptive 1 circular orient"}) {
    EXPECT_TRUE(same_as_stock(
        lit_by(std::string("light_source { <-5, 7, -4> rgb 1 area_light <3, 0, 0>, <0, 0, 3>, 6, "
                           "6 ") +
               modifiers + " }")))
        << modifiers;
  }
}

TEST(ImageShadingLights, AreaLightOfOneRow) {
  EXPECT_TRUE(
      same_as_stock(lit_by("light_source { <-5, 7, -4> rgb 1 area_light <4, 0, 0>, <0, 0, 1>, 9, 1 "
                           "adaptive 1 }")));
}

TEST(ImageShadingLights, AreaSpotlightAndParallelArea) {
  EXPECT_TRUE(same_as_stock(
      lit_by("light_source { <-3, 6, -4> rgb 1 spotlight point_at <0, 0.5, 0> radius 15 falloff 25 "
             "area_light <1, 0, 0>, <0, 0, 1>, 4, 4 adaptive 1 }")));
  EXPECT_TRUE(
      same_as_stock(lit_by("light_source { <-3, 6, -4> rgb 1 parallel point_at <0, 0.5, 0> "
                           "area_light <1, 0, 0>, <0, 0, 1>, 4, 4 }")));
}

TEST(ImageShadingLights, AreaJitterIsClose) {
  EXPECT_TRUE(same_as_stock(
      lit_by("light_source { <-5, 7, -4> rgb 1 area_light <2, 0, 0>, <0, 0, 2>, 5, 5 jitter }"),
      Grade::close));
}

TEST(ImageShadingLights, NearTheLightAndAlmostTouching) {
  EXPECT_TRUE(same_as_stock(lit_by("light_source { <-1.2, 0.7, -0.9> rgb 1 }")));
}

}  // namespace
