// Rays are values: whoever follows them, in whatever order, gets the same bits. All rays of a picture,
// one level of the trees after the other, the last first, beside the integrator that goes depth first.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "core/trace/integrator.h"
#include "core/trace/plain_shadow_tester.h"
#include "core/trace/ray_stepper.h"
#include "core/trace/thread_context.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::core::test {
namespace {

struct BreadthScene {
  const char* name;
  std::size_t levels;  ///< of the deepest tree of rays, at least
  bool random;         ///< another sample of a pixel looks different
  const char* text;
};

const BreadthScene kScenes[] = {
    {"mirrors", 5, false,
     "plane { z, 3 pigment { rgb 0.3 } finish { reflection 0.7 } }"
     "plane { -z, 5 pigment { rgb 0.2 } finish { reflection { 0.2, 0.9 } metallic } }"
     "sphere { <-1, 1, 0>, 1 pigment { rgb <0.8, 0.3, 0.2> } finish { reflection 0.5 "
     "reflection_exponent 0.7 phong 0.4 } }"},
    {"glass", 5, false,
     "sphere { <0, 1, 0>, 1 pigment { rgbf <0.9, 1, 0.9, 0.8> } finish { reflection { 0, 1 "
     "fresnel } conserve_energy } interior { ior 1.5 fade_distance 1 fade_power 2 } }"
     "box { <-2, 0, 0>, <-1, 2, 1> pigment { rgbt 0.7 } interior { ior 2.2 } rotate 20*y }"},
    {"clear panes", 8, false,
     "#for (I, 0, 9) box { <-2, 0, I/4>, <2, 2, I/4 + 0.1> pigment { rgbt <1, 1, 1, 0.8> } } "
     "#end"},
    {"subsurface light", 3, true,
     "global_settings { mm_per_unit 10 subsurface { samples 6, 3 } }"
     "sphere { <0, 1, 0>, 1 pigment { rgb 0.9 } finish { reflection 0.3 subsurface { translucency "
     "60 } } interior { ior 1.3 } }"
     "sphere { <1, 1, 2>, 1 pigment { rgb <0.9, 0.5, 0.3> } finish { subsurface { translucency 30 "
     "} } interior { ior 1.2 } }"},
    {"dispersion", 4, false,
     "prism { linear_spline 0, 3, 4 <-1, 0>, <1, 0>, <0, 1.5>, <-1, 0> pigment { rgbf 1 } "
     "interior { ior 1.5 dispersion 1.1 } finish { reflection 0.1 } }"
     "sphere { <0, 1, 2>, 0.8 pigment { rgbf 0.9 } interior { ior 1.4 dispersion 0.9 "
     "dispersion_samples 11 } }"},
    {"layers", 3, false,
     "sphere { <0, 1, 0>, 1.2 texture { pigment { checker rgbt 0.6 rgb <1, 0, 0> scale 0.3 } "
     "finish { reflection 0.3 } } texture { pigment { gradient y color_map { [0 rgbf 0.7] [1 rgb "
     "0.5] } } normal { bumps 0.4 scale 0.2 } finish { reflection { 0.4 } specular 0.4 } } }"},
    {"textures by place", 3, false,
     "box { <-1.5, 0, 0>, <1.5, 2, 1> texture { gradient x texture_map { [0.2 pigment { rgbt 0.5 } "
     "finish { reflection 0.2 }] [0.8 pigment { rgb <0.2, 0.4, 0.9> } finish { reflection 0.6 }] } "
     "} interior { ior 1.3 } }"},
    {"interior textures", 4, false,
     "sphere { <0, 1, 0>, 1 texture { pigment { rgbt 0.5 } } interior_texture { pigment { rgbt "
     "<0.2, 0.5, 1, 0.6> } finish { reflection 0.4 } } }"},
    {"nested interiors", 6, false,
     "sphere { <0, 1, 0>, 1.3 hollow pigment { rgbf 0.9 } interior { ior 1.2 } }"
     "sphere { <0.2, 1, 0>, 0.9 hollow pigment { rgbf 0.9 } interior { ior 1.6 } }"
     "sphere { <-0.5, 1, 0.2>, 0.7 pigment { rgbf 0.9 } finish { reflection { 0, 1 fresnel } } "
     "interior { ior 1.9 } } global_settings { max_trace_level 8 }"},
    {"thin films", 3, false,
     "sphere { <0, 1, 0>, 1 pigment { rgbt 0.4 } finish { irid { 0.6 thickness 0.4 turbulence 0.3 "
     "} "
     "reflection 0.5 } interior { ior 1.4 } }"},
    {"fog", 4, false,
     "fog { distance 9 rgb <0.6, 0.7, 0.8> } fog { fog_type 2 distance 4 rgbt <0.9, 0.8, 0.6, 0.2> "
     "fog_offset 0.4 fog_alt 0.5 turbulence 0.3 } sphere { <0, 1, 0>, 1 pigment { rgbt 0.7 } "
     "finish "
     "{ reflection 0.4 } }"},
    {"rainbows with jitter", 2, true,
     "rainbow { angle 40 width 30 distance 20 direction <0, -0.2, 1> jitter 0.4 color_map { [0 "
     "rgbt "
     "<1, 0, 0, 0.4>] [0.5 rgbt <0, 1, 0, 0.4>] [1 rgbt <0, 0, 1, 0.4>] } } sphere { <0, 1, 0>, 1 "
     "pigment { rgb 0.2 } finish { reflection 0.6 } }"},
    {"crand", 3, true,
     "sphere { <0, 1, 0>, 1 texture { pigment { checker rgbt 0.5 rgb 0.7 scale 0.2 } finish { "
     "crand "
     "0.3 reflection 0.3 } } texture { pigment { rgbt 0.4 } finish { crand 0.5 diffuse 0.9 } } }"},
    {"area lights with jitter", 3, true,
     "light_source { <1, 5, -2>, rgb 0.7 area_light 2*x, 2*z, 5, 5 adaptive 1 jitter } sphere { "
     "<0, "
     "1, 0>, 0.8 pigment { rgbt 0.5 } finish { reflection 0.5 } }"},
    {"area illumination", 2, true,
     "light_source { <1, 4, -2>, rgb 0.7 area_light 2*x, 2*z, 3, 3 jitter circular orient "
     "area_illumination on } sphere { <0, 1, 0>, 0.8 pigment { rgb 0.6 } finish { reflection 0.5 "
     "crand 0.2 phong 0.5 } }"},
    {"media of the air", 3, true,
     "media { scattering { 1, rgb 0.1 } samples 4 intervals 2 method 3 jitter 0.8 density { bozo "
     "scale 0.4 } } sphere { <0, 1, 0>, 1 pigment { rgbt 0.6 } hollow finish { reflection 0.4 } }"},
    {"media in solids", 4, true,
     "sphere { <0, 1, 0>, 1.2 hollow pigment { rgbt 1 } interior { media { scattering { 2, rgb 0.9 "
     "} "
     "emission 0.1 method 1 samples 3, 9 intervals 3 density { spherical translate y } } } }"
     "box { <-0.3, 0.3, -0.3>, <0.3, 1.5, 0.3> hollow pigment { rgbt 0.8 } finish { reflection 0.2 "
     "} "
     "interior { ior 1.1 media { absorption <1, 2, 3> method 2 samples 4 jitter 1 density { bozo } "
     "} } }"},
    {"area lights in media", 2, true,
     "light_source { <1, 4, -1>, rgb 0.9 area_light x, z, 4, 4 adaptive 0 jitter } media { "
     "scattering { 4, rgb 0.15 } samples 5 } sphere { <0, 1, 0>, 0.7 pigment { rgb 0.5 } finish { "
     "reflection 0.5 } }"},
    {"lights of all kinds", 3, false,
     "light_source { <-2, 4, -2>, rgb 0.6 spotlight radius 12 falloff 20 point_at y } light_source "
     "{ "
     "<3, 4, 0>, rgb 0.5 cylinder radius 1 falloff 2 point_at 0 } light_group { light_source { <0, "
     "5, "
     "-3>, rgb 0.9 } sphere { <1, 1, 0>, 0.8 pigment { rgbf 0.6 } finish { reflection 0.3 } } } "
     "sphere { <-1, 1, 0>, 0.8 pigment { rgb 0.7 } finish { reflection 0.6 } }"},
    {"from within glass", 3, true,
     "sphere { 0, 30 hollow pigment { rgbt 0.9 } finish { reflection 0.3 crand 0.2 } interior { "
     "ior "
     "1.5 } } sphere { <0, 1, 0>, 1 hollow pigment { rgbt 0.8 } interior { ior 1.1 } }"},
    {"everything at once", 6, true,
     "global_settings { max_trace_level 7 adc_bailout 0.01 } light_source { <2, 6, -3>, rgb 0.5 "
     "area_light x, y, 3, 3 jitter } fog { distance 40 rgb 0.5 } media { scattering { 1, rgb 0.02 "
     "} "
     "samples 3 jitter 0.6 method 3 density { bozo } } sphere { <-0.6, 1, 0>, 0.9 pigment { rgbf "
     "0.8 "
     "} finish { reflection { 0.1, 0.8 fresnel } crand 0.1 irid { 0.3 } } interior { ior 1.5 "
     "dispersion 1.05 } } box { <0.3, 0, 0>, <1.3, 1.4, 1> texture { bozo texture_map { [0.4 "
     "pigment "
     "{ rgbt 0.5 } finish { reflection 0.5 crand 0.3 }] [0.6 pigment { rgb 0.6 }] } } }"},
};

constexpr const char* kStage =
    "background { rgb <0.2, 0.3, 0.5> } light_source { <-4, 6, -5>, rgb 0.8 } plane { y, 0 pigment "
    "{ "
    "checker rgb 0.8 rgb <0.4, 0.3, 0.2> } hollow } ";
constexpr std::int32_t kWide = 24, kHigh = 18;

struct CameraRay {
  Ray ray;
  Pixel pixel;
  std::uint64_t key;
};

std::vector<CameraRay> camera_rays(std::uint32_t sample) {
  std::vector<CameraRay> all;
  for (std::int32_t row = 0; row < kHigh; ++row) {
    for (std::int32_t column = 0; column < kWide; ++column) {
      const Vec3 along{(column + 0.5) / kWide - 0.5, 0.3 - 0.8 * (row + 0.5) / kHigh, 1.0};
      all.push_back({{{0.1, 1.3, -4}, normalized(along)},
                     {static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)},
                     sample_key(column, row, sample)});
    }
  }
  return all;
}

