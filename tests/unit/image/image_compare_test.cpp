// Grades of pictures, on pictures whose differences are known by construction.
#include "core/image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace lentray::core {
namespace {

StoredImage image_compare_flat(std::uint32_t width, std::uint32_t height, float value,
                               int bits = 8) {
  StoredImage image;
  image.width = width;
  image.height = height;
  image.channels = 3;
  image.bits = bits;
  image.samples.assign(std::size_t{3} * width * height, value);
  return image;
}

/// The first `count` pixels, row by row, are raised in green.
StoredImage with_change(StoredImage image, std::uint32_t count, float by) {
  for (std::uint32_t i = 0; i < count; ++i) image.samples[3 * i + 1] += by;
  return image;
}

Comparison whole(const StoredImage& a, const StoredImage& b) {
  return compare(a, b, Columns::all(a.width));
}

TEST(UnitImageCompare, EqualIsExact) {
  const Comparison c = whole(image_compare_flat(20, 10, 77), image_compare_flat(20, 10, 77));
  EXPECT_EQ(c.grade, Grade::exact);
  EXPECT_EQ(c.pixels, 200u);
  EXPECT_EQ(c.largest, 0.0);
  EXPECT_TRUE(std::isinf(c.psnr));
}

TEST(UnitImageCompare, FiguresAreRight) {
  const StoredImage a = image_compare_flat(100, 100, 100);
  const Comparison c = whole(a, with_change(a, 30, 3.0f));
  EXPECT_EQ(c.beyond_1, 30u);
  EXPECT_EQ(c.beyond_2, 30u);
  EXPECT_EQ(c.largest, 3.0);
  EXPECT_NEAR(c.mean, 30 * 3.0 / 10000, 1e-12);
  EXPECT_NEAR(c.psnr, 10 * std::log10(255.0 * 255.0 * 30000 / (30 * 9.0)), 1e-9);
}

TEST(UnitImageCompare, ExactAllowsOneInAThousand) {
  const StoredImage a = image_compare_flat(100, 100, 100);
  EXPECT_EQ(whole(a, with_change(a, 10, 200.0f - 50.0f)).grade, Grade::exact);
  EXPECT_EQ(whole(a, with_change(a, 11, 2.0f)).grade, Grade::match);
  EXPECT_EQ(whole(a, with_change(a, 10000, 1.0f)).grade, Grade::exact);
}

TEST(UnitImageCompare, MatchNeedsShareAndPsnr) {
  const StoredImage a = image_compare_flat(100, 100, 100);
  EXPECT_EQ(whole(a, with_change(a, 100, 20.0f)).grade, Grade::match);
  EXPECT_NE(whole(a, with_change(a, 101, 20.0f)).grade, Grade::match);
  // 1 % beyond, but far: 40 dB are 6.5 levels squared over all channels.
  EXPECT_NE(whole(a, with_change(a, 100, 150.0f)).grade, Grade::match);
}

TEST(UnitImageCompare, LensAllowance) {
  const StoredImage a = image_compare_flat(15, 100, 100);
  const StoredImage b = with_change(a, 30, 10.0f);  // 2 % of the lens
  EXPECT_LT(whole(a, b).grade, Grade::match);
  EXPECT_EQ(compare(a, b, Columns::all(15), kLensAllowance).grade, Grade::match);
  EXPECT_LT(compare(a, with_change(a, 31, 10.0f), Columns::all(15), kLensAllowance).grade,
            Grade::match);
}

TEST(UnitImageCompare, CloseLooksThroughTheBoxFilter) {
  StoredImage a = image_compare_flat(64, 64, 100), b = a;
  for (std::size_t i = 0; i < b.samples.size(); ++i) b.samples[i] += (i / 3) % 2 ? 40.0f : -40.0f;
  const Comparison noise = whole(a, b);
  EXPECT_LT(noise.psnr, 30.0);
  EXPECT_GT(noise.smooth_psnr, 60.0);
  EXPECT_EQ(noise.grade, Grade::close);
  EXPECT_EQ(whole(a, image_compare_flat(64, 64, 140)).grade, Grade::fails);
}

TEST(UnitImageCompare, SixteenBitsOnTheSameScale) {
  const StoredImage a = image_compare_flat(10, 10, 100 * 257.0f, 16);
  EXPECT_EQ(whole(a, image_compare_flat(10, 10, 100.0f)).largest, 0.0);
  const Comparison c = whole(a, with_change(a, 50, 257.0f));
  EXPECT_NEAR(c.largest, 1.0, 1e-6);
  EXPECT_EQ(c.beyond_1, 0u);
}

TEST(UnitImageCompare, GreyAndAlpha) {
  StoredImage grey = image_compare_flat(4, 4, 9);
  grey.channels = 1;
  grey.samples.assign(16, 50.0f);
  StoredImage rgba = image_compare_flat(4, 4, 9);
  rgba.channels = 4;
  rgba.samples.assign(64, 50.0f);
  for (int i = 3; i < 64; i += 4) rgba.samples[i] = 255.0f;
  EXPECT_EQ(whole(grey, rgba).largest, 0.0);
}

TEST(UnitImageCompare, BlocksAre16AndBiasIsSigned) {
  // 40 x 20: blocks of 16, 16 and 8 columns, 16 and 4 rows.
  const StoredImage a = image_compare_flat(40, 20, 100);
  StoredImage b = a;
  for (std::uint32_t y = 16; y < 20; ++y) {
    for (std::uint32_t x = 32; x < 40; ++x)
      b.at(x, y, 2) += 6.0f;  // one of six blocks, one channel
  }
  const BlockDifference d = whole(a, b).blocks;
  EXPECT_NEAR(d.rms, std::sqrt(36.0 / 18.0), 1e-9);
  EXPECT_NEAR(d.bias, -6.0 * 32 / 800, 1e-9);
  b = a;
  for (std::uint32_t i = 0; i < 800; ++i) b.samples[3 * i] += i % 2 ? 5.0f : -5.0f;
  EXPECT_NEAR(whole(a, b).blocks.rms, 0.0, 1e-9);
}

TEST(UnitImageCompare, NoiseIsStocksOwn) {
  EXPECT_TRUE(is_within({0.3, -0.2}, {0.0, 0.0}));
  EXPECT_FALSE(is_within({0.31, 0.0}, {0.2, 0.0}));
  EXPECT_FALSE(is_within({0.0, -0.21}, {0.0, 0.1}));
  EXPECT_TRUE(is_within({1.49, 0.74}, {1.0, 0.5}));
  EXPECT_FALSE(is_within({1.51, 0.0}, {1.0, 0.5}));
  EXPECT_FALSE(is_within({0.0, 0.76}, {1.0, 0.5}));
  const BlockDifference r = root_mean_square(std::vector<BlockDifference>{{3.0, -1.0}, {4.0, 7.0}});
  EXPECT_NEAR(r.rms, std::sqrt(12.5), 1e-12);
  EXPECT_NEAR(r.bias, 5.0, 1e-12);
}

/// A picture whose left half is `by` brighter, and right half as much darker.
StoredImage image_compare_halves(float by) {
  StoredImage image = image_compare_flat(64, 32, 100);
  for (std::uint32_t y = 0; y < 32; ++y) {
    for (std::uint32_t x = 0; x < 64; ++x) image.at(x, y, 0) += x < 32 ? by : -by;
  }
  return image;
}

TEST(UnitImageCompare, GradeByNoise) {
  const StoredImage stock = image_compare_halves(0.0f);
  // Blocks off by 10 in one channel of three: S = 10/sqrt 3, so that 15 is allowed.
  const std::vector<StoredImage> others(3, image_compare_halves(10.0f));
  const auto graded = [&](float by) {
    LensComparison c;
    c.whole = whole(image_compare_halves(by), stock);
    grade_by_noise(c, stock, others);
    return c;
  };
  EXPECT_EQ(graded(1.0f).whole.grade, Grade::exact);
  EXPECT_EQ(graded(14.9f).whole.grade, Grade::noise);
  EXPECT_NEAR(graded(14.9f).whole.noise->rms, 10.0 / std::sqrt(3.0), 1e-6);
  EXPECT_EQ(graded(15.1f).whole.grade, Grade::fails);  // which was close
  EXPECT_TRUE(reaches(graded(14.9f), Grade::noise));
  EXPECT_FALSE(reaches(graded(14.9f), Grade::match));
}

TEST(UnitImageCompare, EachViewHasItsOwnNoise) {
  const StoredImage stock = image_compare_flat(64, 32, 100);
  const auto with_view = [&](std::uint32_t view, float by) {
    StoredImage image = stock;
    for (std::uint32_t y = 0; y < 32; ++y) {
      for (std::uint32_t x = view; x < 64; x += 2) image.at(x, y, 1) += by;
    }
    return image;
  };
  const std::vector<StoredImage> others(3, with_view(1, 10.0f));
  LensComparison c = compare_lenses(with_view(1, 12.0f), stock, 2);
  EXPECT_LT(c.lenses[0].grade, Grade::match);
  grade_by_noise(c, stock, others);
  EXPECT_EQ(c.views[0].grade, Grade::exact);
  EXPECT_EQ(c.views[1].grade, Grade::noise);
  EXPECT_TRUE(reaches(c, Grade::noise));  // lenses are not asked
  c = compare_lenses(with_view(0, 12.0f), stock, 2);
  grade_by_noise(c, stock, others);
  EXPECT_EQ(c.views[0].grade, Grade::fails);
  EXPECT_FALSE(reaches(c, Grade::noise));
}

TEST(UnitImageCompare, LensesAndViews) {
  const StoredImage a = image_compare_flat(44, 20, 100);  // N = 15: lenses of 15, 15 and 14 columns
  StoredImage b = a;
  for (std::uint32_t y = 0; y < 20; ++y) b.at(16, y, 0) = 200;  // lens 1, view 1
  const LensComparison c = compare_lenses(a, b, 15);
  ASSERT_EQ(c.lenses.size(), 3u);
  ASSERT_EQ(c.views.size(), 15u);
  EXPECT_EQ(c.lenses[2].pixels, 14u * 20u);
  EXPECT_EQ(c.views[14].pixels, 2u * 20u);
  EXPECT_EQ(c.lenses[0].beyond_1, 0u);
  EXPECT_EQ(c.lenses[1].beyond_1, 20u);
  EXPECT_EQ(c.views[1].beyond_1, 20u);
  EXPECT_EQ(c.views[2].beyond_1, 0u);
}

TEST(UnitImageCompare, FractionalLensesFollowTheCentres) {
  const StoredImage a = image_compare_flat(20, 4, 100);
  const LensComparison c = compare_lenses(a, a, 7.37);
  ASSERT_EQ(c.lenses.size(), 3u);  // centres 7.5 and 15.5 are the first beyond 7.37 and 14.74
  EXPECT_EQ(c.lenses[0].pixels, 7u * 4u);
  EXPECT_EQ(c.lenses[1].pixels, 8u * 4u);
  EXPECT_TRUE(c.views.empty());
}

TEST(UnitImageCompare, OneBadLensIsNotLostInTheWhole) {
  const StoredImage a = image_compare_flat(15 * 200, 40, 100);
  StoredImage b = a;
  for (std::uint32_t y = 0; y < 40; ++y) {
    for (std::uint32_t x = 15; x < 30; ++x) b.at(x, y, 1) = 110;
  }
  const LensComparison c = compare_lenses(a, b, 15);
  EXPECT_EQ(c.whole.grade, Grade::match);
  EXPECT_LT(c.lenses[1].grade, Grade::match);
  EXPECT_FALSE(reaches(c, Grade::match));
  EXPECT_TRUE(reaches(compare_lenses(a, a, 15), Grade::exact));
}

TEST(ErrorImageCompare, DifferentSizes) {
  EXPECT_THROW(whole(image_compare_flat(3, 3, 1), image_compare_flat(3, 4, 1)),
               std::invalid_argument);
  EXPECT_THROW(compare_lenses(image_compare_flat(3, 3, 1), image_compare_flat(3, 3, 1), 0.5),
               std::invalid_argument);
}

TEST(UnitImageCompare, Names) {
  for (const Grade g : {Grade::fails, Grade::close, Grade::noise, Grade::match, Grade::exact}) {
    EXPECT_EQ(grade_named(name_of(g)), g);
  }
  EXPECT_FALSE(grade_named("good"));
}

}  // namespace
}  // namespace lentray::core
