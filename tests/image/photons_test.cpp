// Light of photons beside stock, which has one thread: the photons are the same, and so is what is gathered of
// them. And truths that need no stock.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/render.h"

namespace lentray::test::photons {
namespace {

constexpr const char* kLamp =
    "light_source { <1.5, 5, -1> rgb 1 photons { reflection on refraction on } }\n";
constexpr const char* kGlass =
    " pigment { rgbf <1, 0.97, 0.92, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.4 } "
    "interior { ior 1.5 } photons { target reflection on refraction on } }\n";

constexpr const char* kSettings = "spacing 0.03";

/// A floor and a wall with something that bends or mirrors light. The floor is not at 0: what
/// roundings leave of a photon's height there decides its place in the tree.
SceneText scene_of(const std::string& things, const std::string& settings = kSettings,
                   const std::string& lights = kLamp) {
  SceneText scene;
  scene.sdl = R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 photons { )" +
              settings + R"( } }
camera { location <0, 2.5, -4.5> look_at <0, 0.4, 0> angle 45 }
#default { finish { ambient 0.05 diffuse 0.7 } }
plane { y, -0.01 pigment { rgb <0.9, 0.85, 0.8> } }
plane { -z, -2.5 pigment { rgb <0.6, 0.7, 0.9> } }
)" + lights + things;
  return scene;
}

struct Case {
  const char* name;
  SceneText scene;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class ImagePhotons : public ::testing::TestWithParam<Case> {};

/// Not exact everywhere: rounding decides which photons a tree hides (core/photon/photon_tree.h).
TEST_P(ImagePhotons, AreStocks) { EXPECT_TRUE(same_as_stock(GetParam().scene, Grade::match)); }

std::string glass(const std::string& shape) { return shape + kGlass; }
std::string ball(const std::string& more = "") {
  return "sphere { <0, 0.8, 0>, 0.6 " + more + kGlass;
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImagePhotons,
    ::testing::Values(
        Case{"Lens", scene_of(glass("intersection { sphere { <0, 0.2, 0>, 1.2 } sphere { <0, 1.8, "
                                    "0>, 1.2 } bounded_by { box { <-0.95, 0.5, -0.95>, <0.95, 1.5, "
                                    "0.95> } }"))},
        Case{"Prism",
             scene_of(glass("prism { -0.8, 0.8, 4, <-0.5, 0>, <0.5, 0>, <0, 0.8>, <-0.5, 0> rotate "
                            "-90*x translate 0.3*y"))},
        Case{
            "MirrorRing",
            scene_of("cylinder { 0, 0.5*y, 0.8 open pigment { rgb <1, 0.8, 0.4> } finish { diffuse "
                     "0.1 reflection 0.8 metallic } photons { target reflection on } }")},
        Case{
            "GlassOfWater",
            scene_of("difference { cylinder { 0.1*y, 1.2*y, 0.5 } cylinder { 0.2*y, 1.3*y, 0.44 }" +
                     std::string(kGlass) +
                     "cylinder { 0.2001*y, 0.9*y, 0.4399 pigment { rgbf "
                     "<0.9, 0.97, 1, 0.97> } finish { ambient 0 diffuse 0.05 } interior { ior 1.33 "
                     "} photons { target reflection on refraction on } }")},
        Case{
            "ColouredGlass",
            scene_of("box { <-0.7, 0.6, -0.5>, <0.7, 0.8, 0.5> pigment { rgbf <1, 0.3, 0.1, 0.9> } "
                     "interior { ior 1.4 fade_distance 0.5 fade_power 2 fade_color <0.9, 0.5, 0.2> "
                     "} photons { target refraction on } }")},
        Case{
            "AreaLight",
            scene_of(ball(), "spacing 0.05",
                     "light_source { <1.5, 5, -1> rgb 1 area_light x, z, 3, 3 photons { reflection "
                     "on refraction on area_light } }")},
        Case{"TwoLights",
             scene_of(ball(), "spacing 0.04",
                      std::string(kLamp) +
                          "light_source { <-3, 4, -2> rgb <0.3, 0.4, 0.8> spotlight "
                          "point_at <0, 0.8, 0> radius 12 falloff 15 photons { refraction on } }")},
        Case{"Parallel",
             scene_of(ball(), kSettings,
                      "light_source { <2, 8, -1> rgb 0.9 parallel point_at 0 photons { refraction "
                      "on reflection on } }")},
        Case{
            "PassThrough",
            scene_of(ball() + "box { <-1, 2, -1>, <1, 2.05, 1> pigment { rgbt <0.5, 1, 0.6, 0.8> } "
                              "photons { pass_through } }")},
        Case{
            "CollectOff",
            scene_of(ball() + "box { <-1.6, 0, -0.8>, <-0.3, 0.1, 0.8> pigment { rgb 1 } photons { "
                              "collect off } }")},
        Case{"Nested",
             scene_of(ball() +
                      "sphere { <0, 0.8, 0>, 0.3 pigment { rgbf 0.98 } interior { ior 1.2 } "
                      "photons { target refraction on } }")},
        Case{"Scaled",
             scene_of("sphere { 0, 1 scale <0.8, 0.3, 0.5> translate y" + std::string(kGlass))},
        Case{"TargetsBehindEachOther", scene_of(glass("sphere { <0.6, 2.2, -0.4>, 0.35") + ball())},
        Case{
            "LightInside",
            scene_of(glass("sphere { <0, 1.1, 0>, 0.9"), "spacing 0.015",
                     "light_source { <0.1, 1.2, 0> rgb 0.7 photons { refraction on reflection on } "
                     "}")},
        Case{"TranslucentCsg",
             scene_of("difference { box { <-0.7, 0.2, -0.5>, <0.7, 1, 0.5> } sphere { <0.3, 1, "
                      "-0.3>, 0.5 pigment { rgbf <1, 0.6, 0.6, 0.9> } }" +
                      std::string(kGlass))},
        Case{
            "Highlights",
            scene_of(ball() + "plane { y, 0.01 pigment { rgb 0.5 } finish { specular 0.8 roughness "
                              "0.02 phong 0.3 } clipped_by { cylinder { -y, y, 1 } } }")},
        Case{"Layers",
             scene_of(ball() + "disc { 0.01*y, y, 1.2 texture { pigment { rgb x } } "
                               "texture { pigment { checker rgb z, rgbt <1, 1, 0, 0.6> scale 0.2 "
                               "} normal { bumps 0.4 scale 0.1 } } }")},
        Case{
            "DiffuseBack",
            scene_of(ball() + "disc { <0, 0.2, 0>, <0, 1, -0.3>, 1.2 pigment { rgb <1, 0.9, 0.6> } "
                              "finish { diffuse 0.4, 0.4 } }")},
        Case{"DiffuseBackFromBehind",
             scene_of(ball() + "disc { <-0.25, 0.3, 0.15>, <0, 0.8, 0.6>, 0.6 pigment { rgb <1, "
                               "0.9, 0.6> } finish { diffuse 0.4, 0.4 } }")},
        Case{"Irid", scene_of(ball() + "disc { 0.01*y, y, 1.2 pigment { rgb 0.6 } finish { irid { "
                                       "0.5 thickness 0.6 } } }")},
        Case{"Gather", scene_of(ball(), "spacing 0.03 gather 10, 60 radius 0.25")},
        Case{"ExpandThresholds",
             scene_of(ball(), "spacing 0.05 radius 0.1 expand_thresholds 0.5, 10")},
        Case{"Radius", scene_of(ball(), "spacing 0.03 radius 0.15, 1.5")},
        Case{"Media",
             scene_of(glass("sphere { <0, 1.5, 0>, 0.5") +
                          "box { <-1.2, 0.01, -1>, <1.2, 0.95, 1> hollow pigment { rgbt 1 } "
                          "interior { media { scattering { 1, 0.5 } samples 5, 5 method 2 } } "
                          "photons { pass_through } }",
                      "spacing 0.03 media 20")}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test::photons
