#include "core/trace/reflectance.h"

#include <gtest/gtest.h>

using namespace lentray::core;

namespace {

LayerLight face_on() {
  LayerLight on;
  on.towards_light = {0, 1, 0};
  on.eye = {0, -1, 0};
  on.normal = {0, 1, 0};
  on.light = Rgb(1.0f);
  on.pigment = {1.0f, 0.5f, 0.0f};
  return on;
}

TEST(UnitCoreReflectance, DiffuseFollowsTheCosineAndBrilliance) {
  const Rgb light(1.0f), pigment{1.0f, 0.5f, 0.0f};
  const auto diffuse = [&](const Finish& finish, double random) {
    return diffuse_light(finish, 0.8, light, pigment, 0.5, 1.0, random);
  };
  Finish finish;
  EXPECT_NEAR(diffuse(finish, 0).r, 0.4, 1e-6);
  EXPECT_NEAR(diffuse_light(finish, -0.8, light, pigment, 0.5, 0.5, 0).r, 0.2, 1e-6);
  finish.brilliance = 3;
  EXPECT_NEAR(diffuse(finish, 0).r, 0.5 * 0.512, 1e-6);
  EXPECT_NEAR(diffuse(finish, 0).g, 0.25 * 0.512, 1e-6);
  finish.crand = 0.2;
  EXPECT_NEAR(diffuse(finish, 0.5).r, 0.5 * 0.512 - 0.1, 1e-6);
  EXPECT_EQ(diffuse_light(finish, 0.8, light, pigment, 0.0, 1.0, 0.5), Rgb()) << "no crand alone";
}

TEST(UnitCoreReflectance, WholePowersAreAsNearAsOthers) {
  for (const double exponent : {0.0, 0.5, 1.0, 2.0, 3.0, 20.0, 20.000001, 100.0, 1000.0, 1024.0,
                                1025.0, 1e9, 1e300, -2.0}) {
    for (const double x : {1e-300, 0.01, 0.3, 0.999, 1.0, 1.0000001}) {
      const double expected = std::pow(x, exponent);
      if (std::isinf(expected)) {
        EXPECT_TRUE(std::isinf(power(x, exponent))) << x << ' ' << exponent;
      } else {
        EXPECT_NEAR(power(x, exponent), expected, 1e-12 * expected) << x << ' ' << exponent;
      }
    }
  }
}

TEST(UnitCoreReflectance, PhongIsAPowerOfTheMirrorAngle) {
  LayerLight on = face_on();
  on.towards_light = {0.6, 0.8, 0};
  Finish finish;
  finish.phong = 0.5;
  finish.phong_size = 4;
  EXPECT_NEAR(highlights(finish, on).r, 0.5 * 0.4096, 1e-6);
}

TEST(UnitCoreReflectance, SpecularUsesTheHalfwayVector) {
  LayerLight on = face_on();
  on.towards_light = {0.6, 0.8, 0};
  Finish finish;
  finish.specular = 1.0;
  finish.roughness_exponent = 2;
  EXPECT_NEAR(highlights(finish, on).r, 0.9, 1e-6) << "cos^2 of half of acos 0.8";
}

TEST(UnitCoreReflectance, MetallicTintsTheHighlightFaceOn) {
  LayerLight on = face_on();
  Finish finish;
  finish.specular = 1.0;
  finish.metallic = 1.0;
  const Rgb tinted = highlights(finish, on);
  EXPECT_NEAR(tinted.r, 1.0, 1e-5);
  EXPECT_NEAR(tinted.g, 0.5, 1e-5);
  EXPECT_NEAR(tinted.b, 0.0, 1e-5);
  on.towards_light = normalized(Vec3{1, 0.001, 0});
  on.eye = normalized(Vec3{1, -0.001, 0});
  EXPECT_GT(highlights(finish, on).b, 0.9) << "at grazing angles the light keeps its colour";
}

TEST(UnitCoreReflectance, ReflectionVariesFromMinimumToMaximum) {
  Finish finish;
  finish.reflection_variable = true;
  finish.reflection_min = Rgb(0.1f);
  finish.reflection_max = Rgb(0.9f);
  EXPECT_FLOAT_EQ(reflectivity(finish, 1.0, 1.0, {}).colour.r, 0.1f);
  EXPECT_FLOAT_EQ(reflectivity(finish, 0.0, 1.0, {}).colour.r, 0.9f);
  EXPECT_NEAR(reflectivity(finish, 0.5, 1.0, {}).colour.r, 0.5, 1e-6);
  finish.reflection_falloff = 2.0;
  EXPECT_NEAR(reflectivity(finish, 0.5, 1.0, {}).colour.r, 0.3, 1e-6);
  EXPECT_FLOAT_EQ(reflectivity(finish, 0.5, 1.0, {}).weight, 0.9f);
}

TEST(UnitCoreReflectance, FresnelAtNormalIncidenceAndBeyondTheCriticalAngle) {
  Finish finish;
  finish.reflection_fresnel = true;
  finish.reflection_max = Rgb(1.0f);
  EXPECT_NEAR(reflectivity(finish, 1.0, 1.5, {}).colour.r, 0.04, 1e-6);
  EXPECT_FLOAT_EQ(reflectivity(finish, 0.5, 1.0 / 1.5, {}).colour.r, 1.0f);
  EXPECT_NEAR(reflectivity(finish, 0.5, 1.0, {}).colour.r, 0.0, 1e-6) << "same interior";
}

}  // namespace
