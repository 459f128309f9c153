// Pigments, from text to colours, against values that follow from the manual's definitions.
#include <cmath>
#include <random>

#include "core/material/pigments.h"
#include "core/pattern/pattern.h"
#include "tests/unit/material/material_reading.h"

namespace lentray::parser::test {
namespace {

using core::Vec3;

TEST(UnitMaterialPigment, PlainColourIsConstantAndOpaque) {
  const LooksText text("pigment { rgb <.1, .2, .3> }");
  const auto pigment = compiled(text.pigment());
  ASSERT_NE(pigment->constant(), nullptr);
  expect_rgb(pigment->constant()->rgb, .1, .2, .3);
  EXPECT_TRUE(pigment->is_opaque());
}

TEST(UnitMaterialPigment, FilterAndTransmitMakeItTransparent) {
  const LooksText text("pigment { rgbft <.1, .2, .3, .4, .5> }");
  const auto pigment = compiled(text.pigment());
  EXPECT_FLOAT_EQ(pigment->constant()->filter, .4f);
  EXPECT_FLOAT_EQ(pigment->constant()->transmit, .5f);
  EXPECT_FALSE(pigment->is_opaque());
}

TEST(UnitMaterialPigment, TransparencyHiddenInAMapCounts) {
  const LooksText text(
      "pigment { gradient x color_map { [0 rgb 1] [.5 rgbt <1,1,1,.1>] [1 rgb 1] } }");
  EXPECT_FALSE(compiled(text.pigment())->is_opaque());
}

TEST(UnitMaterialPigment, CheckerAlternatesInAllDirections) {
  const std::string checker = "checker rgb <1,0,0>, rgb <0,0,1>";
  expect_rgb(colour_at(checker, {.5, .5, .5}).rgb, 1, 0, 0);
  expect_rgb(colour_at(checker, {1.5, .5, .5}).rgb, 0, 0, 1);
  expect_rgb(colour_at(checker, {1.5, -.5, .5}).rgb, 1, 0, 0);
  expect_rgb(colour_at(checker, {-.5, .5, .5}).rgb, 0, 0, 1);
}

TEST(UnitMaterialPigment, CheckerDefaultsToBlueAndGreen) {
  expect_rgb(colour_at("checker", {.5, .5, .5}).rgb, 0, 0, 1);
  expect_rgb(colour_at("checker", {1.5, .5, .5}).rgb, 0, 1, 0);
}

TEST(UnitMaterialPigment, HexagonHasThreeColoursAroundACorner) {
  const std::string hexagon = "hexagon rgb 0, rgb .5, rgb 1";
  // Hexagons of side 1 with centres at the origin and sqrt(3) along z.
  EXPECT_FLOAT_EQ(colour_at(hexagon, {0, 0, .1}).rgb.r, 0.0f);
  EXPECT_FLOAT_EQ(colour_at(hexagon, {0, 0, std::sqrt(3.0)}).rgb.r, 0.5f);
  EXPECT_FLOAT_EQ(colour_at(hexagon, {1.5, 0, std::sqrt(3.0) / 2}).rgb.r, 1.0f);
}

TEST(UnitMaterialPigment, BrickHasMortarOfItsWidth) {
  const std::string brick = "brick rgb 0, rgb 1 brick_size <8, 3, 4.5> mortar .5";
  // From -1/2 on lie mortar (.5) and brick; the middle of the first brick:
  EXPECT_FLOAT_EQ(colour_at(brick, {3, 1, 0}).rgb.r, 1.0f);
  EXPECT_FLOAT_EQ(colour_at(brick, {3, -.25, 0}).rgb.r, 0.0f);
  EXPECT_FLOAT_EQ(colour_at(brick, {3, 2.75, 0}).rgb.r, 0.0f);
  EXPECT_FLOAT_EQ(colour_at(brick, {3, 2.45, 0}).rgb.r, 1.0f);
}

TEST(UnitMaterialPigment, BrickDefaults) {
  expect_rgb(colour_at("brick", {3, -.25, 0}).rgb, .5, .5, .5);
  expect_rgb(colour_at("brick", {3, 1, 0}).rgb, .6, .15, .15);
}

TEST(UnitMaterialPigment, GradientRampsAndRepeats) {
  EXPECT_NEAR(colour_at("gradient x", {.25, 9, 9}).rgb.r, .25, 1e-6);
  EXPECT_NEAR(colour_at("gradient x", {3.25, 0, 0}).rgb.r, .25, 1e-4);
  EXPECT_NEAR(colour_at("gradient x", {-.25, 0, 0}).rgb.r, .75, 1e-6);
  EXPECT_NEAR(colour_at("gradient <0,3,0>", {0, .5, 0}).rgb.r, .5, 1e-6);
}

TEST(UnitMaterialPigment, WavesWrapAsTheRemainderOfADivisionDoes) {
  core::Wave wave;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-3.0, 9.0);
  for (int i = 0; i < 20'000; ++i) {
    const double size = std::exp2(exponent(random)), value = i % 2 == 0 ? size : -size;
    for (const double v : {value, std::nearbyint(value), std::nearbyint(value) * 1.00001}) {
      double wrapped = std::fabs(v) < 1.00001 ? v : std::fmod(v, 1.00001);
      if (wrapped < 0.0) wrapped -= std::floor(wrapped);
      ASSERT_EQ(wave.apply(v), wrapped) << v;
    }
  }
}

TEST(UnitMaterialPigment, FrequencyPhaseAndWaves) {
  EXPECT_NEAR(colour_at("gradient x frequency 2", {.25, 0, 0}).rgb.r, .5, 1e-6);
  EXPECT_NEAR(colour_at("gradient x phase .1", {.25, 0, 0}).rgb.r, .35, 1e-6);
  EXPECT_NEAR(colour_at("gradient x triangle_wave", {.75, 0, 0}).rgb.r, .5, 1e-6);
  EXPECT_NEAR(colour_at("gradient x sine_wave", {.25, 0, 0}).rgb.r, 1, 1e-6);
  EXPECT_NEAR(colour_at("gradient x scallop_wave", {.5, 0, 0}).rgb.r, 1, 1e-6);
  EXPECT_NEAR(colour_at("gradient x cubic_wave", {.25, 0, 0}).rgb.r, .15625, 1e-6);
  EXPECT_NEAR(colour_at("gradient x poly_wave 2", {.5, 0, 0}).rgb.r, .25, 1e-6);
}

TEST(UnitMaterialPigment, FunctionValuesWrapAboveOne) {
  EXPECT_NEAR(colour_at("function { x }", {.3, 0, 0}).rgb.r, .3, 1e-6);
  EXPECT_NEAR(colour_at("function { x }", {1.3, 0, 0}).rgb.r, .3, 1e-6);
  EXPECT_NEAR(colour_at("function { x }", {-.3, 0, 0}).rgb.r, .7, 1e-6);
  EXPECT_NEAR(colour_at("function { x }", {1, 0, 0}).rgb.r, 1, 1e-6);
}

TEST(UnitMaterialPigment, MapHoldsBeforeItsFirstAndAfterItsLast) {
  const std::string map = "gradient x color_map { [.2 rgb .1] [.4 rgb .5] [.8 rgb .9] }";
  EXPECT_FLOAT_EQ(colour_at(map, {.1, 0, 0}).rgb.r, .1f);
  EXPECT_NEAR(colour_at(map, {.3, 0, 0}).rgb.r, .3, 1e-6);
  EXPECT_NEAR(colour_at(map, {.6, 0, 0}).rgb.r, .7, 1e-6);
  EXPECT_FLOAT_EQ(colour_at(map, {.95, 0, 0}).rgb.r, .9f);
}

TEST(UnitMaterialPigment, EqualEntriesMakeAnEdge) {
  const std::string map = "gradient x color_map { [.5 rgb 0] [.5 rgb 1] }";
  EXPECT_FLOAT_EQ(colour_at(map, {.499, 0, 0}).rgb.r, 0.0f);
  EXPECT_FLOAT_EQ(colour_at(map, {.501, 0, 0}).rgb.r, 1.0f);
}

TEST(UnitMaterialPigment, OldMapEntriesNameBothEnds) {
  const std::string map =
      "gradient x color_map { [0, .5 color red 1 color green 1] [.5, 1.001 color rgb 0 color rgb "
      "1] }";
  expect_rgb(colour_at(map, {.25, 0, 0}).rgb, .5, .5, 0);
  EXPECT_NEAR(colour_at(map, {.75, 0, 0}).rgb.b, .499, 1e-3);
}

TEST(UnitMaterialPigment, EntriesOfPigmentMapsLieInThePatternsSpace) {
  const std::string map = "gradient x pigment_map { [.5 gradient y] [.5 rgb <1,0,0>] } scale 2";
  EXPECT_NEAR(colour_at(map, {.5, 1, 0}).rgb.r, .5, 1e-6);  // y = 1 is 1/2 in the scaled space
  expect_rgb(colour_at(map, {1.5, 1, 0}).rgb, 1, 0, 0);
}

TEST(UnitMaterialPigment, AverageWeighsItsEntries) {
  const std::string average = "average pigment_map { [1 rgb <1,0,0>] [3 rgb <0,1,0>] }";
  expect_rgb(colour_at(average, {0, 0, 0}).rgb, .25, .75, 0);
  expect_rgb(colour_at("average pigment_map { [rgb 0] [rgb 1] }", {0, 0, 0}).rgb, .5, .5, .5);
}

TEST(UnitMaterialPigment, TransformsApplyInTheOrderOfTheText) {
  EXPECT_NEAR(colour_at("gradient x scale 2 translate x", {1.5, 0, 0}).rgb.r, .25, 1e-6);
  EXPECT_NEAR(colour_at("gradient x translate x*.5 scale 2", {1.5, 0, 0}).rgb.r, .25, 1e-6);
  EXPECT_NEAR(colour_at("gradient x rotate z*90", {0, .25, 0}).rgb.r, .25, 1e-6);
}

TEST(UnitMaterialPigment, IdentifierKeepsItsOwnAndTakesMore) {
  const LooksText text("pigment { P scale 2 }",
                       "#declare P = pigment { gradient x translate x*.5 }");
  EXPECT_NEAR(compiled(text.pigment())->colour({1.5, 0, 0}).rgb.r, .25, 1e-6);
}

TEST(UnitMaterialPigment, RepeatFlipsEverySecondBlock) {
  const std::string repeat = "gradient x warp { repeat x flip x }";
  EXPECT_NEAR(colour_at(repeat, {.25, 0, 0}).rgb.r, .25, 1e-6);
  EXPECT_NEAR(colour_at(repeat, {1.25, 0, 0}).rgb.r, .75, 1e-6);
}

TEST(UnitMaterialPigment, QuickColourInQuickRendersOnly) {
  const LooksText text("pigment { checker quick_color rgb <1, .5, 0> }");
  EXPECT_EQ(compiled(text.pigment(), 9)->constant(), nullptr);
  ASSERT_NE(compiled(text.pigment(), 5)->constant(), nullptr);
  expect_rgb(compiled(text.pigment(), 5)->constant()->rgb, 1, .5, 0);
}

TEST(UnitMaterialPigment, IdenticalDescriptionsAreCompiledOnce) {
  const LooksText text("pigment { checker }");
  TextureCompiler compiler(TextureSettings{});
  const Ref<TextureDesc> texture = text.object().texture;
  EXPECT_EQ(compiler.texture(texture, nullptr), compiler.texture(texture, nullptr));
  EXPECT_TRUE(compiler.not_yet().empty());
}

TEST(UnitMaterialBlendMap, UnsortedEntriesAreSearchedAsInStock) {
  // The first entry that reaches the value counts, with the entry before it.
  const core::BlendMap<double> map({{0.0, 0.0}, {0.6, 6.0}, {0.4, 4.0}, {1.0, 10.0}});
  const auto place = map.find(0.5);
  EXPECT_EQ(*place.before, 0.0);
  EXPECT_EQ(*place.after, 6.0);
  EXPECT_NEAR(map.find(0.8).fraction, 0.4 / 0.6, 1e-6);
}

}  // namespace
}  // namespace lentray::parser::test