std::vector<Radiance> depth_first(const Scene& scene, std::uint32_t sample) {
  ThreadContext context(scene, false);
  PlainShadowTester shadows(context);
  Integrator integrator(context, shadows);
  std::vector<Radiance> seen;
  for (const CameraRay& ray : camera_rays(sample)) {
    seen.push_back(integrator.trace(ray.ray, ray.pixel, ray.key));
  }
  return seen;
}

/// Queues of rays, one a level of the trees.
class BreadthFirst {
 public:
  explicit BreadthFirst(const Scene& scene)
      : m_context(scene, false), m_shadows(m_context),
        m_stepper(m_context, m_shadows, {scene.settings().adc_bailout}) {}

  std::vector<Radiance> picture(std::uint32_t sample) {
    m_levels.assign(1, {});
    for (const CameraRay& ray : camera_rays(sample)) {
      m_levels[0].push_back({m_stepper.begin(ray.ray, ray.pixel, ray.key)});
    }
    while (!m_levels.back().empty()) step_all();
    m_levels.pop_back();
    for (std::size_t level = m_levels.size(); level-- > 0;) resolve_all(level);
    std::vector<Radiance> seen;
    for (const Node& node : m_levels[0]) seen.push_back(node.seen);
    return seen;
  }
  std::size_t levels() const { return m_levels.size(); }

