// Textures, finishes and interiors: what the text says, and what the kernel gets of it.
#include <cmath>

#include "core/material/texture.h"
#include "parser/compile/finish.h"
#include "tests/unit/material/material_reading.h"

namespace lentray::parser::test {
namespace {

core::Finish finish_of(const std::string& text) {
  return compile_finish(LooksText("pigment { rgb 1 } finish { " + text + " }").finish());
}

core::WeightedTextures resolved(const LooksText& text, const core::Vec3& point,
                                std::shared_ptr<const core::Texture>& keep) {
  keep = TextureCompiler(TextureSettings{}).texture(text.object().texture, nullptr);
  core::WeightedTextures out;
  keep->resolve(point, core::kNoSurface, 1.0, out);
  return out;
}

float red(const core::WeightedTexture& texture) {
  return texture.texture->layers().back().pigment->colour(texture.point).rgb.r;
}

TEST(UnitMaterialFinish, Defaults) {
  const core::Finish f = finish_of("");
  EXPECT_FLOAT_EQ(f.ambient.g, .1f);
  EXPECT_NEAR(f.diffuse, .6, 1e-7);
  EXPECT_EQ(f.phong_size, 40.0);
  EXPECT_NEAR(f.roughness_exponent, 20.0, 1e-5);
  EXPECT_FALSE(f.reflection_variable);
}

TEST(UnitMaterialFinish, AlbedoScalesByTheExponents) {
  EXPECT_NEAR(finish_of("diffuse albedo .8 brilliance 3").diffuse, 1.6, 1e-6);
  EXPECT_NEAR(finish_of("phong albedo .5 phong_size 9").phong, 2.5, 1e-6);
  const double n = 100.0;
  EXPECT_NEAR(finish_of("specular albedo .2 roughness .01").specular,
              .2 * (n + 2) / (4 * (2 - std::pow(2, -n / 2))), 1e-5);
}

TEST(UnitMaterialFinish, DiffuseHasABackSide) {
  EXPECT_NEAR(finish_of("diffuse .7, .2").diffuse_back, .2, 1e-7);
}

TEST(UnitMaterialFinish, ReflectionOldAndNew) {
  const core::Finish old = finish_of("reflection .3");
  EXPECT_FLOAT_EQ(old.reflection_min.r, .3f);
  EXPECT_FLOAT_EQ(old.reflection_max.b, .3f);
  EXPECT_FALSE(old.reflection_variable);
  const core::Finish block =
      finish_of("reflection { .1, rgb <.5,.6,.7> falloff 2 exponent .5 metallic }");
  EXPECT_TRUE(block.reflection_variable);
  EXPECT_FLOAT_EQ(block.reflection_min.g, .1f);
  EXPECT_FLOAT_EQ(block.reflection_max.g, .6f);
  EXPECT_EQ(block.reflection_falloff, 2.0);
  EXPECT_EQ(block.reflection_exponent, .5);
  EXPECT_EQ(block.reflection_metallic, 1.0);
}

TEST(UnitMaterialFinish, FresnelWithOneColourStartsFromNothing) {
  const core::Finish f = finish_of("reflection { 1 fresnel on }");
  EXPECT_TRUE(f.reflection_fresnel);
  EXPECT_TRUE(f.reflection_min.is_black());
  EXPECT_FLOAT_EQ(f.reflection_max.r, 1.0f);
}

TEST(UnitMaterialFinish, MetallicWithAndWithoutANumber) {
  EXPECT_EQ(finish_of("metallic").metallic, 1.0);
  EXPECT_NEAR(finish_of("metallic .3").metallic, .3, 1e-7);
}

TEST(UnitMaterialFinish, AmbientIsAColour) {
  EXPECT_FLOAT_EQ(finish_of("ambient rgb <.1,.2,.3>").ambient.b, .3f);
  EXPECT_FLOAT_EQ(finish_of("ambient .4").ambient.b, .4f);
}

TEST(UnitMaterialTexture, DefaultsAreTakenFromDefault) {
  const LooksText text("texture { pigment { rgb 1 } }",
                       "#default { finish { ambient .7 } } #default { pigment { rgb .3 } }");
  EXPECT_FLOAT_EQ(text.finish().ambient.r, .7f);
  EXPECT_FLOAT_EQ(text.pigment().colour.rgb.r, 1.0f);
}

TEST(UnitMaterialTexture, PartsInAnObjectChangeItsTexture) {
  const LooksText text("pigment { rgb <1,0,0> } finish { phong 1 } pigment { rgb <0,1,0> }");
  EXPECT_EQ(text.texture().layers.size(), 1u);
  EXPECT_FLOAT_EQ(text.pigment().colour.rgb.g, 1.0f);
  EXPECT_EQ(text.finish().phong, 1.0);
}

TEST(UnitMaterialTexture, LayersKeepTheirOrder) {
  const LooksText text("texture { pigment { rgb .1 } } texture { pigment { rgb .2 } }");
  ASSERT_EQ(text.texture().layers.size(), 2u);
  EXPECT_FLOAT_EQ(text.texture().layers[0].pigment->colour.rgb.r, .1f);
  EXPECT_FLOAT_EQ(text.pigment().colour.rgb.r, .2f);
}

TEST(UnitMaterialTexture, DeclaredLayersStayTogether) {
  const LooksText text(
      "texture { T scale 2 }",
      "#declare T = texture { pigment { rgb .1 } } texture { pigment { rgb .2 } }");
  EXPECT_EQ(text.texture().layers.size(), 2u);
}

TEST(UnitMaterialTexture, BeforeThreeOneLayersLetLightThroughUntinted) {
  const LooksText text("texture { pigment { rgb 1 } } texture { pigment { rgbf <1,1,1,.5> } }",
                       "#version 3.1;");
  EXPECT_FLOAT_EQ(text.pigment().colour.filter, 0.0f);
  EXPECT_FLOAT_EQ(text.pigment().colour.transmit, .5f);
}

TEST(UnitMaterialTexture, NamesStandForStatements) {
  const LooksText text("texture { P F }",
                       "#declare P = pigment { rgb .4 } #declare F = finish { diffuse .9 }");
  EXPECT_FLOAT_EQ(text.pigment().colour.rgb.r, .4f);
  EXPECT_EQ(text.finish().diffuse, .9);
}

TEST(UnitMaterialTexture, MapsBlendByWeight) {
  const LooksText text(
      "texture { gradient x texture_map { [0 pigment { rgb 0 }] [1 pigment { rgb 1 }] } }");
  std::shared_ptr<const core::Texture> keep;
  const auto two = resolved(text, {.25, 0, 0}, keep);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_NEAR(two[0].weight, .75, 1e-6);
  EXPECT_NEAR(two[1].weight, .25, 1e-6);
  EXPECT_FLOAT_EQ(red(two[1]), 1.0f);
}

TEST(UnitMaterialTexture, CheckerOfTextures) {
  const LooksText text(
      "texture { checker texture { pigment { rgb .2 } } texture { pigment { rgb .8 } } }");
  std::shared_ptr<const core::Texture> keep;
  const auto one = resolved(text, {1.5, .5, .5}, keep);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_FLOAT_EQ(red(one[0]), .8f);
  EXPECT_TRUE(keep->is_opaque());
}

TEST(UnitMaterialTexture, EntriesLieInThePatternsSpace) {
  const LooksText text(
      "texture { checker texture { pigment { gradient x } } texture { pigment { rgb 1 } }"
      " scale 4 }");
  std::shared_ptr<const core::Texture> keep;
  const auto one = resolved(text, {1, 1, 1}, keep);
  EXPECT_NEAR(red(one[0]), .25, 1e-6);
}

TEST(UnitMaterialTexture, TilesBeginWithTheirSecond) {
  const LooksText text(
      "texture { tiles { texture { pigment { rgb .1 } } tile2 texture { pigment { rgb .9 } } } }");
  std::shared_ptr<const core::Texture> keep;
  EXPECT_FLOAT_EQ(red(resolved(text, {.5, .5, .5}, keep)[0]), .9f);
}

TEST(UnitMaterialTexture, OldTexturesNeedNoInnerStatements) {
  const LooksText text("texture { color red 1 phong .5 ambient .3 ripples .4 frequency 2 }",
                       "#version 1.0;");
  EXPECT_FLOAT_EQ(text.pigment().colour.rgb.r, 1.0f);
  EXPECT_EQ(text.finish().phong, .5);
  EXPECT_FLOAT_EQ(text.finish().ambient.r, .3f);
  EXPECT_EQ(text.normal().pattern.kind, PatternKind::kRipples);
  EXPECT_EQ(text.normal().pattern.frequency, 2.0);
}

TEST(UnitMaterialTexture, TurbulenceOutsideWarpsIsNearestThePattern) {
  const LooksText text("pigment { bozo scale 2 turbulence .5 rotate 10 octaves 3 }");
  const auto& placement = text.pattern().placement;
  ASSERT_EQ(placement.size(), 2u);
  EXPECT_EQ(placement[0].kind, WarpDesc::Kind::kClassicTurbulence);
  EXPECT_EQ(placement[0].own->turbulence.octaves, 3);
}

TEST(UnitMaterialTexture, MaterialBringsTextureAndInterior) {
  const LooksText text("material { M }",
                       "#declare M = material { texture { pigment { rgb 1 } }"
                       " interior { ior 1.5 fade_distance 2 } }");
  ASSERT_TRUE(text.object().interior);
  EXPECT_EQ(text.object().interior->ior, 1.5);
  EXPECT_EQ(text.object().interior->fade_distance, 2.0);
}

TEST(UnitMaterialInterior, IorOfAnOldFinishWins) {
  const LooksText text("pigment { rgb 1 } finish { ior 1.7 } interior { ior 1.2 }");
  const auto interior = compile_interior(text.object().interior, text.object().texture);
  EXPECT_NEAR(interior->ior, 1.7, 1e-6);
}

TEST(UnitMaterialInterior, MediaAreCompiledFromQualityNineOn) {
  const LooksText text(
      "interior { media { emission .1 scattering { 5, 2 eccentricity .3 extinction .5 }"
      " density { spherical color_map { [0 rgb 0] [1 rgb 1] } } density { rgb 3 } } }");
  TextureSettings simple_settings;
  simple_settings.quality = 8;
  TextureCompiler best(TextureSettings{}), simple(simple_settings);
  EXPECT_TRUE(simple.interior(text.object().interior)->media.empty());
  const auto media = best.interior(text.object().interior)->media;
  ASSERT_EQ(media.size(), 1u);
  EXPECT_EQ(media.front()->extinction(), core::Rgb(1.0f));
  EXPECT_EQ(media.front()->phase.kind, core::PhaseFunction::Kind::kHenyeyGreenstein);
  EXPECT_EQ(media.front()->density({0.5, 0, 0}), core::Rgb(1.5f));
  EXPECT_TRUE(best.not_yet().empty());
}

TEST(UnitMaterialInterior, SettingsOfMediaMayBeGivenInstead) {
  const LooksText text("interior { media { method 1 intervals 4 samples 2,9 confidence .5 } }");
  const auto own = TextureCompiler({}).interior(text.object().interior)->media.front();
  EXPECT_EQ(own->sampling.min_samples, 2);
  EXPECT_EQ(own->sampling.max_samples, 9);
  EXPECT_EQ(own->variance_limits.size(), 9u);
  TextureSettings settings;
  settings.media = {.method = 2, .intervals = 3, .samples = 5, .confidence = 0.25};
  const auto other = TextureCompiler(settings).interior(text.object().interior)->media.front();
  EXPECT_EQ(other->sampling.method, core::SamplingMethod::kEven);
  EXPECT_EQ(other->sampling.intervals, 3);
  EXPECT_EQ(other->sampling.min_samples, 5);
  EXPECT_EQ(other->sampling.max_samples, 5);
  EXPECT_EQ(other->sampling.confidence, 0.25);
}

}  // namespace
}  // namespace lentray::parser::test
