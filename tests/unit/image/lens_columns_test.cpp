// Which lens a column lies behind, and how many whole lenses a picture has: the one rule for all programs.
#include <gtest/gtest.h>

#include "camera/lens_sheet.h"
#include "core/image/thumbnail.h"
#include "core/numeric/lens_columns.h"

namespace lentray::core {
namespace {

/// A lens that lacks less than half a pixel is whole, one that lacks more is not.
TEST(UnitLensColumns, RoundingCostsNoLens) {
  struct Case {
    std::uint32_t width;
    double pixels;
    std::int64_t lenses;
  };
  const Case cases[] = {{1197, 11.970075, 100},  // 1197.0075 columns
                        {1197, 11.9700, 100},   {1196, 11.970075, 99}, {1193, 11.9356, 99},
                        {1793, 17.932752, 100},  // 40.15 lpi at 720 dpi
                        {150, 15.0, 10},        {149, 15.0, 9},        {151, 15.0, 10},
                        {1003, 10.03499, 100},  {1003, 10.0351, 99},   {1003, 10.0301, 100}};
  for (const Case& one : cases) {
    EXPECT_EQ(LensColumns{one.pixels}.whole_lenses(one.width), one.lenses)
        << one.width << " columns, N " << one.pixels;
  }
  EXPECT_EQ(LensColumns{12.0}.whole_lenses(11), 0);
}

TEST(UnitLensColumns, AWholeLensHasAllOfItsColumns) {
  for (const double pixels : {1.0, 1.5, 7.3, 11.970075, 15.0, 15.1839, 40.5}) {
    for (const double origin : {0.0, 0.5, -0.49, 0.123}) {
      const LensColumns lenses{pixels, origin};
      for (std::int64_t lens = -3; lens < 300; ++lens) {
        const std::int64_t first = lenses.first_column(lens);
        EXPECT_EQ(lenses.lens_of(first), lens);
        EXPECT_EQ(lenses.lens_of(first - 1), lens - 1);
      }
      for (std::uint32_t width = 50; width < 400; ++width) {
        const std::int64_t whole = lenses.whole_lenses(width);
        EXPECT_LE(lenses.first_column(whole), width);
        EXPECT_GT(lenses.first_column(whole + 1), width);
        // What the last whole one lacks is half a pixel at most.
        EXPECT_LE(lenses.edge(static_cast<double>(whole)), width + 0.5 + 1e-9);
        EXPECT_EQ(lenses.is_last_cut(width), lenses.first_column(whole) < width);
      }
    }
  }
}

/// The sheet's report, thumbnails and views count alike.
TEST(UnitLensColumns, AllCountAlike) {
  camera::LensParameters lens;
  lens.pixels = 11.970075;
  const camera::LensSheet sheet(lens, 1197);
  EXPECT_EQ(sheet.lens_count(), 100u);
  EXPECT_EQ(sheet.counted_lenses(), 100.0);
  EXPECT_LT(sheet.lenses(), 100.0);
  EXPECT_EQ(view_columns(1197, lens.pixels, 3.0).size(), 100u);
  const camera::LensSheet cut(lens, 1190);
  EXPECT_NEAR(cut.counted_lenses(), 1190 / 11.970075, 1e-9);
  EXPECT_EQ(view_columns(1190, lens.pixels, 3.0).size(), 99u);
}

}  // namespace
}  // namespace lentray::core
