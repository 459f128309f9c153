// Lights, atmosphere, settings and the scene level.
#include "parser/descriptions/texture.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

using core::Vec3;

const LightDesc& light_of(const SceneText& s, std::size_t i = 0) {
  return *s.shape<LightShape>(i).light;
}

TEST(UnitParserLight, Point) {
  const SceneText s("light_source { <1,2,3>, rgb <.5,.6,.7> fade_distance 3 fade_power 2 }");
  const LightDesc& l = light_of(s);
  EXPECT_EQ(l.position, Vec3(1, 2, 3));
  EXPECT_FLOAT_EQ(l.colour.rgb.g, 0.6f);
  EXPECT_EQ(l.fade_distance, 3.0);
  EXPECT_EQ(l.fade_power, 2.0);
}

TEST(UnitParserLight, SpotDefaultsAndWords) {
  const SceneText s(
      "light_source { 0, 1 spotlight } light_source { 0, 1 spotlight radius 10 falloff 20 "
      "tightness 5 "
      "point_at y } light_source { 0, 1 cylinder } light_source { 0, 1 parallel point_at x "
      "shadowless }");
  EXPECT_EQ(light_of(s, 0).radius, 30.0);
  EXPECT_EQ(light_of(s, 0).falloff, 45.0);
  EXPECT_EQ(light_of(s, 0).point_at, Vec3(0, 0, 1));
  EXPECT_EQ(light_of(s, 1).tightness, 5.0);
  EXPECT_EQ(light_of(s, 2).radius, 0.75);
  EXPECT_TRUE(light_of(s, 2).parallel);
  EXPECT_EQ(light_of(s, 3).kind, LightKind::kShadowless);
}

TEST(UnitParserLight, TransformsMoveWhatStandsBeforeThem) {
  const SceneText s(
      "light_source { x, 1 spotlight point_at 0 translate y point_at 5*z "
      "area_light x, y, 3, 3 scale 2 }");
  EXPECT_EQ(light_of(s).position, Vec3(2, 2, 0));
  EXPECT_EQ(light_of(s).point_at, Vec3(0, 0, 10));
  EXPECT_EQ(light_of(s).axis1, Vec3(2, 0, 0));
}

TEST(UnitParserLight, Area) {
  const SceneText s(
      "light_source { 0, 1 area_light x, y, 4, 5 adaptive 2 jitter circular orient }");
  const LightDesc& l = light_of(s);
  EXPECT_TRUE(l.has_area && l.has_adaptive && l.jitter && l.circular && l.orient);
  EXPECT_EQ(l.size2, 5);
  EXPECT_EQ(l.adaptive, 2);
}

TEST(UnitParserLight, LooksLikeMovesToTheLight) {
  const SceneText s("light_source { <1,2,3>, 1 looks_like { sphere { 0, 1 } } translate x }");
  expect_near(light_of(s).looks_like->transform->point({}), {2, 2, 3});
  EXPECT_TRUE(light_of(s).looks_like->no_shadow);
}

TEST(UnitParserLight, FadePowerWithoutDistanceIsIgnored) {
  const SceneText s("light_source { 0, 1 fade_power 2 }");
  EXPECT_EQ(light_of(s).fade_power, 0.0);
}

TEST(UnitParserLight, Group) {
  const SceneText s(
      "light_group { light_source { 0, 1 } sphere { 0, 1 } global_lights on translate x }");
  EXPECT_EQ(s.shape<CsgShape>().operation, CsgOperation::kLightGroup);
  EXPECT_TRUE(s.shape<CsgShape>().global_lights);
}

TEST(UnitParserScene, Settings) {
  const SceneText s(
      "#version 3.7; global_settings { assumed_gamma 2.2 max_trace_level 12 adc_bailout .01 "
      "ambient_light rgb <.1,.2,.3> noise_generator 1 number_of_waves 5 charset utf8 mm_per_unit 2 "
      "irid_wavelength rgb <.7,.5,.4> max_intersections 64 "
      "radiosity { count 50, 2000 pretrace_start .1 recursion_limit 1 always_sample off normal on "
      "} "
      "photons { spacing .01 gather 20, 80 radius .1, 2 media 100, 2 } "
      "subsurface { samples 10, 20 } }");
  const GlobalDesc& g = s.scene.global;
  EXPECT_EQ(g.assumed_gamma, 2.2);
  EXPECT_EQ(g.max_trace_level, 12);
  EXPECT_EQ(g.adc_bailout, 0.01);
  EXPECT_FLOAT_EQ(g.ambient_light->b, 0.3f);
  EXPECT_EQ(g.radiosity->count, 50);
  EXPECT_EQ(g.radiosity->direction_pool, 2000);
  EXPECT_TRUE(g.radiosity->normal);
  EXPECT_EQ(g.photons->gather_max, 80);
  EXPECT_EQ(g.photons->media_factor, 2.0);
  EXPECT_EQ(g.subsurface->samples_single, 20);
}

