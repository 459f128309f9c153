// Descriptions -> the kernel's objects: bounds, inheritance of looks, switches, lights.
#include <cmath>

#include "core/object/csg.h"
#include "core/object/gated.h"
#include "core/object/leaf.h"
#include "core/shape/mesh.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

using core::Vec3;

const core::Csg& csg(const core::Object& object) { return dynamic_cast<const core::Csg&>(object); }

core::Colour colour_at(const core::Object& object, const Vec3& p) {
  core::WeightedTextures found;
  object.attributes().texture->resolve(p, core::kNoSurface, 1.0, found);
  return found[0].texture->layers().at(0).pigment->colour(p);
}

TEST(UnitBuildObjects, BoundsFollowTransforms) {
  SceneText s("sphere { 0, 1 scale <1,2,3> translate x*10 } box { -1, 1 rotate y*45 }");
  const core::SceneParts parts = s.build();
  ASSERT_EQ(parts.objects.size(), 2u);
  const core::Bounds b = parts.objects[0]->bounds();
  expect_near(b.lo, {9, -2, -3}, 1e-6);
  expect_near(b.hi, {11, 2, 3}, 1e-6);
  EXPECT_NEAR(parts.objects[1]->bounds().hi.x, std::sqrt(2.0), 1e-6);
}

TEST(UnitBuildObjects, CsgTransformsReachTheParts) {
  SceneText s("difference { box { -1, 1 translate x } sphere { 0, 1 } scale 2 translate y }");
  const core::SceneParts parts = s.build();
  EXPECT_TRUE(parts.objects[0]->inside({3.5, 1, 0}));
  EXPECT_FALSE(parts.objects[0]->inside({1.5, 1, 0}));  // cut away
}

TEST(UnitBuildObjects, TexturesAreInherited) {
  SceneText s(
      "#default { pigment { rgb <.2,0,0> } }"
      "union { sphere { 0, 1 pigment { rgb <0,1,0> } } sphere { 3, 1 } "
      "  union { box { 0, 1 } box { 4, 5 pigment { rgb <0,0,1> } } } pigment { rgb <1,0,0> } }"
      "sphere { 0, 1 }");
  const core::SceneParts parts = s.build();
  const auto& children = csg(*parts.objects.at(0)).children();
  EXPECT_FLOAT_EQ(colour_at(*children.at(0), {}).rgb.g, 1.0f);
  EXPECT_FLOAT_EQ(colour_at(*children.at(1), {}).rgb.r, 1.0f);
  const auto& inner = csg(*children.at(2)).children();
  EXPECT_FLOAT_EQ(colour_at(*inner.at(0), {}).rgb.r, 1.0f);
  EXPECT_FLOAT_EQ(colour_at(*inner.at(1), {}).rgb.b, 1.0f);
  EXPECT_FLOAT_EQ(colour_at(*parts.objects.at(1), {}).rgb.r, 0.2f);
}

TEST(UnitBuildObjects, DefaultTextureOfTheEndOfTheStatement) {
  SceneText s("sphere { 0, 1 } #default { pigment { rgb <0,1,0> } } sphere { 0, 1 }");
  const core::SceneParts parts = s.build();
  EXPECT_FLOAT_EQ(colour_at(*parts.objects[0], {}).rgb.g, 0.0f);
  EXPECT_FLOAT_EQ(colour_at(*parts.objects[1], {}).rgb.g, 1.0f);
}

/// A texture moves with the transforms after it, its own and those of the CSG around it.
TEST(UnitBuildObjects, TexturesMoveWithTheObject) {
  SceneText s(
      "#declare P = pigment { checker rgb <1,0,0>, rgb <0,1,0> }"
      "sphere { 0, 9 pigment { P } translate x }"
      "sphere { 0, 9 translate x pigment { P } }"
      "union { sphere { 0, 9 pigment { P } } translate x }"
      "union { sphere { 0, 9 } pigment { P } translate x }"
      "union { sphere { 0, 9 } translate x pigment { P } }");
  const core::SceneParts parts = s.build();
  const Vec3 p{0.5, 0.5, 0.5};
  const auto red = [&](const core::Object& o) { return colour_at(o, p).rgb.r; };
  const float moved = red(*parts.objects[0]), still = red(*parts.objects[1]);
  EXPECT_NE(moved, still);
  EXPECT_EQ(red(*csg(*parts.objects[2]).children()[0]), moved);
  EXPECT_EQ(red(*csg(*parts.objects[3]).children()[0]), moved);
  EXPECT_EQ(red(*csg(*parts.objects[4]).children()[0]), still);
}

