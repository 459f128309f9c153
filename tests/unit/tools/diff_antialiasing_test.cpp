// What lentray-diff asks both renderers for, and the means it makes of stock's pictures.
#include "tools/lentray-diff/antialiasing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "core/image/srgb.h"
#include "parser/options/options.h"
#include "tools/lentray-diff/mean.h"
#include "tools/lentray-diff/sampling.h"

namespace lentray::diff {
namespace {

using Words = std::vector<std::string>;

Antialiasing asked(const Words& options) {
  return antialiasing_of(parser::read_options(options, {}));
}

TEST(UnitDiffAntialiasing, OffUnlessAskedFor) {
  EXPECT_EQ(words(asked({})), (Words{"-A", "-J"}));
  EXPECT_EQ(words(asked({"+AM2", "+R4", "-A0.2"})), (Words{"-A", "-J"}));
  EXPECT_EQ(asked({"Antialias_Angle=4"}).angles, 4);
}

TEST(UnitDiffAntialiasing, AllOfItReachesBoth) {
  EXPECT_EQ(words(asked({"+A0.0", "+AM2", "+R4", "-J", "+AG1.5"})),
            (Words{"Antialias=On", "Sampling_Method=2", "Antialias_Threshold=0",
                   "Antialias_Depth=4", "Antialias_Gamma=1.5", "Jitter=Off"}));
  EXPECT_EQ(words(asked({"Antialias=On", "Jitter_Amount=0.5"})),
            (Words{"Antialias=On", "Sampling_Method=1", "Antialias_Threshold=0.29999999999999999",
                   "Antialias_Depth=3", "Antialias_Gamma=2.5", "Jitter=On", "Jitter_Amount=0.5"}));
}

TEST(UnitDiffAntialiasing, WordsMeanWhatWasAskedFor) {
  const Antialiasing a = asked({"+A0.07", "+AM2", "+R5", "+J0.3", "+AG2"});
  const Antialiasing b = asked(words(a));
  EXPECT_EQ(std::tie(a.on, a.method, a.threshold, a.depth, a.jitter, a.gamma),
            std::tie(b.on, b.method, b.threshold, b.depth, b.jitter, b.gamma));
}

TEST(UnitDiffAntialiasing, OnlyJitterIsRandom) {
  EXPECT_TRUE(is_random(asked({"+A"})));
  EXPECT_FALSE(is_random(asked({"+A", "-J"})));
  EXPECT_FALSE(is_random(asked({"+A", "+J0.0"})));
  EXPECT_FALSE(is_random(asked({})));
}

Sheet sheet(double pixels, std::uint32_t columns) {
  Sheet s;
  s.pixels = pixels;
  s.columns = columns;
  s.rows = 7;
  s.width = 3.0;
  s.view_distance = 60.0;
  return s;
}

TEST(UnitDiffSampling, SamplesAPixel) {
  StockOptions options;
  EXPECT_EQ(samples_a_pixel(Way::mesh_camera, options), 1);
  options.antialiasing.angles = 3;
  EXPECT_EQ(samples_a_pixel(Way::mesh_camera, options), 3);
  options.antialiasing.on = true;
  EXPECT_EQ(samples_a_pixel(Way::mesh_camera, options), 192);
  EXPECT_EQ(samples_a_pixel(Way::perspective_views, options), 3);
  options.antialiasing.angles = 1;
  EXPECT_EQ(samples_a_pixel(Way::orthographic_views, options), 1);
}

TEST(UnitDiffSampling, PlacesFillThePixelAndListsStayShort) {
  for (const std::uint32_t most : {10u, 300u, 100000u}) {
    std::set<std::tuple<double, double, double>> places;
    for (const auto& list : sample_places(sheet(12.4, 100), 4, 2, most)) {
      ASSERT_FALSE(list.empty());
      EXPECT_LE(list.size(), std::max(1u, most / 100));
      for (const PixelOffset& o : list) {
        EXPECT_EQ(o.down, list[0].down);
        places.insert({o.across, o.down, o.turn});
      }
    }
    EXPECT_EQ(places.size(), 32u);
    EXPECT_EQ(*places.begin(), std::make_tuple(-0.375, -0.375, -0.25));
    EXPECT_EQ(*places.rbegin(), std::make_tuple(0.375, 0.375, 0.25));
  }
}

TEST(UnitDiffSampling, TurnsAreTheColumnsOfAFinerSheet) {
  for (const bool paraxial : {true, false}) {
    Sheet coarse = sheet(5, 48);
    coarse.paraxial = paraxial;
    const Sheet finer = coarse.finer(4);
    EXPECT_EQ(finer.lenses(), coarse.lenses());
    for (std::uint32_t k = 0; k < coarse.columns; ++k) {
      for (std::uint32_t part = 0; part < 4; ++part) {
        const double turn = (part + 0.5) / 4 - 0.5;
        EXPECT_NEAR(*coarse.slope(k, {.turn = turn}), *finer.slope(4 * k + part), 1e-14);
      }
    }
  }
}

TEST(UnitDiffSampling, AcrossJoinsTheNextLens) {
  const Sheet s = sheet(5, 50);
  for (std::uint32_t k = 0; k + 5 < s.columns; ++k) {
    EXPECT_NEAR(*s.slope(k, {.across = 0.5}), *s.slope(k + 5, {.across = -0.5}), 1e-14);
  }
}

core::StoredImage light(const std::vector<float>& samples, int channels) {
  core::StoredImage image;
  image.width = image.height = 1;
  image.channels = channels;
  image.bits = 32;
  image.samples = samples;
  return image;
}

double mean_of(const ColourSpaces& spaces, const std::vector<std::vector<float>>& samples) {
  Mean mean(1, 1, spaces);
  for (const auto& s : samples) mean.add(0, 0, light(s, static_cast<int>(s.size())), 0, 0);
  return mean.picture(static_cast<int>(samples.size()), 16).at(0, 0, 0) / 65535.0;
}

TEST(UnitDiffMean, OfLinearLightAndUnclipped) {
  ColourSpaces linear{.file_srgb = false};
  EXPECT_NEAR(mean_of(linear, {{0, 0, 0}, {1.5, 0, 0}}), 0.75, 1e-5);
  linear.file_srgb = true;
  EXPECT_NEAR(mean_of(linear, {{0, 0, 0}, {0.5, 0, 0}}), core::srgb_of_linear(0.25f), 1e-5);
}

TEST(UnitDiffMean, OfColoursAsTheSceneComputesThem) {
  const ColourSpaces power{.working_gamma = 2.0, .file_srgb = false};
  EXPECT_NEAR(mean_of(power, {{0, 0, 0}, {1, 0, 0}}), 0.25, 1e-5);  // 0.5 there
  const ColourSpaces srgb{.working = ColourSpaces::Working::srgb, .file_srgb = true};
  EXPECT_NEAR(mean_of(srgb, {{0, 0, 0}, {1, 0, 0}}), 0.5, 1e-5);
  const ColourSpaces unchanged{.working = ColourSpaces::Working::unchanged, .file_srgb = true};
  EXPECT_NEAR(mean_of(unchanged, {{0, 0, 0}, {1, 0, 0}}), 0.5, 1e-5);
}

TEST(UnitDiffMean, ClearSamplesDoNotDarkenWhatIsThere) {
  ColourSpaces spaces{.file_srgb = false, .alpha = true};
  EXPECT_NEAR(mean_of(spaces, {{0, 0, 0, 0}, {0.5, 0, 0, 1}}), 0.5, 1e-5);
  spaces.alpha = false;
  EXPECT_NEAR(mean_of(spaces, {{0, 0, 0}, {0.5, 0, 0}}), 0.25, 1e-5);
}

TEST(UnitDiffMean, SpacesAreThoseOfTheRun) {
  const auto options = parser::read_options(Words{"File_Gamma=1.8", "+UA"}, {});
  const auto spaces = [&](nlohmann::json gamma) {
    return colour_spaces_of({{"image", {{"working_gamma", std::move(gamma)}}}}, options);
  };
  EXPECT_EQ(spaces(2.2).working_gamma, 2.2);
  EXPECT_EQ(spaces(2.2).file_gamma, 1.8);
  EXPECT_FALSE(spaces(2.2).file_srgb);
  EXPECT_TRUE(spaces(2.2).alpha);
  EXPECT_EQ(spaces("sRGB").working, ColourSpaces::Working::srgb);
  EXPECT_EQ(spaces(nullptr).working, ColourSpaces::Working::unchanged);
  EXPECT_THROW(colour_spaces_of(nlohmann::json::object(), options), std::runtime_error);
}

}  // namespace
}  // namespace lentray::diff
