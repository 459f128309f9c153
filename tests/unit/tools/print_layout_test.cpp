// Several pictures on one lens sheet: where they stand.
#include <gtest/gtest.h>

#include <cmath>

#include "tools/lentray-print/layout.h"

namespace lentray::print {
namespace {

double lens_place(const LayoutPlace& place, const LayoutStyle& style, double lens) {
  return static_cast<double>(place.column) + place.origin + lens * style.strip;
}

TEST(UnitPrintLayout, StripsAreInPhaseOverTheSheet) {
  const LayoutStyle style{.strip = 12.37, .lens = 12.37, .gap_lenses = 7, .gap_rows = 50};
  const std::vector<LayoutItem> items{{40, 300}, {31, 200}, {40, 300}, {25, 310}, {12, 100}};
  const Layout layout = layout_of(items, {3, 2}, style);
  EXPECT_EQ(layout.grid, (LayoutGrid{3, 2}));
  EXPECT_EQ(layout.lenses, 40 + 7 + 31 + 7 + 40);
  EXPECT_EQ(layout.rows, 300 + 50 + 310);
  for (const LayoutPlace& place : layout.places) {
    const double lenses = (lens_place(place, style, 0.0) - layout.marks.origin) / style.strip;
    EXPECT_NEAR(lenses, std::round(lenses), kWholeColumn);
    EXPECT_LE(std::fabs(place.origin), 0.5);
  }
  EXPECT_EQ(layout.places[1].row, 50);
  EXPECT_EQ(layout.places[4].row, 300 + 50 + 105);
}

/// Strips are wider apart than lenses: each picture's middle is over a lens's middle, or an edge.
TEST(UnitPrintLayout, EachPictureIsCentredOnTheLenses) {
  const LayoutStyle style{.strip = 15.02, .lens = 15.0, .gap_lenses = 4, .gap_rows = 10};
  const std::vector<LayoutItem> items{{41, 100}, {40, 100}, {17, 100}, {41, 100}};
  const Layout layout = layout_of(items, {4, 1}, style);
  const auto middle = [&](std::size_t i) {
    return lens_place(layout.places[i], style, 0.5 * static_cast<double>(items[i].lenses));
  };
  for (std::size_t i = 1; i < items.size(); ++i) {
    const double halves = (middle(i) - middle(0)) / (0.5 * style.lens);
    EXPECT_NEAR(halves, std::round(halves), 2.0 * kWholeColumn / 15.0);
    const bool is_odd = (items[i].lenses - items[0].lenses) % 2 != 0;
    EXPECT_EQ(std::lround(halves) % 2 != 0, is_odd);
  }
}

TEST(UnitPrintLayout, GapsGrowWhereThatSavesMixing) {
  LayoutStyle style{.strip = 12.25, .lens = 12.25, .gap_lenses = 2, .more_lenses = 3};
  const std::vector<LayoutItem> items(3, {9, 50});
  for (const LayoutPlace& place : layout_of(items, {3, 1}, style).places)
    EXPECT_EQ(place.origin, 0.0);
  style.more_lenses = 0;
  EXPECT_NEAR(layout_of(items, {3, 1}, style).places[1].origin, -0.25, 1e-9);
}

TEST(UnitPrintLayout, Grids) {
  const auto square = [](const LayoutGrid& grid) { return grid.columns * 3.0 + grid.rows * 2.0; };
  EXPECT_EQ(best_grid(12, square), (LayoutGrid{3, 4}));
  EXPECT_EQ(best_grid(7, square), (LayoutGrid{2, 4}));
  EXPECT_EQ(best_grid(5, [](const LayoutGrid& grid) { return grid.columns > 1 ? -1.0 : 1.0; }),
            (LayoutGrid{1, 5}));
  EXPECT_EQ(best_grid(5, [](const LayoutGrid&) { return -1.0; }).columns, 0);
}

TEST(UnitPrintLayout, MiddleKeepsItsPlaces) {
  for (const std::int64_t lenses : {1, 40, 99, 100}) {
    for (const double to : {11.970075, 12.0, 12.013, 15.2}) {
      const double origin = origin_about_middle(lenses, 12.0, to);
      EXPECT_GT(origin, -0.5 - 1e-12);
      EXPECT_LE(origin, 0.5);
      const double half = 0.5 * static_cast<double>(lenses);
      const double moved = origin + half * to - half * 12.0;
      EXPECT_NEAR(moved, std::round(moved), 1e-9);
    }
  }
}

}  // namespace
}  // namespace lentray::print
