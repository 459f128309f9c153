// What is said of a max_gradient, at the borders where stock 3.7 begins to: found with functions of
// one slope (k z) seen along z. compat.warnings holds both programs to each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/numeric/slope_watch.h"
#include "core/shape/isosurface.h"

namespace lentray::core {
namespace {

std::string advice(double slope, double max_gradient) {
  SlopeWatch watch(max_gradient);
  watch.note(slope);
  return watch.advice();
}

bool has_holes(const std::string& text) { return text.find("holes") != std::string::npos; }

TEST(UnitCoreSlopeWatch, SaysThatMaxGradientIsTooSmall) {
  struct Border {
    double slope, warned, silent;
  };
  // stock: bisected; below 10 a twentieth of the slope, at most 0.1, from 10 on a tenth
  for (const Border& b :
       {Border{0.1, 0.0949, 0.0951}, Border{1.0, 0.949, 0.951}, Border{2.0, 1.899, 1.901},
        Border{5.0, 4.899, 4.901}, Border{10.0, 9.899, 9.901}, Border{11.0, 9.999, 10.001},
        Border{12.0, 10.79, 10.81}, Border{50.0, 44.99, 45.01}}) {
    EXPECT_TRUE(has_holes(advice(b.slope, b.warned))) << b.slope;
    EXPECT_EQ(advice(b.slope, b.silent), "") << b.slope;
  }
}

TEST(UnitCoreSlopeWatch, SaysThatMaxGradientIsLarge) {
  struct Border {
    double slope, warned, silent;
  };
  for (const Border& b :
       {Border{0.01, 0.511, 0.509}, Border{1.0, 1.501, 1.499}, Border{4.0, 4.501, 4.499},
        Border{5.0, 5.502, 5.499}, Border{9.0, 9.903, 9.899}, Border{50.0, 55.01, 54.99}}) {
    const std::string text = advice(b.slope, b.warned);
    EXPECT_FALSE(text.empty() || has_holes(text)) << b.slope << text;
    EXPECT_EQ(advice(b.slope, b.silent), "") << b.slope;
  }
}

TEST(UnitCoreSlopeWatch, KeepsTheSteepestOfAllThreads) {
  SlopeWatch watch(1.0);
  EXPECT_EQ(watch.advice(), "") << "nothing was seen";
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&watch, t] {
      for (int i = 0; i < 1000; ++i) watch.note(i * 4 + t);
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(watch.steepest(), 3999.0);
  EXPECT_NE(watch.advice().find("3999.000"), std::string::npos);
}

struct Bowl final : Function {
  std::size_t parameters() const override { return 3; }
  double evaluate(std::span<const double> a) const override {
    return a[2] + 0.3 * a[0] * a[0] + std::sin(3.0 * a[1]);
  }
};

/// Of rays along z that lean by `lean`, one after the other, of these lengths.
double steepest(const std::vector<double>& leans, double length) {
  IsosurfaceSettings set;
  set.function = std::make_shared<Bowl>();
  set.max_gradient = 5.0;
  Isosurface surface(set);
  const auto watch = std::make_shared<SlopeWatch>(set.max_gradient);
  surface.set_watch(watch);
  for (const double lean : leans) {
    ShapeHit hit;
    surface.nearest({{-3.0 * lean, -3.0 * lean, 3.0}, Vec3{lean, lean, -1.0} * length}, 0.0, 1e9,
                    hit);
  }
  return watch->steepest();
}

TEST(UnitCoreSlopeWatch, IsToldTheSteepestWhateverRayComesFirst) {
  for (const double length : {1.0, 0.01}) {
    const double a = steepest({0.0}, length), b = steepest({0.1}, length),
                 c = steepest({0.3}, length);
    EXPECT_TRUE(a != b && b != c && a != c);
    for (const std::vector<double>& leans : std::vector<std::vector<double>>{
             {0.0, 0.1, 0.3}, {0.3, 0.1, 0.0}, {0.1, 0.3, 0.3, 0.0, 0.1}, {0.3, 0.0, 0.1}}) {
      EXPECT_EQ(steepest(leans, length), std::max({a, b, c}));
    }
  }
}

}  // namespace
}  // namespace lentray::core
