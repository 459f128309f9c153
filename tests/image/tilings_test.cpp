// Every tiling against stock, number by number, near the origin and far from it. Stock has them in
// pigments only: a grey ramp shows their values as floats.
#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>
#include <string>

#include "tests/image/stock_values.h"

namespace lentray::parser::test {
namespace {

class ImageTilings : public ::testing::TestWithParam<int> {
 protected:
  static void expect_stocks(const std::string& transforms) {
    expect_stocks_tiles("tiling " + std::to_string(GetParam()), transforms);
  }
};

TEST_P(ImageTilings, HaveTheValuesOfStock) { expect_stocks(""); }
TEST_P(ImageTilings, HaveTheValuesOfStockFarAway) {
  expect_stocks("scale .37 translate <1000.3, 0, -1003.1>");
}
TEST_P(ImageTilings, HaveTheValuesOfStockTurned) {
  expect_stocks("rotate <20, 130, 40> scale <2, 1, .5> translate <-97, 3, 211>");
}

/// A map with steps where levels begin: flat middles are on the right side of their step.
TEST_P(ImageTilings, HaveStocksPictureWithAStepAtEachLevel) {
  const double places[] = {1.0 / 6, 1.0 / 5, 1.0 / 3, 2.0 / 5, .5,
                           3.0 / 5, 2.0 / 3, 4.0 / 5, 5.0 / 6};
  std::ostringstream steps;
  steps << std::setprecision(17) << "[0 rgb 0]";
  double grey = 0.0;
  for (const double place : places) {
    steps << " [" << place << " rgb " << grey << "] [" << place << " rgb " << grey + .1 << "]";
    grey += .1;
  }
  const lentray::test::SceneText scene{
      .sdl =
          "#version 3.7; global_settings { assumed_gamma 1 }\n"
          "camera { orthographic location <.013, 5, .027> direction -5*y up 9*z right 12*x }\n"
          "plane { y, 0 pigment { tiling " +
          std::to_string(GetParam()) + " color_map { " + steps.str() +
          " } } finish { ambient 1 diffuse 0 } }",
      .width = 160,
      .height = 120,
      .arguments = {},
      .files = {}};
  EXPECT_TRUE(same_as_stock(scene));
}

INSTANTIATE_TEST_SUITE_P(Each, ImageTilings, ::testing::Range(1, 28),
                         [](const auto& named) { return "n" + std::to_string(named.param); });

}  // namespace
}  // namespace lentray::parser::test
