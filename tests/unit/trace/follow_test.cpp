// The light along rays that gather, as passes and shading ask for it.
#include "core/trace/integrator.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <set>

#include "core/trace/plain_shadow_tester.h"
#include "core/trace/thread_context.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

using core::Vec3;

/// A scene and what a thread traces it with.
struct Traced {
  explicit Traced(const std::string& sdl)
      : text(sdl), scene(text.build(), {}), context(scene, false), tester(context),
        tracer(context, tester) {}
  core::Rgb along(const Vec3& from, const Vec3& direction, float weight = 1.0f, int level = 0) {
    return tracer.gather({{from, core::normalized(direction)}, weight, level}).light;
  }
  SceneText text;
  core::Scene scene;
  core::ThreadContext context;
  core::PlainShadowTester tester;
  core::Integrator tracer;
};

/// Light that a level point gets from all sides, over pi: directions as dense as their cosine.
double gathered(Traced& scene, const Vec3& point) {
  constexpr int kRings = 200, kSectors = 200;
  double sum = 0.0;
  for (int i = 0; i < kRings; ++i) {
    for (int j = 0; j < kSectors; ++j) {
      const double r = std::sqrt((i + 0.5) / kRings);
      const double phi = 2.0 * std::numbers::pi * (j + 0.5) / kSectors;
      const Vec3 to{r * std::cos(phi), std::sqrt(1.0 - r * r), r * std::sin(phi)};
      sum += static_cast<double>(scene.along(point, to).g);
    }
  }
  return sum / (kRings * kSectors);
}

TEST(UnitFollow, GathersTheLightOfABall) {
  // A ball of radius a whose middle is d above the point sends it (a/d)^2 of its radiance.
  Traced scene(
      "sphere { <0, 3, 0>, 1.5 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 0.8 } }"
      "plane { y, 0 pigment { rgb 1 } }");
  EXPECT_NEAR(gathered(scene, {0, 1e-3, 0}), 0.8 * 0.25, 1e-3);
}

TEST(UnitFollow, WhatGoesOnEndsWhereThatOfCameraRaysDoes) {
  Traced scene(
      "global_settings { max_trace_level 3 adc_bailout 0.1 } background { rgb 0.5 } "
      "plane { y, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }");
  const Vec3 from{0, 1, 0}, down{0.1, -1, 0};
  EXPECT_FLOAT_EQ(scene.along(from, down).r, 0.5f);
  EXPECT_FLOAT_EQ(scene.along(from, down, 1.0f, 1).r, 0.5f);
  EXPECT_FLOAT_EQ(scene.along(from, down, 1.0f, 2).r, 0.0f);  // the image is on level 3
  EXPECT_FLOAT_EQ(scene.along(from, down, 0.1f).r, 0.5f);
  EXPECT_FLOAT_EQ(scene.along(from, down, 0.09f).r, 0.0f);
  // The ray itself always sees.
  EXPECT_FLOAT_EQ(scene.along(from, -down, 1.0f, 7).r, 0.5f);
  EXPECT_FLOAT_EQ(scene.along(from, -down, 0.09f).r, 0.5f);
  EXPECT_FLOAT_EQ(scene.along(from, down, 1.0f, 2).r, 0.0f) << "that of another is not changed";
}

TEST(UnitFollow, TellsHowFarTheRayCame) {
  Traced scene("sphere { <0, 5, 0>, 1 pigment { rgb 1 } finish { ambient 0.5 } }");
  const core::GatheredRay met = scene.tracer.gather({{{0, 0, 0}, {0, 1, 0}}, 1.0f, 0});
  EXPECT_DOUBLE_EQ(met.distance, 4.0);
  EXPECT_FLOAT_EQ(met.importance, 1.0f);
  const core::GatheredRay sky = scene.tracer.gather({{{0, 0, 0}, {0, -1, 0}}, 1.0f, 0});
  EXPECT_EQ(sky.distance, core::Bounds::kInf);
  EXPECT_FLOAT_EQ(sky.importance, 1.0f) << "without radiosity, too";
}

TEST(UnitFollow, IsWhatTheCameraSees) {
  Traced scene(
      "light_source { <3, 5, -4>, 1 } background { rgb <.2, .3, .5> }"
      "plane { y, 0 pigment { checker rgb 1, rgb .2 } finish { reflection .3 } }"
      "sphere { <0, 1, 0>, 1 pigment { rgbt <1, .9, .8, .7> } finish { reflection .2 specular .5 } "
      "  interior { ior 1.4 } }"
      "box { <1.2, 0, -1>, <2, 1, 1> pigment { rgb <.9, .3, .2> } }");
  std::set<float> seen;
  for (int i = 0; i < 400; ++i) {
    const Vec3 from{0, 1.5, -5};
    const Vec3 to = core::normalized({0.1 * (i % 20) - 1.0, 0.05 * (i / 20) - 0.7, 1.0});
    const core::Rgb camera = scene.tracer.trace({from, to}, {}).rgb;
    const core::Rgb asked = scene.along(from, to);
    EXPECT_EQ(asked, camera) << i;
    seen.insert(asked.g);
  }
  EXPECT_GT(seen.size(), 150u);
}

}  // namespace
}  // namespace lentray::parser::test
