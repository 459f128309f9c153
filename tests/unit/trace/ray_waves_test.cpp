// Rays that are followed wave by wave, with surfaces that are lit together, have the bits and the counts of rays that
// are followed one after the other.
#include "core/trace/ray_waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/processor.h"
#include "core/scene/scene.h"
#include "core/trace/first_hits.h"
#include "core/trace/integrator.h"
#include "core/trace/plain_shadow_tester.h"
#include "core/trace/random_key.h"
#include "core/trace/thread_context.h"
#include "shadow/auto_tester.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::core::test::waves {
namespace {

struct WaveScene {
  const char* name;
  const char* text;
};

const WaveScene kWaveScenes[] = {
    {"mirrors",
     R"(
    #for (I, 0, 4) #for (J, 0, 4) sphere { <I - 2, J - 1, mod(I + J, 3)>, 0.45 pigment { rgb <I /
    4, J / 4, 0.5> } finish { reflection 0.5 phong 0.5 phong_size 3.0827 } } #end #end plane { -z,
    -5 pigment { rgb 0.2 } finish { reflection { 0.2, 0.9 } metallic specular 0.3 roughness 0.02 }
    })"},
    {"between two mirrors",
     R"(
    plane { z, 3 pigment { rgb 0.1 } finish { reflection 0.95 } } plane { -z, 6 pigment { rgb 0.1
    } finish { reflection 0.95 } } sphere { <0, 1, 0>, 0.6 pigment { rgb <1, 0.2, 0.1> } }
    global_settings { max_trace_level 20 adc_bailout 0.01 })"},
    {"glass and what it filters",
     R"(
    sphere { <0, 1, 0>, 1 pigment { rgbf <0.9, 1, 0.9, 0.8> } finish { reflection { 0, 1 fresnel }
    conserve_energy phong 1 phong_size 90 } interior { ior 1.5 } } box { <-2, 0, 0>, <-1, 2, 1>
    pigment { rgbt 0.7 } interior { ior 2.2 } rotate 20*y } polygon { 5, <1, 0, -1>, <2, 0, -1>,
    <2, 2, 0>, <1, 2, 0>, <1, 0, -1> pigment { rgbf <1, 0.3, 0.3, 0.9> } finish { specular 0.8
    roughness 0.01 } })"},
    {"clear panes",
     R"(
    #for (I, 0, 8) box { <-2, 0, I/4>, <2, 2, I/4 + 0.1> pigment { rgbt <1, 1, 1, 0.9> } finish {
    reflection 0.2 } } #end global_settings { max_trace_level 6 adc_bailout 0.005 })"},
    {"textures that are not plain",
     R"(
    sphere { <-1, 1, 0>, 0.8 texture { pigment { checker rgbt 0.6 rgb <1, 0, 0> scale 0.3 } finish
    { reflection 0.3 } } texture { pigment { gradient y color_map { [0 rgbf 0.7] [1 rgb 0.5] } }
    normal { bumps 0.4 scale 0.2 } finish { reflection { 0.4 } specular 0.4 } } } sphere { <1, 1,
    0>, 0.8 pigment { rgb 0.8 } finish { metallic phong 0.9 irid { 0.4 } } } sphere { <0, 2.4, 0>,
    0.5 pigment { rgb 0.8 } finish { crand 0.3 brilliance 2 } } box { <-3, 0, 1>, <-2, 2, 2>
    pigment { rgb <0.3, 0.8, 0.4> } finish { diffuse 0.4, 0.3 } double_illuminate } sphere { <0,
    0.5, -1>, 0.4 texture { pigment { rgbt 0.5 } } interior_texture { pigment { rgbt <0.2, 0.5, 1,
    0.6> } finish { reflection 0.4 } } })"},
    {"patterns, bumps and layers",
     R"(
    sphere { <-1, 1, 0>, 0.9 pigment { granite scale 0.3 } normal { bumps 0.9 scale 0.05 } finish {
    phong 0.6 reflection { 0.1, 0.7 fresnel } } interior { ior 1.4 } } sphere { <1, 1, 0>, 0.9
    texture { pigment { wood turbulence 0.1 scale 0.2 color_map { [0 rgb <0.6, 0.4, 0.2>] [1 rgb
    <0.3, 0.2, 0.1>] } } finish { specular 0.4 } } texture { pigment { bozo scale 0.2 color_map {
    [0.3 rgbt 1] [0.6 rgbf <0.4, 0.6, 0.2, 0.5>] } } normal { wrinkles 1.4 scale 0.1 } finish {
    diffuse 0.3 phong 0.7 reflection 0.1 } } } box { <-3, 0, 1>, <-2, 2, 2> texture { checker
    texture { pigment { rgb <0.9, 0.8, 0.6> } finish { specular 0.5 metallic 0.7 } } texture {
    pigment { marble scale 0.2 } normal { dents 0.8 scale 0.1 } finish { brilliance 2.5 phong 0.2
    } } scale 0.3 } } sphere { <0, 2.4, 0>, 0.5 pigment { gradient y color_map { [0 rgb 1] [1 rgbt
    <1, 1, 1, 0.95>] } scale 0.4 } finish { diffuse 0 ambient 0.7 } } sphere { <0, 0.3, -1>, 0.3
    texture { gradient x texture_map { [0.2 pigment { rgb 0.2 }] [0.8 pigment { agate }] } scale
    0.3 } })"},
    {"spotlights and lights that fade",
     R"(
    light_source { <-2, 4, -2>, rgb 0.6 spotlight radius 12 falloff 20 tightness 3 point_at y }
    light_source { <0, 5, 3>, rgb 0.4 fade_distance 3 fade_power 2 } light_source { <2, 5, -3>,
    rgb <0.1, 0.5, 0.9> spotlight radius 5 falloff 6 fade_distance 2 fade_power 3 point_at y }
    sphere { <1, 1, 0>, 0.8 pigment { rgbf 0.6 } finish { reflection 0.3 phong 0.7 } } sphere {
    <-1, 1, 0>, 0.8 pigment { spotted scale 0.1 } normal { bumps 0.4 scale 0.1 } finish {
    reflection 0.6 phong 0.4 } })"},
    {"lights of all kinds",
     R"(
    light_source { <-2, 4, -2>, rgb 0.6 spotlight radius 12 falloff 20 point_at y } light_source {
    <3, 4, 0>, rgb 0.5 shadowless } light_source { <0, 5, 3>, rgb 0.4 fade_distance 3 fade_power 2
    } light_group { light_source { <0, 5, -3>, rgb 0.9 } sphere { <1, 1, 0>, 0.8 pigment { rgbf
    0.6 } finish { reflection 0.3 } } } sphere { <-1, 1, 0>, 0.8 pigment { rgb 0.7 } finish {
    reflection 0.6 phong 0.4 } })"},
    {"a light inside, and fog",
     R"(
    light_source { <0, 1.2, 0>, rgb <1, 0.5, 0.2> } difference { sphere { <0, 1, 0>, 1 } box {
    <-2, 0.7, -2>, <2, 1.1, 0> } pigment { rgb <0.8, 0.8, 1> } finish { phong 0.3 } } fog {
    distance 20 rgb 0.6 } sphere { <2, 1, 1>, 0.7 pigment { rgb 0.4 } finish { reflection 0.5
    diffuse 0.2 } })"},
    {"no diffuse light and no light",
     R"(
    sphere { <-1, 1, 0>, 0.8 pigment { rgb 0.7 } finish { diffuse 0 phong 0.7 reflection 0.3 } }
    light_source { <1, 5, -3>, rgb 0 } light_source { <1, 5, -4>, rgb -0.3 } sphere { <1, 1, 0>,
    0.8 pigment { rgbt <0.3, 0.4, 0.5, 1> } })"},
    {"media and a translucent ball",
     R"(
    global_settings { mm_per_unit 10 subsurface { samples 6, 3 } } sphere { <-1, 1, 0>, 0.9 pigment
    { rgbt 1 } hollow interior { media { scattering { 1, 0.5 } absorption 0.2 samples 3 } } }
    sphere { <1, 1, 0>, 0.8 pigment { rgb 0.8 } finish { reflection 0.2 subsurface { translucency
    0.4 } } interior { ior 1.3 } })"},
    {"textures that blend, layers that conserve energy",
     R"(
    sphere { <-1, 1, 0>, 0.9 texture { gradient y texture_map { [0 pigment { rgbt 0.4 } finish {
    reflection 0.3 crand 0.1 }] [1 pigment { rgb <0.8, 0.3, 0.1> } finish { phong 0.6 }] } } }
    sphere { <1, 1, 0>, 0.9 texture { pigment { rgb 0.7 } finish { reflection 0.2 } } texture {
    pigment { rgbf 0.6 } finish { reflection 0.5 conserve_energy irid { 0.3 } } } })"},
};

