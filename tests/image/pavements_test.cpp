// Every pavement against stock: pictures that hold a panel for each tile and for each look, and
// values, number by number. Stock has them in pigments, normals and maps: a grey ramp shows them.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "core/pattern/pavement.h"
#include "tests/image/stock_values.h"

namespace lentray::parser::test {
namespace {

using core::Pavement;

std::string pavement_words(const Pavement& p) {
  std::ostringstream words;
  words << "pavement number_of_sides " << p.sides << " number_of_tiles " << p.tiles << " pattern "
        << p.pattern << " exterior " << p.exterior << " interior " << p.interior << " form "
        << p.form;
  return words.str();
}

/// A panel each, around the pattern's own origin.
lentray::test::SceneText panels(const std::vector<Pavement>& pavements) {
  constexpr int kColumns = 8, kPixels = 48;
  const int rows = (static_cast<int>(pavements.size()) + kColumns - 1) / kColumns;
  std::ostringstream sdl;
  sdl << "#version 3.7; global_settings { assumed_gamma 1 }\n"
      << "camera { orthographic location <56, 9, " << 7 * rows << "> direction -y right 112*x up "
      << 14 * rows << "*z }\n#default { finish { ambient 1 diffuse 0 } }\n";
  for (std::size_t i = 0; i < pavements.size(); ++i) {
    sdl << "box { <-7, -1, -7>, <7, 0, 7> pigment { " << pavement_words(pavements[i]) << kGreys
        << "translate <.013, 0, .027> } translate <" << 7 + 14 * (i % kColumns) << ", 0, "
        << 7 + 14 * (i / kColumns) << "> }\n";
  }
  return {.sdl = sdl.str(),
          .width = kColumns * kPixels,
          .height = static_cast<std::uint32_t>(rows * kPixels),
          .arguments = {"File_Gamma=1.0"},
          .bits = 8,
          .files = {}};
}

std::vector<Pavement> all_tiles(int sides) {
  std::vector<Pavement> all;
  for (int tiles = 1; core::pavement_patterns(sides, tiles) > 0; ++tiles) {
    for (int pattern = 1; pattern <= core::pavement_patterns(sides, tiles); ++pattern) {
      all.push_back({.sides = sides, .tiles = tiles, .pattern = pattern});
    }
  }
  return all;
}

class ImagePavements : public ::testing::TestWithParam<int> {
 protected:
  /// A tile that has every kind of corner.
  static Pavement rich(int exterior, int interior, int form) {
    if (GetParam() == 4) return {4, 6, 24, exterior, interior, form};
    return {GetParam(), 5, GetParam() == 3 ? 3 : 16, exterior, interior, form};
  }
  static void expect_stocks_values(const std::string& transforms) {
    for (const int look : {0, 1, 2})
      expect_stocks_tiles(pavement_words(rich(look, look, look)), transforms);
  }
};

TEST_P(ImagePavements, EveryTileHasStocksPicture) {
  EXPECT_TRUE(lentray::test::same_as_stock(panels(all_tiles(GetParam()))));
}

TEST_P(ImagePavements, EveryTileHasStocksPictureWithItsCornersCutOff) {
  std::vector<Pavement> all = all_tiles(GetParam());
  for (Pavement& p : all) p.exterior = p.interior = p.form = 1;
  EXPECT_TRUE(lentray::test::same_as_stock(panels(all)));
}

TEST_P(ImagePavements, EveryLookHasStocksPicture) {
  std::vector<Pavement> looks;
  // Stock refuses none: beyond what its manual names they begin again.
  for (const int exterior : {0, 1, 2, 3}) {
    for (const int interior : {0, 1, 2, 3}) {
      for (const int form : {0, 1, 2, 3, 4}) looks.push_back(rich(exterior, interior, form));
    }
  }
  for (const int number : {-1, -2, -3, 5, 7, 256, 300})
    looks.push_back(rich(number, number, number));
  EXPECT_TRUE(lentray::test::same_as_stock(panels(looks)));
}

TEST_P(ImagePavements, HaveTheValuesOfStock) { expect_stocks_values(""); }
TEST_P(ImagePavements, HaveTheValuesOfStockFarAway) {
  expect_stocks_values("scale .37 translate <1000.3, 0, -1003.1>");
}
TEST_P(ImagePavements, HaveTheValuesOfStockTurned) {
  expect_stocks_values(
      "turbulence .4 rotate <20, 130, 40> scale <2, 1, .5> translate <-97, 3, 211>");
}

TEST_P(ImagePavements, HaveStocksPictureInNormalsAndMaps) {
  const std::string words = pavement_words(rich(2, 2, 2));
  const std::string plain = "finish { ambient .2 diffuse .8 } ";
  EXPECT_TRUE(lentray::test::same_as_stock(
      {.sdl = "#version 3.7; global_settings { assumed_gamma 1 }\n"
              "camera { location <2, 9, -12> look_at 0 } light_source { <20, 50, -30> rgb 1 }\n"
              "plane { y, 0 pigment { rgb .7 } normal { " +
              words + " bump_size .6 turbulence .2 rotate 20*y } " + plain + "}\n" +
              "sphere { <-3, 2, 0>, 2 texture { " + words +
              " frequency 2 texture_map { [.3 pigment { rgb x } " + plain +
              "] [.6 pigment { checker } " + plain + "] } rotate 30*x scale .4 } }\n" +
              "cylinder { .2*y, 3*y, 1.7 hollow pigment { rgbt 1 } interior { media { emission .3 "
              "density { " +
              words + " color_map { [0 rgb 0] [1 rgb <1, 2, 0>] } scale .6 } } } translate 4*x }",
       .width = 120,
       .height = 90,
       .arguments = {},
       .bits = 8,
       .files = {}}));
}

INSTANTIATE_TEST_SUITE_P(Each, ImagePavements, ::testing::Values(3, 4, 6),
                         [](const auto& named) { return "sides" + std::to_string(named.param); });

}  // namespace
}  // namespace lentray::parser::test
