// The enumeration against pixel after pixel in the real orders, and against what the paper says.
#include "shadow/hit_model/enumeration.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "shadow/hit_model/ideal_orders.h"
#include "shadow/hit_model/runs.h"
#include "shadow/pixel_orders.h"
#include "tests/unit/shadow/paper_sheet.h"

using namespace lentray;
using lentray::test::sheet_of;
using shadow::Enumeration;
using shadow::PaperSheet;
using shadow::ShadowSquare;
using shadow::Style;
using Kind = shadow::Style::Kind;

namespace {

std::vector<core::Pixel> pixels_of(const core::PixelOrder& order) {
  std::vector<core::Pixel> all, job;
  for (std::size_t j = 0; j < order.jobs(); ++j) {
    order.pixels(j, job);
    all.insert(all.end(), job.begin(), job.end());
  }
  return all;
}

/// Pixel after pixel, each judged by the lens's own formulae.
std::uint64_t longest_run(const PaperSheet& sheet, const Enumeration& edges, double distance,
                          const core::PixelOrder& order) {
  std::uint64_t run = 0, longest = 0;
  for (const core::Pixel p : pixels_of(order)) {
    const camera::LensColumn& c = sheet.columns().column(p.column);
    if (c.dark) continue;
    const double x = c.axis + distance * c.slope;
    const double y = ((p.row + 0.5) / sheet.rows() - 0.5) * sheet.height();
    const bool hit =
        x >= edges.left() && x <= edges.right() && y >= edges.top() && y <= edges.bottom();
    run = hit ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  return longest;
}

std::unique_ptr<core::PixelOrder> order_of(const PaperSheet& sheet, const Enumeration& shadow,
                                           const Style& style) {
  if (style.is_ideal() && (style.kind == Kind::kCombined || style.kind == Kind::kStrips)) {
    return shadow::make_ideal_orders(shadow, style.kind, 0, sheet.width(), 0)
        ->band(0, sheet.rows());
  }
  return shadow::make_order(style.name(), {0, 0, sheet.width(), sheet.rows()}, &sheet.columns());
}

std::vector<Style> all_styles() {
  std::vector<Style> styles = shadow::paper_styles();
  for (const std::uint32_t w : {1u, 2u, 3u, 4u, 100u}) {
    styles.push_back({Kind::kCombined, w, 1});
    for (const std::uint32_t h : {1u, 4u, 7u, 100u}) styles.push_back({Kind::kStrips, w, h});
  }
  return styles;
}

TEST(UnitShadowEnumeration, PixelAfterPixel) {
  std::mt19937 random(5);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const std::vector<PaperSheet> sheets{sheet_of(5, 7, 23), sheet_of(1, 11, 8), sheet_of(3.7, 6, 16),
                                       sheet_of(6, 5, 30, 1.0), sheet_of(8, 4, 12, 1.8, 6.0)};
  EXPECT_GT(sheets.back().columns().dark_columns(), 0u);
  std::size_t nothing = 0, everything = 0;
  for (int i = 0; i < 200; ++i) {
    const PaperSheet& sheet = sheets[static_cast<std::size_t>(i) % sheets.size()];
    const double size = sheet.columns().sheet_width();
    // From nothing to more than all of the sheet.
    const ShadowSquare square{between(0.01, 1.5 * size),
                              i % 7 == 0 ? 0.0 : between(0.0, 3.0 * size),
                              between(-size, 0.5 * size), between(-size, 0.5 * size)};
    const Enumeration shadow(sheet, square);
    if (shadow.blocked() == 0) ++nothing;
    if (shadow.blocked() == shadow.rays()) ++everything;
    for (const Style& style : all_styles()) {
      EXPECT_EQ(shadow.continuous_hits(style),
                longest_run(sheet, shadow, square.distance, *order_of(sheet, shadow, style)))
          << style.name() << " A = " << square.size << " D = " << square.distance;
    }
  }
  EXPECT_GT(nothing, 5u);
  EXPECT_LT(nothing, 100u);
}

TEST(UnitShadowEnumeration, ShadowOverEverything) {
  const PaperSheet sheet = sheet_of(5, 7, 23);
  const Enumeration shadow(sheet, {1000, 5, -500, -500});
  EXPECT_EQ(shadow.blocked(), 35u * 23u);
  for (const Style& style : all_styles()) EXPECT_EQ(shadow.continuous_hits(style), 35u * 23u);
}

TEST(UnitShadowEnumeration, RunsPutTogether) {
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    shadow::Runs sum;
    std::uint64_t run = 0, longest = 0, rays = 0;
    for (int part = 0; part < 6; ++part) {
      shadow::Runs one;
      for (unsigned n = random() % 4; n > 0; --n) {
        const bool blocked = random() % 3 != 0;
        one += blocked ? shadow::Runs::blocked(1) : shadow::Runs::open(1);
        run = blocked ? run + 1 : 0;
        longest = std::max(longest, run);
        ++rays;
      }
      sum += one;
    }
    ASSERT_EQ(sum.longest, longest);
    ASSERT_EQ(sum.length, rays);
    ASSERT_EQ(sum.last, run);
  }
}

TEST(UnitShadowEnumeration, TheSixRaysOfFigures18To21) {
  // Five pixels a lens; at D = 5 f without refraction neighbouring rays of a lens are P apart. The
  // shadow holds three rays of the first lens, two of the second, one of the third, none of the
  // fourth.
  const PaperSheet sheet = sheet_of(5, 4, 9, 1.0);
  const double p = 1.124;
  const Enumeration shadow(sheet, {3 * p, 5 * 3.03, -4 * p, -0.5 * p});
  EXPECT_EQ(shadow.blocked_columns(), 6u);
  EXPECT_EQ(shadow.continuous_hits({Kind::kRows}), 3u) << "three out of six (figure 19)";
  EXPECT_EQ(shadow.continuous_hits({Kind::kViews}), 3u) << "three (figure 20)";
  EXPECT_EQ(shadow.continuous_hits({Kind::kCombined}), 6u) << "all (figure 21)";
  EXPECT_EQ(shadow.continuous_hits({Kind::kStrips}), 6u * shadow.blocked_rows());
}

TEST(UnitShadowEnumeration, SixBySixIs36) {
  // Section 4.2: six pixels across, six down; combined and vertical styles give 6, both 36.
  const PaperSheet sheet = sheet_of(6, 5, 30);
  const double pixel = sheet.pixel();
  const Enumeration shadow(sheet, {6 * pixel, 0, -3 * pixel, -3 * pixel});
  EXPECT_EQ(shadow.blocked_columns(), 6u);
  EXPECT_EQ(shadow.blocked_rows(), 6u);
  EXPECT_EQ(shadow.continuous_hits({Kind::kCombined}), 6u);
  EXPECT_EQ(shadow.continuous_hits({Kind::kColumns}), 6u);
  EXPECT_EQ(shadow.continuous_hits({Kind::kStrips}), 36u);
}

class UnitShadowPaperSheet : public ::testing::Test {
 protected:
  std::uint64_t hits(Kind kind, double a, double d, double x = 0.3) const {
    return Enumeration(m_sheet, {a, d, x, x}).continuous_hits({kind});
  }
  const PaperSheet m_sheet = sheet_of(15, 133, 0);
};

TEST_F(UnitShadowPaperSheet, Size) {
  EXPECT_EQ(m_sheet.width(), 1995u);
  EXPECT_EQ(m_sheet.rows(), 1995u);
  EXPECT_NEAR(m_sheet.height(), 133 * 1.124, 1e-9);
}

TEST_F(UnitShadowPaperSheet, StyleTwoHasTheLensesOfAViewUpToOneMoreThanEquation16) {
  EXPECT_EQ(hits(Kind::kViews, 20, 13), 18u) << "A/P = 17.79";
  for (double a = 0.5; a < 40; a += 0.7) {
    for (double d = 0; d < 40; d += 3.1) {
      const double whole = std::floor(a / 1.124);
      EXPECT_GE(hits(Kind::kViews, a, d), whole);
      EXPECT_LE(hits(Kind::kViews, a, d), whole + 1);
    }
  }
}

TEST_F(UnitShadowPaperSheet, CombinedHardlyDependsOnDistance) {
  // Each view is a lattice of parallel rays P apart, so it hits floor(A/P) times or once more,
  // however far the shadow is. Figures 14 and 16 fall with D.
  for (double a = 0.5; a < 40; a += 1.3) {
    for (double d = 0; d < 40; d += 1.7) {
      const double whole = std::floor(a / 1.124);
      EXPECT_GE(hits(Kind::kCombined, a, d), 15 * whole);
      EXPECT_LE(hits(Kind::kCombined, a, d), 15 * (whole + 1));
    }
  }
}

TEST_F(UnitShadowPaperSheet, StyleThreeIsIndependentOfDistance) {
  for (double d = 0; d < 40; d += 7)
    EXPECT_EQ(hits(Kind::kColumns, 20, d), hits(Kind::kColumns, 20, 0));
  EXPECT_EQ(hits(Kind::kColumns, 20, 0), 266u) << "A/ps = 266.9";
}

TEST_F(UnitShadowPaperSheet, StyleOneOnTheSheetIsAStaircaseOfWholeLenses) {
  for (double a = 0.5; a < 40; a += 0.3) EXPECT_EQ(hits(Kind::kRows, a, 0) % 15, 0u);
  EXPECT_EQ(hits(Kind::kRows, 20, 0), 18u * 15u) << "the text claims A/ps = 266";
}

TEST_F(UnitShadowPaperSheet, TwoDimensionalIsTheProduct) {
  for (const double a : {0.7, 3.0, 20.0}) {
    EXPECT_EQ(hits(Kind::kStrips, a, 13),
              hits(Kind::kCombined, a, 13) * hits(Kind::kColumns, a, 13));
  }
}

TEST_F(UnitShadowPaperSheet, TheClosedFormsAreTheEquations) {
  const ShadowSquare square{1.2, 13, 0.3, 0.3};
  const auto closed = [&](Kind kind) {
    return shadow::closed_form(m_sheet, square, {kind}, shadow::paper::Alpha::kPrinted).hits;
  };
  EXPECT_EQ(closed(Kind::kRows), 3u);
  EXPECT_EQ(closed(Kind::kViews), 1u);
  EXPECT_EQ(closed(Kind::kColumns), 16u);
  EXPECT_EQ(closed(Kind::kCombined), 20u);
  EXPECT_EQ(closed(Kind::kStrips), 320u);
  EXPECT_FALSE(
      shadow::closed_form(m_sheet, square, {Kind::kCombined, 4, 1}, shadow::paper::Alpha::kPrinted)
          .exists);
}

TEST(UnitShadowEnumeration, EdgesKeepOffTheRays) {
  EXPECT_EQ(shadow::clear_edge({1.0, 2.0}, 1.5, 1), 1.5);
  EXPECT_NEAR(shadow::clear_edge({1.0, 2.0}, 1.0 + 1e-10, 1), 1.0, 2e-9);
  EXPECT_GE(shadow::clear_edge({1.0, 2.0}, 1.0 + 1e-10, 1), 1.0 + 1e-9);
  EXPECT_LE(shadow::clear_edge({1.0, 2.0}, 1.0 + 1e-10, -1), 1.0 - 1e-9);
  EXPECT_GE(shadow::clear_edge({1.0, 1.0 + 1e-9, 1.0 + 2e-9}, 1.0, 1), 1.0 + 3e-9);
  // On the sheet, a shadow from one lens's axis to the next's holds both, whatever rounding says.
  const PaperSheet sheet = sheet_of(5, 7, 20);
  const Enumeration shadow(sheet, {2 * 1.124, 0, 0, 0});
  EXPECT_EQ(shadow.blocked_columns(), 15u);
}

TEST(ErrorShadowEnumeration, NoSheetAndNoShadow) {
  camera::LensParameters finite;
  finite.view_distance = 500;
  EXPECT_THROW(PaperSheet(finite, 10), std::invalid_argument);
  camera::LensParameters none;
  none.pitch = 0;
  EXPECT_THROW(PaperSheet(none, 10), std::invalid_argument);
  EXPECT_THROW(PaperSheet(camera::LensParameters{}, 0), std::invalid_argument);
  const PaperSheet sheet = sheet_of(5, 3, 9);
  EXPECT_THROW(Enumeration(sheet, {0, 1, 0, 0}), std::invalid_argument);
  EXPECT_THROW(Enumeration(sheet, {1, -1, 0, 0}), std::invalid_argument);
}

}  // namespace