TEST(UnitBuildObjects, SwitchesAreInherited) {
  SceneText s(
      "union { sphere { 0, 1 } sphere { 3, 1 hollow off double_illuminate off } "
      "no_shadow no_image hollow double_illuminate }");
  const core::SceneParts parts = s.build();
  const auto& children = csg(*parts.objects.at(0)).children();
  EXPECT_TRUE(children[0]->attributes().no_shadow && children[0]->attributes().no_image);
  EXPECT_FALSE(children[0]->attributes().no_reflection);
  EXPECT_FALSE(
      children[0]->attributes().hollow);  // the last part says it for the interior they share
  EXPECT_FALSE(children[1]->attributes().hollow);
  EXPECT_TRUE(children[1]->attributes().double_illuminate);  // the CSG overrides
}

const core::PassFlags& pass_flags(const core::SceneParts& parts, const core::Object& object) {
  return parts.pass_flags.at(object.attributes().pass_flags);
}

/// Equal pictures of stock's: a part's own importance holds for it, and no_radiosity of the whole.
TEST(UnitBuildObjects, RadiosityFlagsAreInherited) {
  SceneText s(
      "union { sphere { 0, 1 } sphere { 3, 1 radiosity { importance .2 } } "
      "radiosity { importance .5 } no_radiosity }"
      "sphere { 0, 1 no_radiosity off } "
      "#default { radiosity { importance .3 } } union { sphere { 0, 1 } sphere { 0, 2 } }"
      "sphere { 0, 1 radiosity { importance 1 } }");
  const core::SceneParts parts = s.build();
  const auto& children = csg(*parts.objects.at(0)).children();
  EXPECT_EQ(pass_flags(parts, *parts.objects[0]).importance, 0.5);
  EXPECT_EQ(pass_flags(parts, *children[0]).importance, 0.5);
  EXPECT_EQ(pass_flags(parts, *children[1]).importance, 0.2);
  EXPECT_TRUE(children[0]->attributes().no_radiosity && children[1]->attributes().no_radiosity);
  EXPECT_FALSE(parts.objects[1]->attributes().no_radiosity);
  EXPECT_EQ(parts.objects[1]->attributes().pass_flags, 0u);
  EXPECT_EQ(pass_flags(parts, *csg(*parts.objects[2]).children()[0]).importance, 0.3);
  EXPECT_EQ(pass_flags(parts, *parts.objects[3]).importance, 1.0);
  EXPECT_EQ(parts.pass_flags.size(), 4u);  // equal ones are one
}

/// Likewise: of photons the whole says first whether it is a target, reflects and refracts; what
/// does not collect in a part or in the whole does not.
TEST(UnitBuildObjects, PhotonFlagsAreInherited) {
  SceneText s(
      "merge { sphere { 0, 1 } sphere { 3, 1 photons { target 2 refraction off reflection on "
      "collect off pass_through } } photons { target .5 refraction on } }"
      "merge { sphere { 0, 1 photons { target 3 } } box { 0, 1 photons { collect on } } "
      "photons { target 0 collect off pass_through } }"
      "sphere { 0, 1 photons { pass_through reflection off } }");
  const core::SceneParts parts = s.build();
  const auto& first = csg(*parts.objects.at(0)).children();
  core::PassFlags whole;
  whole.photon_target = 0.5;
  whole.photon_refraction = true;
  whole.photon_target_number = 1;
  EXPECT_EQ(pass_flags(parts, *parts.objects[0]), whole);
  EXPECT_EQ(pass_flags(parts, *first[0]), whole);
  whole.photon_reflection = true;
  whole.photon_collect = false;
  EXPECT_EQ(pass_flags(parts, *first[1]), whole);
  const auto& second = csg(*parts.objects.at(1)).children();
  EXPECT_EQ(pass_flags(parts, *parts.objects[1]).photon_target, 0.0);
  EXPECT_EQ(pass_flags(parts, *second[0]).photon_target, 3.0);
  EXPECT_FALSE(pass_flags(parts, *second[1]).photon_collect);
  EXPECT_TRUE(pass_flags(parts, *second[1]).photon_pass_through);
  core::PassFlags passed;
  passed.photon_pass_through = true;
  passed.photon_reflection = false;
  EXPECT_EQ(pass_flags(parts, *parts.objects[2]), passed);
}

