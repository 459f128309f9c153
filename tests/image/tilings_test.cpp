// Every tiling against stock, number by number, near the origin and far from it. Stock has them in
// pigments only: a grey ramp shows their values as floats.
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>
#include <string>

#include "parser/compile/pattern_compiler.h"
#include "tests/image/stock_values.h"
#include "tests/unit/material_reading.h"

namespace lentray::parser::test {
namespace {

constexpr const char* kRamp = " color_map { [0 rgb 0] [1 rgb 1] } ";

class ImageTilings : public ::testing::TestWithParam<int> {
 protected:
  /// The tiling with these transforms after it has stock's values.
  static void expect_stocks(const std::string& transforms) {
    const std::string text = "tiling " + std::to_string(GetParam()) + kRamp + transforms;
    const auto stock = stock_values("pigment { " + text + " }", "", {"V.red"});
    const LooksText read("pigment { " + text + " }");
    const TextureSettings settings;
    std::set<std::string> not_yet;
    const PatternBuild build{settings, not_yet, nullptr, nullptr};
    const core::PlacedPattern ours = compile_placed(read.pattern(), core::Placement(), build);
    EXPECT_TRUE(not_yet.empty());
    const auto points = sample_points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (on_edge(points[i])) continue;
      expect_same(ours.value(ours.placement.inwards(points[i])), stock[i], 2e-6, points[i]);
    }
  }

 private:
  /// The points of whole and half numbers are on edges and corners of many tiles.
  static bool on_edge(const core::Vec3& p) {
    return 2 * p.x == std::floor(2 * p.x) && 2 * p.z == std::floor(2 * p.z);
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