TEST(UnitParserScene, TraceLevelIsClamped) {
  EXPECT_EQ(SceneText("global_settings { max_trace_level 0 }").scene.global.max_trace_level, 1);
  EXPECT_EQ(SceneText("global_settings { max_trace_level 999 }").scene.global.max_trace_level, 256);
}

TEST(UnitParserScene, Atmosphere) {
  const SceneText s(
      "#declare F = fog { distance 10 color rgb .5 }"
      "fog { F fog_type 2 fog_alt 1 fog_offset 2 turbulence .3 }"
      "rainbow { direction z angle 42 width 5 distance 1e6 color_map { [0 color rgb 0] [1 color "
      "rgb 1] } }"
      "sky_sphere { pigment { rgb x } pigment { rgb y } scale 2 emission rgb .5 }"
      "background { color rgb <1, .5, 0> }");
  EXPECT_EQ(s.scene.fogs.at(0).distance, 10.0);
  EXPECT_EQ(s.scene.fogs.at(0).type, 2);
  EXPECT_EQ(s.scene.fogs.at(0).turbulence, Vec3(0.3, 0.3, 0.3));
  EXPECT_EQ(s.scene.rainbows.at(0).angle, 42.0);
  EXPECT_EQ(s.scene.sky_sphere->pigments.size(), 2u);
  EXPECT_FLOAT_EQ(s.scene.background.rgb.g, 0.5f);
}

TEST(UnitParserScene, EveryKindCanBeDeclared) {
  const SceneText s(
      "#declare A = camera { } #declare B = fog { distance 1 } #declare C = rainbow { direction z "
      "angle 1 width 1 }"
      "#declare D = sky_sphere { pigment { rgb 1 } } #declare E = light_source { 0, 1 }"
      "#declare F = pigment { rgb 1 } #declare G = texture { F } #declare H = finish { ambient 1 }"
      "#declare I = interior { ior 1.5 } #declare J = material { texture { G } interior { I } }"
      "camera { A } fog { B } rainbow { C } sky_sphere { D } light_source { E }"
      "sphere { 0, 1 material { J } }");
  EXPECT_EQ(s.scene.objects.size(), 2u);
  EXPECT_TRUE(s.object(1).rare->interior);
}

TEST(ErrorParserScene, UnknownStatement) {
  const std::string m = failure("banana { }");
  EXPECT_NE(m.find("expected an object or a statement"), std::string::npos) << m;
  EXPECT_NE(m.find("global_settings"), std::string::npos) << m;
}
TEST(ErrorParserScene, UnknownSetting) {
  EXPECT_NE(failure("global_settings { banana 1 }").find("expected one of adc_bailout"),
            std::string::npos);
}
TEST(ErrorParserScene, UnknownDefault) {
  EXPECT_NE(
      failure("#default { sphere { 0, 1 } }").find("texture, pigment, normal, finish, camera"),
      std::string::npos);
}
TEST(ErrorParserScene, GammaZero) {
  EXPECT_EQ(failure("#version 3.7; global_settings { assumed_gamma 0 }"),
            "assumed_gamma must be greater than 0.");
}
TEST(ErrorParserScene, NoiseGenerator) {
  EXPECT_EQ(failure("global_settings { noise_generator 7 }"), "noise_generator must be 1, 2 or 3.");
}
TEST(ErrorParserScene, UnknownFogWord) {
  EXPECT_NE(failure("fog { banana }").find("expected one of fog_type"), std::string::npos);
}
TEST(ErrorParserScene, UnknownRainbowWord) {
  EXPECT_NE(failure("rainbow { banana }").find("expected one of direction"), std::string::npos);
}
TEST(ErrorParserScene, UnknownSkyWord) {
  EXPECT_NE(failure("sky_sphere { banana }").find("pigment, emission"), std::string::npos);
}
TEST(ErrorParserLight, UnknownWord) {
  EXPECT_NE(failure("light_source { 0, 1 banana }").find("spotlight"), std::string::npos);
}
TEST(ErrorParserLight, PointAtOfAPointLight) {
  EXPECT_NE(failure("light_source { 0, 1 point_at x }").find("point_at needs spotlight"),
            std::string::npos);
}
TEST(ErrorParserLight, RadiusOfAPointLight) {
  EXPECT_NE(failure("light_source { 0, 1 radius 3 }").find("radius needs spotlight"),
            std::string::npos);
}
TEST(ErrorParserLight, EmptyArea) {
  EXPECT_EQ(failure("light_source { 0, 1 area_light x, y, 0, 3 }"),
            "The numbers of lights of an area_light must be greater than zero.");
}
TEST(ErrorParserLight, CircularNeedsTwo) {
  EXPECT_EQ(failure("light_source { 0, 1 area_light x, y, 1, 3 circular }"),
            "A circular area_light must have more than one light along each axis.");
}
TEST(ErrorParserLight, TwoLooksLike) {
  EXPECT_EQ(
      failure(
          "light_source { 0, 1 looks_like { sphere { 0, 1 } } looks_like { sphere { 0, 1 } } }"),
      "Only one looks_like allowed per light_source.");
}

}  // namespace
}  // namespace lentray::parser::test
