// The paper's equations against numbers of its text and against each other.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shadow/hit_model/equations.h"

using namespace lentray;
using namespace lentray::shadow::paper;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// The paper's lens, N = 15.
camera::LensParameters lens() { return {}; }

camera::LensParameters lens_of(double pixels) {
  camera::LensParameters out;
  out.pixels = pixels;
  return out;
}

/// The paper's sheet of 133 lenses, its middle the origin.
Across across(double size, double distance, double start = 0.3) {
  return {-66.0 * 1.124, 133, start, size, distance};
}

TEST(UnitShadowEquations, AnglesOfALens) {
  EXPECT_NEAR(fan_angle(lens(), Alpha::kPrinted) / kDegree, 21.02, 0.005);    // (6)
  EXPECT_NEAR(fan_angle(lens(), Alpha::kRefracted) / kDegree, 33.93, 0.005);  // (6) with n
  EXPECT_NEAR(ray_angle(fan_angle(lens(), Alpha::kPrinted), 15) / kDegree, 1.401, 1e-4);  // (7)
  EXPECT_NEAR(shadow_angle(20, 13) / kDegree, 56.976, 1e-3);                              // (8)
  EXPECT_DOUBLE_EQ(shadow_angle(20, 0), std::numbers::pi / 2);
  camera::LensParameters flat = lens();
  flat.ior = 1.0;
  EXPECT_DOUBLE_EQ(fan_angle(flat, Alpha::kRefracted), fan_angle(flat, Alpha::kPrinted));
  camera::LensParameters wide = lens();
  wide.pitch = 2.0 * 3.03;  // the edge is totally reflected
  EXPECT_DOUBLE_EQ(fan_angle(wide, Alpha::kRefracted), std::numbers::pi);
}

TEST(UnitShadowEquations, HitsInALens) {
  const double beta = ray_angle(fan_angle(lens(), Alpha::kPrinted), 15);
  EXPECT_EQ(hits_by_angles(shadow_angle(1.2, 13), beta), 3u);  // (9): gaps; up to 4 rays hit
  EXPECT_EQ(hits_by_angles(shadow_angle(20, 13), beta), 40u) << "(9) has no bound";
  EXPECT_EQ(hits_in_lens(lens(), 20, 13, Alpha::kPrinted), 15u) << "(10), at most N";
  EXPECT_EQ(hits_in_lens(lens(), 1.2, 13, Alpha::kPrinted), 3u);
  EXPECT_EQ(hits_in_lens(lens(), 1.2, 13, Alpha::kRefracted), 2u);
  EXPECT_EQ(hits_in_lens(lens(), 0.1, 13, Alpha::kPrinted), 0u) << "theta < beta";
  // (10) is (9) with (6) and (8) put in.
  for (const double a : {0.5, 1.0, 2.0, 4.0}) {
    const double ratio = 15 * std::atan(a / 13) / (2 * std::atan(15 * (1.124 / 15) / (2 * 3.03)));
    EXPECT_EQ(hits_in_lens(lens(), a, 13, Alpha::kPrinted),
              static_cast<std::uint64_t>(std::floor(ratio)));
  }
  EXPECT_EQ(hits_in_lens(lens(), 0.001, 0, Alpha::kPrinted), 15u) << "D = 0: all of a lens";
}

TEST(UnitShadowEquations, CrossingToTheNextLens) {
  // tan(alpha/2) = P / 2f.
  const double half = 13 * 1.124 / 6.06;
  EXPECT_NEAR(first_place(lens(), -74.184, 66, 13, Alpha::kPrinted), -half, 1e-12);  // (11)
  EXPECT_NEAR(last_place(lens(), -74.184, 66, 13, Alpha::kPrinted), half, 1e-12);
  EXPECT_NEAR(first_place(lens(), 0, 3, 0, Alpha::kPrinted), 3 * 1.124, 1e-12);
  EXPECT_TRUE(crosses(-1.9, 3.0, 5.0));  // (12)
  EXPECT_FALSE(crosses(-2.1, 3.0, 5.0));
  EXPECT_EQ(crossing_status(-1.9, -2.0), 1);  // (13)
  EXPECT_EQ(crossing_status(-2.1, -2.0), 0);
  EXPECT_EQ(hits_with_crossing(3, 1, 15), 4u);  // (14)
  EXPECT_EQ(hits_with_crossing(3, 0, 15), 3u);
  EXPECT_EQ(hits_with_crossing(15, 1, 15), 15u) << "a lens has no sixteenth ray";
}

