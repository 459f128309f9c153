#include "shadow/pixel_orders.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

using namespace lentray;

namespace {

std::vector<core::Pixel> all(const core::PixelOrder& order) {
  std::vector<core::Pixel> pixels, job;
  for (std::size_t j = 0; j < order.jobs(); ++j) {
    order.pixels(j, job);
    pixels.insert(pixels.end(), job.begin(), job.end());
  }
  return pixels;
}

TEST(UnitShadowOrders, EveryPixelOnce) {
  for (const auto name : shadow::order_names()) {
    for (const auto& [w, h] : {std::pair{1u, 1u}, {1u, 500u}, {733u, 1u}, {160u, 120u},
                               {399u, 400u}, {3u, 2u}}) {
      const auto order = shadow::make_order(name, w, h);
      std::set<std::pair<unsigned, unsigned>> seen;
      for (const core::Pixel p : all(*order)) {
        EXPECT_LT(p.column, w);
        EXPECT_LT(p.row, h);
        EXPECT_TRUE(seen.insert({p.column, p.row}).second);
      }
      EXPECT_EQ(seen.size(), std::size_t{w} * h) << name << " " << w << " x " << h;
    }
  }
}

TEST(UnitShadowOrders, RowsRunAlongRowsAndColumnsDownColumns) {
  const auto rows = all(*shadow::make_order("rows", 50, 40));
  const auto columns = all(*shadow::make_order("Columns", 50, 40));
  EXPECT_EQ(rows[1].column, 1u);
  EXPECT_EQ(rows[1].row, 0u);
  EXPECT_EQ(rows[50].row, 1u);
  EXPECT_EQ(columns[1].row, 1u);
  EXPECT_EQ(columns[1].column, 0u);
  EXPECT_EQ(columns[40].column, 1u);
}

TEST(UnitShadowOrders, JobsAreManyAndHoldRuns) {
  for (const auto name : shadow::order_names()) {
    const auto order = shadow::make_order(name, 1995, 2000);
    EXPECT_GE(order->jobs(), 64u);
    std::vector<core::Pixel> job;
    order->pixels(0, job);
    EXPECT_GE(job.size(), 1995u) << "at least a whole line";
  }
}

TEST(UnitShadowOrders, RegionsStayWithinTheirBorders) {
  const auto order = shadow::make_order("rows", {10, 20, 13, 22});
  const auto pixels = all(*order);
  ASSERT_EQ(pixels.size(), 6u);
  EXPECT_EQ(pixels.front().column, 10u);
  EXPECT_EQ(pixels.front().row, 20u);
  EXPECT_EQ(pixels.back().column, 12u);
  EXPECT_EQ(pixels.back().row, 21u);
  EXPECT_EQ(shadow::make_order("columns", {5, 5, 5, 9})->jobs(), 0u);
}

TEST(ErrorShadowOrders, UnknownNameListsWhatThereIs) {
  try {
    shadow::make_order("diagonal", 4, 4);
    FAIL() << "no exception";
  } catch (const std::invalid_argument& e) {
    EXPECT_STREQ(e.what(), "unknown pixel order 'diagonal': there are rows, columns");
  }
}

}  // namespace
