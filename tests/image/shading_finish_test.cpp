// The finish block's reflection model against stock.
#include "tests/image/shading_scenes.h"

using namespace lentray::test;

namespace {

TEST(ImageShadingFinish, AmbientEmissionDiffuse) {
  EXPECT_TRUE(same_as_stock(
      finished("ambient rgb <0.3, 0.1, 0.2> emission rgb <0, 0.1, 0.2> diffuse 0.5")));
}

TEST(ImageShadingFinish, AmbientLightScalesAmbientAlone) {
  EXPECT_TRUE(same_as_stock(staged(
      "sphere { <0, 1, 0>, 1 pigment { rgb 1 } finish { ambient 0.4 emission 0.1 diffuse 0.3 } }",
      "light_source { <-6, 9, -7> rgb 1 }", "ambient_light rgb <0.2, 1, 2>")));
}

TEST(ImageShadingFinish, Brilliance) {
  EXPECT_TRUE(same_as_stock(finished("ambient 0 diffuse 0.8 brilliance 5")));
  EXPECT_TRUE(same_as_stock(finished("ambient 0 diffuse 0.8 brilliance 0.3")));
}

TEST(ImageShadingFinish, DiffuseFromBehind) {
  EXPECT_TRUE(same_as_stock(
      staged("disc { <0, 1.4, 0>, <0.3, 0.2, -1>, 1.2 pigment { rgb <0.4, 0.9, 0.3> }"
             " finish { ambient 0.05 diffuse 0.3, 0.6 specular 0.5 } }",
             "light_source { <3, 6, 9> rgb 1.2 } light_source { <-2, 4, -9> rgb 0.3 }")));
}

TEST(ImageShadingFinish, DoubleIlluminate) {
  EXPECT_TRUE(
      same_as_stock(staged("disc { <0, 1.4, 0>, <0.3, 0.2, -1>, 1.2 pigment { rgb <0.4, 0.9, 0.3> }"
                           " finish { ambient 0.05 diffuse 0.6 phong 0.3 } double_illuminate }",
                           "light_source { <3, 6, 9> rgb 1.2 }")));
}

TEST(ImageShadingFinish, Phong) {
  EXPECT_TRUE(same_as_stock(finished("ambient 0.1 diffuse 0.4 phong 0.8 phong_size 12")));
  EXPECT_TRUE(same_as_stock(finished("ambient 0.1 diffuse 0.4 phong 0.8 phong_size 180")));
}

TEST(ImageShadingFinish, Specular) {
  EXPECT_TRUE(same_as_stock(finished("ambient 0.1 diffuse 0.4 specular 0.8 roughness 0.02")));
  EXPECT_TRUE(same_as_stock(finished("ambient 0.1 diffuse 0.4 specular 0.5 roughness 0.3")));
}

TEST(ImageShadingFinish, MetallicHighlights) {
  EXPECT_TRUE(same_as_stock(finished("diffuse 0.3 specular 0.9 roughness 0.05 metallic")));
  EXPECT_TRUE(same_as_stock(finished("diffuse 0.3 phong 0.9 phong_size 20 metallic 0.6")));
}

TEST(ImageShadingFinish, PlainReflection) {
  EXPECT_TRUE(same_as_stock(finished("diffuse 0.3 reflection 0.6")));
  EXPECT_TRUE(same_as_stock(finished("diffuse 0.3 reflection rgb <0.9, 0.4, 0.1>")));
}

TEST(ImageShadingFinish, VariableReflection) {
  EXPECT_TRUE(same_as_stock(finished("diffuse 0.3 reflection { 0.05, 0.9 }")));
  EXPECT_TRUE(same_as_stock(
      finished("diffuse 0.3 reflection { rgb <0, 0.1, 0.3>, rgb <1, 0.8, 0.7> falloff 3 }")));
}

TEST(ImageShadingFinish, ReflectionExponent) {
  EXPECT_TRUE(same_as_stock(finished("diffuse 0.3 reflection 0.8 reflection_exponent 2.5")));
  EXPECT_TRUE(same_as_stock(finished("diffuse 0.3 reflection { 0.8 exponent 0.4 }")));
}

TEST(ImageShadingFinish, MetallicReflection) {
  EXPECT_TRUE(same_as_stock(finished("diffuse 0.3 reflection { 0.2, 0.9 metallic }")));
  EXPECT_TRUE(same_as_stock(finished("diffuse 0.3 reflection { 0.7 metallic 0.5 }")));
}

TEST(ImageShadingFinish, FresnelReflection) {
  EXPECT_TRUE(same_as_stock(
      staged("sphere { <0, 1, 0>, 1 pigment { rgb <0.2, 0.1, 0.1> }"
             " finish { ambient 0 diffuse 0.3 reflection { 0, 1 fresnel } } interior { ior 1.6 } }"
             "background { rgb <0.4, 0.5, 0.7> }")));
}

TEST(ImageShadingFinish, ConserveEnergy) {
  for (const char* conserve : {"", "conserve_energy"}) {
    EXPECT_TRUE(same_as_stock(
        staged(std::string("sphere { <0, 1, 0>, 1 pigment { rgbt <0.9, 0.9, 1, 0.8> }"
                           " finish { ambient 0 diffuse 0.2 reflection { 0.1, 0.9 fresnel } ") +
               conserve + " } interior { ior 1.5 } } background { rgb <0.4, 0.5, 0.7> }")));
  }
}

TEST(ImageShadingFinish, LayeredTextures) {
  EXPECT_TRUE(same_as_stock(staged(
      "sphere { <0, 1, 0>, 1"
      " texture { pigment { rgb <0.9, 0.6, 0.2> } finish { ambient 0.2 diffuse 0.6 } }"
      " texture { pigment { checker rgbt <0.2, 0.3, 1, 0.6> rgbf <1, 0.2, 0.3, 0.7> scale 0.4 }"
      "   finish { ambient 0.1 diffuse 0.5 phong 0.6 } }"
      " texture { pigment { rgbf <0.9, 1, 0.9, 0.9> } finish { reflection 0.2 specular 0.4 } } }"
      "background { rgb <0.4, 0.5, 0.7> }")));
}

TEST(ImageShadingFinish, CrandIsCloseAndItsMeanIsRight) {
  EXPECT_TRUE(same_as_stock(finished("ambient 0.2 diffuse 0.6 crand 0.2"), Grade::close));
}

}  // namespace