TEST(UnitBuildObjects, InteriorsAreSharedThroughCsgAndOwnElsewhere) {
  SceneText s(
      "#declare I = interior { ior 1.5 }"
      "union { sphere { 0, 1 } sphere { 3, 1 interior { ior 1.3 } } interior { I } }"
      "sphere { 9, 1 interior { I } } sphere { 20, 1 }");
  const core::SceneParts parts = s.build();
  const auto& children = csg(*parts.objects.at(0)).children();
  EXPECT_EQ(children[0]->attributes().interior, parts.objects[0]->attributes().interior);
  EXPECT_DOUBLE_EQ(children[0]->attributes().interior->ior, 1.5);
  EXPECT_DOUBLE_EQ(children[1]->attributes().interior->ior, double{1.3f});  // stock keeps singles
  EXPECT_NE(parts.objects[1]->attributes().interior, parts.objects[0]->attributes().interior);
  EXPECT_EQ(parts.objects[2]->attributes().interior, nullptr);
}

TEST(UnitBuildObjects, InteriorTexture) {
  SceneText s(
      "sphere { 0, 1 pigment { rgb 1 } interior_texture { pigment { rgb 0 } } } sphere { 0, 1 }");
  const core::SceneParts parts = s.build();
  EXPECT_NE(parts.objects[0]->attributes().interior_texture, nullptr);
  EXPECT_EQ(parts.objects[1]->attributes().interior_texture, nullptr);
}

TEST(UnitBuildObjects, Inverse) {
  SceneText s("sphere { 0, 1 inverse } union { sphere { 0, 1 } box { 2, 3 } inverse }");
  const core::SceneParts parts = s.build();
  EXPECT_FALSE(parts.objects[0]->inside({0, 0, 0}));
  EXPECT_TRUE(parts.objects[0]->inside({5, 0, 0}));
  EXPECT_FALSE(parts.objects[1]->inside({2.5, 2.5, 2.5}));
  EXPECT_TRUE(parts.objects[1]->inside({1.5, 1.5, 1.5}));
}

TEST(UnitBuildObjects, ClipsMoveWithTheObject) {
  SceneText s(
      "sphere { 0, 1 clipped_by { plane { y, 0 } } rotate z*180 translate x*5 }"
      "union { sphere { 0, 1 clipped_by { box { 0, 2 } } } translate x*5 }");
  const core::SceneParts parts = s.build();
  EXPECT_TRUE(parts.objects[0]->inside({5, 0.5, 0}));
  EXPECT_FALSE(parts.objects[0]->inside({5, -0.5, 0}));
  const auto& child = *csg(*parts.objects[1]).children()[0];
  EXPECT_TRUE(child.inside({5.3, 0.3, 0.3}));
  EXPECT_FALSE(child.inside({4.7, 0.3, 0.3}));
}

/// Stock drops bounds of cheap objects in the scene's list but for their box; of CSG it keeps them.
TEST(UnitBuildObjects, BoundsOfCheapObjectsBecomeBoxes) {
  SceneText s(
      "sphere { 0, 1 bounded_by { sphere { 0, 2 } } }"
      "sphere { 0, 1 bounded_by { sphere { 0, .5 } } translate x }"
      "difference { sphere { 0, 1 } box { 0, 1 } bounded_by { sphere { 0, 2 } } }");
  const core::SceneParts parts = s.build();
  const auto gates_of = [](const core::Object& object) {
    const auto* gated = dynamic_cast<const core::Gated*>(&object);
    return gated ? gated->gates() : core::Object::Regions();
  };
  EXPECT_TRUE(gates_of(*parts.objects[0]).empty());
  ASSERT_EQ(gates_of(*parts.objects[1]).size(), 1u);
  EXPECT_EQ(gates_of(*parts.objects[1])[0]->name(), "box");
  expect_near(gates_of(*parts.objects[1])[0]->bounds().hi, {1.5, 0.5, 0.5}, 1e-6);
  ASSERT_EQ(gates_of(*parts.objects[2]).size(), 1u);
  EXPECT_EQ(gates_of(*parts.objects[2])[0]->name(), "sphere");
}

TEST(UnitBuildObjects, MeshTextures) {
  SceneText s(
      "mesh2 { vertex_vectors { 3, 0, x, y } texture_list { 1, texture { pigment { rgb 1 } } }"
      " face_indices { 1, <0,1,2>, 0 } translate z }");
  const core::SceneParts parts = s.build();
  const auto& leaf = dynamic_cast<const core::Leaf&>(*parts.objects.at(0));
  EXPECT_EQ(leaf.name(), "mesh2");
  EXPECT_TRUE(dynamic_cast<const core::Mesh&>(leaf.shape()).has_textures());
  EXPECT_NEAR(leaf.bounds().lo.z, 1.0, 1e-6);
}