TEST(UnitShadowEquations, StyleOne) {
  // (15) at D = 0: whole lenses only, those whose axis lies in the shadow and one more, for (13)
  // does not ask whether the next lens's first ray is still before the shadow's end.
  for (const double a : {1.0, 3.0, 10.0, 20.0}) {
    const double lenses = std::floor((0.3 + a) / 1.124) - std::floor(0.3 / 1.124);
    EXPECT_EQ(style1_hits(lens(), across(a, 0), Alpha::kPrinted), 15 * (lenses + 1)) << a;
  }
  // Within the first lens, theta < alpha and nothing crossed: (10) alone.
  EXPECT_EQ(style1_hits(lens(), across(1.2, 13), Alpha::kPrinted), 3u);
  // "When A is varied by P, ... CChit jumps by one step", which is N.
  std::uint64_t before = style1_hits(lens(), across(10.0, 13), Alpha::kPrinted);
  for (int i = 1; i < 10; ++i) {
    const std::uint64_t next = style1_hits(lens(), across(10.0 + 1.124 * i, 13), Alpha::kPrinted);
    EXPECT_EQ(next - before, 15u);
    before = next;
  }
  // "... stops at the first lens not crossed into": the sheet's last.
  EXPECT_EQ(style1_hits(lens(), across(40, 0, 74.184 - 0.1), Alpha::kPrinted), 15u);
}

TEST(UnitShadowEquations, OtherStyles) {
  EXPECT_EQ(style2_hits(lens(), 20), 17u) << "(16): A/P = 17.79";
  EXPECT_EQ(style2_hits(lens(), 3 * 1.124), 3u) << "whole but for rounding";
  EXPECT_EQ(style2_hits(lens(), 1.0), 0u);
  EXPECT_EQ(style3_hits(lens(), 20), 266u) << "(18): A/ps = 266.9";
  // "P/ps could be 10, 20 or bigger".
  EXPECT_EQ(style3_hits(lens(), 1.124), 15u);
  EXPECT_EQ(style3_hits(lens_of(20), 1.124), 20u);
  // The top of figure 10's axis, 180: A/ps at A = 20 with ten pixels a lens, not with fifteen.
  EXPECT_EQ(style3_hits(lens_of(10), 20), 177u);
}

TEST(UnitShadowEquations, CombinedStyles) {
  // D = 0: each lens whose axis lies in the shadow sees nothing else.
  EXPECT_EQ(lenses_that_see(lens(), across(20, 0), Alpha::kPrinted), 18u);
  EXPECT_EQ(combined_hits(lens(), across(20, 0), Alpha::kPrinted), 18u * 15u);  // (17)
  // A lens's fan is D P/f wide: at D = 13 4.82 mm.
  EXPECT_EQ(lenses_that_see(lens(), across(1.2, 13), Alpha::kPrinted), 5u);
  EXPECT_EQ(combined_hits(lens(), across(1.2, 13), Alpha::kPrinted), 5u * (3u + 1u));
  EXPECT_EQ(two_dimensional_hits(lens(), across(1.2, 13), 1.2, Alpha::kPrinted),  // (19)
            combined_hits(lens(), across(1.2, 13), Alpha::kPrinted) * style3_hits(lens(), 1.2));
  // Equation 19's example, "6 pixels in the horizontal direction and 6 in the vertical": 36.
  const camera::LensParameters paper = lens();
  const double six = 6 * paper.pixel_size();
  const Across near = across(six, 0, -0.5 * six);
  EXPECT_EQ(style3_hits(paper, six), 6u);
  EXPECT_EQ(two_dimensional_hits(paper, near, six, Alpha::kPrinted),
            combined_hits(paper, near, Alpha::kPrinted) * 6u);
}

}  // namespace