 private:
  struct Node {
    RayState state;
    RayRecord record{};
    std::size_t first = 0;  ///< of those that go on, in the next level
    Radiance seen{};
  };

  void step_all() {
    std::vector<Node> next;
    std::vector<Node>& level = m_levels.back();
    for (auto node = level.rbegin(); node != level.rend(); ++node) {
      if (m_stepper.is_cut(node->state)) continue;
      m_stepper.step(node->state, node->record);
      node->first = next.size();
      for (const OnwardRay& onward : node->record.onward) next.push_back({onward.state});
    }
    m_levels.push_back(std::move(next));
  }
  void resolve_all(std::size_t level) {
    for (Node& node : m_levels[level]) {
      if (m_stepper.is_cut(node.state)) continue;
      std::size_t next = node.first;
      node.seen =
          node.record.gather([&](const OnwardRay&) { return m_levels[level + 1][next++].seen; });
      m_stepper.arrive(node.state, node.record, node.seen);
    }
  }

  ThreadContext m_context;
  PlainShadowTester m_shadows;
  RayStepper m_stepper;
  std::vector<std::vector<Node>> m_levels;
};

std::size_t differences(const std::vector<Radiance>& a, const std::vector<Radiance>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i].rgb == b[i].rgb && a[i].transmit == b[i].transmit)) ++count;
  }
  return count;
}

TEST(UnitBreadthFirst, HasTheBitsOfDepthFirst) {
  for (const BreadthScene& each : kScenes) {
    SCOPED_TRACE(each.name);
    parser::test::SceneText text(std::string(kStage) + each.text);
    const Scene scene(text.build(), {});
    BreadthFirst breadth(scene);
    const std::vector<Radiance> first = depth_first(scene, 0);
    EXPECT_EQ(differences(breadth.picture(0), first), 0u);
    EXPECT_GE(breadth.levels(), each.levels);
    const std::vector<Radiance> second = depth_first(scene, 1);
    EXPECT_EQ(differences(breadth.picture(1), second), 0u);
    EXPECT_EQ(differences(first, second) > 0, each.random);
  }
}

}  // namespace
}  // namespace lentray::core::test