constexpr const char* kWaveStage =
    R"(
    background { rgb <0.2, 0.3, 0.5> } light_source { <-4, 6, -5>, rgb 0.8 } light_source { <5, 3,
    -6>, rgb <0.5, 0.4, 0.3> } polygon { 5, <-9, 0, -9>, <9, 0, -9>, <9, 0, 9>, <-9, 0, 9>, <-9,
    0, -9> pigment { rgb <0.4, 0.3, 0.2> } finish { reflection 0.1 } })";
constexpr std::uint32_t kWaveWide = 36, kWaveHigh = 24;

struct WaveRays {
  WaveRays() {
    for (std::uint32_t row = 0; row < kWaveHigh; ++row) {
      for (std::uint32_t column = 0; column < kWaveWide; ++column) {
        const Vec3 along{(column + 0.5) / kWaveWide - 0.5, 0.3 - 0.8 * (row + 0.5) / kWaveHigh,
                         1.0};
        rays.push_back({{0.1, 1.3, -4}, normalized(along)});
        pixels.push_back({column, row});
      }
    }
  }
  std::vector<Ray> rays;
  std::vector<Pixel> pixels;
};

struct Seen {
  std::vector<Radiance> light;
  Counters counters;
};

template <class Tester>
Seen one_by_one(const Scene& scene) {
  const WaveRays all;
  ThreadContext context(scene, false);
  Tester shadows(context);
  Integrator integrator(context, shadows);
  Seen seen;
  for (std::size_t i = 0; i < all.rays.size(); ++i) {
    seen.light.push_back(integrator.trace(all.rays[i], all.pixels[i]));
  }
  seen.counters = context.counters;
  return seen;
}