TEST(UnitBuildObjects, Lights) {
  SceneText s(
      "union { light_source { x, rgb <1,2,3> spotlight point_at 0 radius 10 falloff 20 } "
      "  sphere { 0, 1 } translate y*2 }"
      "light_source { 0, 1 area_light x, y, 3, 4 rotate z*90 shadowless }"
      "light_source { 0, 1 area_light x, y, 3, 4 adaptive 1 }");
  const core::SceneParts parts = s.build();
  ASSERT_EQ(parts.lights.size(), 3u);
  EXPECT_EQ(parts.objects.size(), 1u);
  const core::Light& spot = parts.lights[0];
  EXPECT_EQ(spot.kind, core::Light::Kind::kSpot);
  expect_near(spot.position, {1, 2, 0});
  expect_near(spot.direction, {-1, 0, 0});
  EXPECT_NEAR(spot.radius, std::cos(M_PI / 18.0), 1e-15);
  EXPECT_NEAR(spot.falloff, std::cos(M_PI / 9.0), 1e-15);
  EXPECT_FLOAT_EQ(spot.colour.b, 3.0f);
  EXPECT_TRUE(parts.lights[1].shadowless);
  expect_near(parts.lights[1].area.axis1, {0, 1, 0});
  EXPECT_EQ(parts.lights[1].area.adaptive, -1);
  EXPECT_EQ(parts.lights[2].area.adaptive, 1);
}

TEST(UnitBuildObjects, LooksLikeIsAnObjectWithoutShadow) {
  SceneText s(
      "light_source { <1,2,3>, 1 looks_like { sphere { 0, 1 } } }"
      "union { light_source { 0, 1 looks_like { sphere { 0, 1 } } } translate x*7 }");
  const core::SceneParts parts = s.build();
  ASSERT_EQ(parts.objects.size(), 2u);
  EXPECT_TRUE(parts.objects[0]->attributes().no_shadow);
  EXPECT_NE(parts.objects[0]->attributes().texture, nullptr);
  EXPECT_TRUE(parts.objects[0]->inside({1, 2, 3.5}));
  EXPECT_TRUE(parts.objects[1]->inside({7, 0, 0}));
}

TEST(UnitBuildScene, GlobalLightIsRendered) {
  SceneText s(
      "sphere { 0, 1 finish { subsurface { translucency 1 } } }"
      "global_settings { subsurface { } radiosity { } photons { count 100 } }");
  s.build();
  EXPECT_TRUE(s.report.not_rendered.empty());
}

/// What stock writes for rgb 0.5 tells its working gamma: 128 without, 188 with assumed_gamma 1.
TEST(UnitBuildScene, AssumedGammaByVersion) {
  const auto settings = [](const std::string& text) { return SceneText(text).build().settings; };
  EXPECT_EQ(settings("#version 3.7;").assumed_gamma, 1.0);
  EXPECT_FALSE(settings("#version 3.7;").assumed_gamma_set);
  EXPECT_EQ(settings("#version 3.6;").assumed_gamma, 0.0);
  EXPECT_EQ(settings("// no #version\n").assumed_gamma, 0.0);
  EXPECT_EQ(settings("#version 3.6; global_settings { assumed_gamma 1 }").assumed_gamma, 1.0);
  EXPECT_EQ(settings("#version 3.7; global_settings { assumed_gamma 2.2 }").assumed_gamma, 2.2);
  EXPECT_EQ(settings("#version 3.7; global_settings { assumed_gamma srgb }").assumed_gamma, 0.0);
}

TEST(UnitBuildScene, SettingsAndSky) {
  SceneText s(
      "global_settings { max_trace_level 9 adc_bailout .25 ambient_light rgb 2 }"
      "background { rgbt <1,1,1,.5> } sky_sphere { pigment { rgb x } emission .5 }");
  const core::SceneParts parts = s.build();
  EXPECT_EQ(parts.settings.max_trace_level, 9);
  EXPECT_EQ(parts.settings.adc_bailout, 0.25);
  EXPECT_FLOAT_EQ(parts.settings.ambient_light.r, 2.0f);
  EXPECT_FLOAT_EQ(parts.settings.background.rgb.r, 0.5f);
  ASSERT_TRUE(parts.sky_sphere);
  EXPECT_FLOAT_EQ(parts.sky_sphere->pigments.at(0)->colour({0, 1, 0}).rgb.r, 1.0f);
  EXPECT_FLOAT_EQ(parts.sky_sphere->emission.g, 0.5f);
}

}  // namespace
}  // namespace lentray::parser::test
