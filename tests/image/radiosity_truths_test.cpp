// Indirect light beside truths that need no stock: form factors and two patches that face each other. With as many
// rays stock may not be nearer to the truth.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr double kRounding = 1.0 / 65535.0;
constexpr int kCounts[] = {35, 100, 400, 1600};

/// Of a rectangle parallel to a point's plane, one corner straight above it: its sides, by its height.
double radiosity_truth_corner(double a, double b) {
  const double p = std::hypot(1.0, a), q = std::hypot(1.0, b);
  return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2.0 * std::numbers::pi);
}

/// Of the square -1 .. 1, at height 1 above the point (x, z).
double radiosity_truth_factor(double x, double z) {
  return radiosity_truth_corner(1 - x, 1 - z) + radiosity_truth_corner(1 - x, 1 + z) +
         radiosity_truth_corner(1 + x, 1 - z) + radiosity_truth_corner(1 + x, 1 + z);
}

/// What returns to (x, z) of the square's own light by way of the square above, for reflectances of 1: the integral over that square
/// of both form factors, by Simpson's rule.
double radiosity_truth_returned(double x, double z) {
  constexpr int kSteps = 40;
  double sum = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const auto weight = [](int k) {
        return k == 0 || k == kSteps ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
      };
      const double s = 2.0 * i / kSteps - 1.0, t = 2.0 * j / kSteps - 1.0;
      const double square = 1.0 + (x - s) * (x - s) + (z - t) * (z - t);
      sum += weight(i) * weight(j) * radiosity_truth_factor(s, t) /
             (std::numbers::pi * square * square);
    }
  }
  const double step = 2.0 / kSteps;
  return sum * step * step / 9.0;
}

SceneText radiosity_truth_scene(const std::string& settings, const std::string& objects,
                                std::uint32_t size) {
  SceneText scene;
  scene.sdl =
      "#version 3.7; global_settings { assumed_gamma 1 radiosity { " + settings +
      " } }\n#default { finish { ambient 0 diffuse 1 } }\n"
      "#declare Patch = polygon { 5, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1> rotate 90*x }\n" +
      objects;
  scene.width = scene.height = size;
  scene.bits = 16;
  scene.arguments = {"File_Gamma=1.0"};
  return scene;
}

/// Mean square of what the picture is off the truth, a function of pixel and channel.
template <class Truth>
double radiosity_truth_error(const StoredImage& picture, const Truth& truth) {
  double squares = 0.0;
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double off = picture.at(x, y, c) / 65535.0 - truth(x, y, c);
        squares += off * off;
      }
    }
  }
  return squares / static_cast<double>(picture.samples.size());
}

/// A floor below a square that glows, turned about the middle: its directions meet the square's edges anew.
SceneText radiosity_truth_square(int count, int turn) {
  return radiosity_truth_scene(
      "count " + std::to_string(count) +
          " error_bound 0.1 recursion_limit 1 pretrace_start 0.5 pretrace_end 0.125 "
          "minimum_reuse 0.001",
      "camera { orthographic location 0.5*y direction -0.5*y up 0.02*z right 0.02*x }\n"
      "plane { y, 0 pigment { rgb 1 } }\nobject { Patch rotate " +
          std::to_string(turn) +
          "*y translate y pigment { rgb 1 } finish { emission 1 diffuse 0 } }\n",
      4);
}

TEST(ImageRadiosityTruths, FormFactorOfASquareOverhead) {
  const double factor = radiosity_truth_factor(0.0, 0.0);
  EXPECT_NEAR(factor, 0.554126, 1e-6);
  const auto truth = [&](std::uint32_t, std::uint32_t, int) { return factor; };
  for (const int count : kCounts) {
    double ours = 0.0, stocks = 0.0;
    for (const int turn : {0, 30, 60}) {
      const SceneText scene = radiosity_truth_square(count, turn);
      ours += radiosity_truth_error(lentray_render(scene), truth) / 3.0;
      stocks += radiosity_truth_error(stock_render(scene), truth) / 3.0;
    }
    EXPECT_LE(std::sqrt(ours), std::sqrt(stocks) + kRounding) << count << " rays";
    EXPECT_LT(std::sqrt(ours), 0.15 / std::sqrt(count)) << count << " rays";
  }
}

/// A grey patch that glows, and a red one above it: what comes back is red.
SceneText radiosity_truth_patches(int count) {
  return radiosity_truth_scene(
      "count " + std::to_string(count) +
          " error_bound 0.3 recursion_limit 2 pretrace_start 0.25 pretrace_end 0.0625 "
          "minimum_reuse 0.01",
      "camera { orthographic location 0.5*y direction -0.5*y up 1.8*z right 1.8*x }\n"
      "object { Patch pigment { rgb 0.5 } finish { emission 1 } }\n"
      "object { Patch translate y pigment { rgb <0.9, 0.3, 0.1> } }\n",
      18);
}

TEST(ImageRadiosityTruths, ColourBleedingOfTwoFacingPatches) {
  constexpr std::uint32_t kSize = 18;
  constexpr double kAbove[] = {0.9, 0.3, 0.1};
  std::vector<double> returned;
  double mean = 0.0;  // of the square of what is to be seen
  for (std::uint32_t i = 0; i < kSize * kSize; ++i) {
    const auto place = [](std::uint32_t k) { return ((k + 0.5) / kSize - 0.5) * 1.8; };
    returned.push_back(0.25 * radiosity_truth_returned(place(i % kSize), -place(i / kSize)));
    for (const double above : kAbove)
      mean += std::pow(returned.back() * above, 2.0) / (3.0 * kSize * kSize);
  }
  EXPECT_NEAR(radiosity_truth_returned(0.0, 0.0), 0.251774, 1e-6);
  const auto truth = [&](std::uint32_t x, std::uint32_t y, int c) {
    return 0.5 + returned[y * kSize + x] * kAbove[c];
  };
  for (const int count : kCounts) {
    const SceneText scene = radiosity_truth_patches(count);
    const double ours = std::sqrt(radiosity_truth_error(lentray_render(scene), truth) / mean);
    const double stocks = std::sqrt(radiosity_truth_error(stock_render(scene), truth) / mean);
    EXPECT_LE(ours, stocks + kRounding / std::sqrt(mean)) << count << " rays";
    EXPECT_LT(ours, 0.5 / std::sqrt(count) + 0.015) << count << " rays";
  }
}

}  // namespace
}  // namespace lentray::test