template <class Tester>
bool is_plain_enough(const Scene& scene) {
  ThreadContext context(scene, false);
  return Tester(context).plain() != nullptr;
}

/// Blocks of different sizes; of some and of those of few rays nobody knows what they meet.
template <class Tester>
Seen in_waves(const Scene& scene) {
  const WaveRays all;
  ThreadContext context(scene, false);
  Tester shadows(context);
  Integrator integrator(context, shadows);
  FirstHits hits(context);
  RayWaves waves(context, integrator, shadows);
  Seen seen;
  EXPECT_TRUE(waves.works());
  if (!waves.works()) return seen;
  seen.light.resize(all.rays.size());
  for (std::size_t first = 0, block = 0; first < all.rays.size(); ++block) {
    const std::size_t wanted = block % 5 == 4 ? 1 + block % RayWaves::kMost : RayWaves::kMost;
    const std::size_t most = std::min(wanted, all.rays.size() - first);
    std::span<const Ray> rays = std::span(all.rays).subspan(first, most);
    rays = rays.first(hits.find(rays));
    const std::size_t count = rays.size();
    std::vector<SampleOfPixel> samples;
    for (const Pixel& p : std::span(all.pixels).subspan(first, count)) {
      samples.push_back({p, sample_key(static_cast<std::int32_t>(p.column),
                                       static_cast<std::int32_t>(p.row), 0)});
    }
    waves.trace(rays, samples, block % 3 == 2 ? nullptr : &hits,
                std::span(seen.light).subspan(first, count));
    first += count;
  }
  seen.counters = context.counters;
  return seen;
}

std::size_t unequal(const std::vector<Radiance>& a, const std::vector<Radiance>& b) {
  if (a.size() != b.size()) return a.size() + b.size();
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i].rgb == b[i].rgb && a[i].transmit == b[i].transmit)) ++count;
  }
  return count;
}

void expect_same_counts(const Counters& a, const Counters& b) {
  EXPECT_EQ(a.camera_rays, b.camera_rays);
  EXPECT_EQ(a.reflected_rays, b.reflected_rays);
  EXPECT_EQ(a.refracted_rays, b.refracted_rays);
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    EXPECT_EQ(a.lights[i].rays, b.lights[i].rays) << "light " << i;
    EXPECT_EQ(a.lights[i].blocked, b.lights[i].blocked) << "light " << i;
    EXPECT_EQ(a.lights[i].hits, b.lights[i].hits) << "light " << i;
    EXPECT_EQ(a.lights[i].misses, b.lights[i].misses) << "light " << i;
  }
}

TEST(UnitRayWaves, HaveTheBitsOfRaysThatAreFollowedAlone) {
  if (!has_avx2()) GTEST_SKIP();
  for (const WaveScene& each : kWaveScenes) {
    SCOPED_TRACE(each.name);
    parser::test::SceneText text(std::string(kWaveStage) + each.text);
    Scene scene(text.build(), {});
    scene.build_light_buffers(1'000'000);
    const Seen alone = one_by_one<PlainShadowTester>(scene);
    const Seen waves = in_waves<PlainShadowTester>(scene);
    EXPECT_EQ(unequal(alone.light, waves.light), 0u);
    expect_same_counts(alone.counters, waves.counters);
    if (!is_plain_enough<shadow::AutoTester>(scene)) continue;  // lights with caches
    const Seen by_auto = one_by_one<shadow::AutoTester>(scene);
    const Seen auto_waves = in_waves<shadow::AutoTester>(scene);
    EXPECT_EQ(unequal(by_auto.light, auto_waves.light), 0u);
    expect_same_counts(by_auto.counters, auto_waves.counters);
  }
}

TEST(UnitRayWaves, LeaveOutWhatIsFollowedAlone) {
  for (const char* more : {"media { scattering { 1, rgb 0.1 } }", "#declare Nothing = 0;",
                           R"(
    global_settings { subsurface { } mm_per_unit 10 } sphere { y, 1 pigment { rgb 1 } finish {
    subsurface { translucency 10 } } interior { ior 1.3 } })"}) {
    parser::test::SceneText text(std::string(kWaveStage) + more);
    const Scene scene(text.build(), {});  // without light buffers
    ThreadContext context(scene, false);
    PlainShadowTester shadows(context);
    Integrator integrator(context, shadows);
    EXPECT_FALSE(RayWaves(context, integrator, shadows).works());
  }
}

}  // namespace
}  // namespace lentray::core::test::waves
