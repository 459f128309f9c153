// The paper's test in the real kernel: continuous cache hits measured are those enumerated.
#include <gtest/gtest.h>

#include "shadow/hit_model/paper_test.h"
#include "tests/unit/shadow/paper_sheet.h"

using namespace lentray;
using lentray::test::sheet_of;
using shadow::Enumeration;
using shadow::PaperSheet;
using shadow::PaperTest;
using shadow::ShadowSquare;
using shadow::Style;
using Kind = shadow::Style::Kind;

namespace {

void expect_equal(const PaperSheet& sheet, const ShadowSquare& square,
                  const std::vector<Style>& styles) {
  const Enumeration shadow(sheet, square);
  const PaperTest test(sheet, shadow, square.distance);
  for (const Style& style : styles) {
    const shadow::Measurement m = test.measure(style);
    EXPECT_EQ(m.continuous_hits, shadow.continuous_hits(style))
        << style.name() << " A = " << square.size << " D = " << square.distance;
    ASSERT_EQ(m.blocked, shadow.blocked());
    // One object casts the shadow, and a cache keeps it: one miss in any order.
    ASSERT_EQ(m.cache_hits, m.blocked == 0 ? 0 : m.blocked - 1);
  }
}

/// `every`: how many points of the 40 x 40 are left out between two.
void expect_equal_over_the_grid(int every) {
  const PaperSheet sheet = sheet_of(5, 41, 60);
  for (int i = 0; i < 40 * 40; i += every) {
    const double a = 0.1 + 0.5 * (i % 40), d = 1.0 * (i / 40);
    expect_equal(sheet, {a, d, 0.3, -2.1}, shadow::paper_styles());
  }
}

TEST(UnitShadowPaperTest, MeasuredIsEnumerated) { expect_equal_over_the_grid(37); }

TEST(SlowShadowPaperTest, MeasuredIsEnumeratedAtEveryPoint) { expect_equal_over_the_grid(1); }

TEST(UnitShadowPaperTest, ThePapersOwnSheet) {
  expect_equal(sheet_of(15, 133, 40), {20, 13, 0.3, -0.4}, shadow::paper_styles());
}

TEST(UnitShadowPaperTest, FixedStrips) {
  const PaperSheet sheet = sheet_of(7, 12, 50);
  for (const double d : {0.0, 3.0, 20.0}) {
    expect_equal(sheet, {4.1, d, -2.2, -1.0},
                 {{Kind::kCombined, 3, 1}, {Kind::kStrips, 3, 4}, {Kind::kStrips, 2, 13}});
  }
}

TEST(UnitShadowPaperTest, CornersOfTheSheetAndOddLenses) {
  const std::vector<Style>& styles = shadow::paper_styles();
  for (const double d : {0.0, 0.01, 7.0}) {
    const PaperSheet sheet = sheet_of(5, 9, 20);
    expect_equal(sheet, {3, d, -9, -9}, styles);        // upper left corner
    expect_equal(sheet, {100, d, -50, -50}, styles);    // over all of it
    expect_equal(sheet, {100, d, 0.1, -50}, styles);    // to the right and lower border
    expect_equal(sheet, {0.003, d, 0.1, 0.1}, styles);  // smaller than a pixel
    expect_equal(sheet, {1, d, 30, 30}, styles);        // beside it
    expect_equal(sheet, {1.124 * 2, d, 0, 0}, styles);  // edges on lens axes
    expect_equal(sheet_of(3.7, 9, 20), {3, d, -1, -1}, styles);
    expect_equal(sheet_of(1, 20, 20), {3, d, -1, -1}, styles);
    const PaperSheet dark = sheet_of(8, 5, 12, 1.8, 6.0);
    ASSERT_GT(dark.columns().dark_columns(), 0u);
    expect_equal(dark, {9, d, -5, -4}, styles);
  }
}

TEST(UnitShadowPaperTest, CachesChangeNothing) {
  const PaperSheet sheet = sheet_of(5, 9, 20);
  const ShadowSquare square{3, 4, -1, -1};
  const Enumeration shadow(sheet, square);
  const PaperTest test(sheet, shadow, square.distance);
  for (const char* cache : {"off", "last", "depth", "tree", "neighbourhood", "grid", "cascade"}) {
    EXPECT_EQ(test.measure({Kind::kRows}, cache).continuous_hits,
              shadow.continuous_hits({Kind::kRows}));
  }
  EXPECT_EQ(test.measure({Kind::kRows}, "off").cache_hits, 0u);
}

}  // namespace
