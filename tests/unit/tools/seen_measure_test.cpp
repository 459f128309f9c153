// What an eye sees through a lens sheet (lentray-diff --seen), against a second evaluation that
// shares no line with the first: it asks every column and every row of the picture for its weight.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

#include "tools/lentray-diff/eye_measure.h"

namespace lentray::diff {
namespace {

using SeenLight = std::function<double(int column, int row)>;

LightPlane seen_test_plane(std::uint32_t width, std::uint32_t height, const SeenLight& light) {
  LightPlane out{width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      out.values.push_back(static_cast<float>(light(static_cast<int>(x), static_cast<int>(y))));
    }
  }
  return out;
}

/// Stripes, an edge and a gradient, different behind each lens.
double seen_test_light(double column, double row) {
  const double wave = std::sin(0.7 * column + 0.31 * row) * std::cos(0.05 * column - 0.9 * row);
  const double edge = column > 31.0 + 0.4 * row ? 0.3 : 0.0;
  return 0.3 + 0.25 * wave + edge * 0.7 + 0.001 * row;
}

struct SeenCase {
  double pixels;  // a lens
  EyeBeforePrint eye;
  std::uint32_t width, height;
};
const SeenCase kSeenCases[] = {
    {15.0, {600.0, 400.0, 1.0}, 90, 40},   {15.02, {600.0, 400.0, 1.0}, 90, 40},
    {7.49, {300.0, 400.0, 1.0}, 60, 30},   {12.011, {720.0, 400.0, 1.0}, 80, 40},
    {15.02, {1200.0, 250.0, 1.0}, 77, 50}, {30.3, {600.0, 900.0, 0.6}, 100, 40},
    {1.5, {300.0, 300.0, 2.0}, 20, 30},
};

/// The light of one place, by the definition: no window, every pixel has its say.
double seen_by_definition(const SeenCase& c, const SeenLight& light, int lens, double part,
                          int row) {
  const double half = std::fmax(1.0, 2.0 * c.pixels / 15.0), x = (lens + part) * c.pixels;
  const double deviation = c.eye.distance / 25.4 * c.eye.rows_an_inch *
                           std::tan(c.eye.arc_minutes * M_PI / 10800.0) /
                           std::sqrt(8.0 * std::log(2.0));
  double sum = 0.0, weights = 0.0;
  for (int y = 0; y < static_cast<int>(c.height); ++y) {
    const double down = 0.5 * std::erf((y - row + 0.5) / deviation / std::sqrt(2.0)) -
                        0.5 * std::erf((y - row - 0.5) / deviation / std::sqrt(2.0));
    for (int k = 0; k < static_cast<int>(c.width); ++k) {
      if (k + 0.5 < lens * c.pixels || k + 0.5 >= (lens + 1) * c.pixels) continue;
      const double across = half - std::fabs(k + 0.5 - x);
      if (across <= 0.0) continue;
      sum += across * down * light(k, y);
      weights += across * down;
    }
  }
  return sum / weights;
}

double seen_lightness(double y) {
  return y > 0.008856 ? 116.0 * std::pow(y, 1.0 / 3.0) - 16.0 : 903.2963 * y;
}

struct SeenFigures {
  double rms = 0.0, bias = 0.0, largest = 0.0, within_99 = 0.0;
};
/// By the definition, of two pictures.
SeenFigures figures_by_definition(const SeenCase& c, const EyeMeasure& measure, const SeenLight& a,
                                  const SeenLight& b) {
  std::vector<double> all;
  for (const double part : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    for (std::uint32_t lens = 0; lens < measure.lenses(); ++lens) {
      for (std::uint32_t row = 0; row < measure.rows(); ++row) {
        const int i = static_cast<int>(lens), y = static_cast<int>(row + measure.first_row());
        all.push_back(seen_lightness(seen_by_definition(c, b, i, part, y)) -
                      seen_lightness(seen_by_definition(c, a, i, part, y)));
      }
    }
  }
  SeenFigures out;
  for (const double d : all) {
    out.rms += d * d / static_cast<double>(all.size());
    out.bias += d / static_cast<double>(all.size());
    out.largest = std::fmax(out.largest, std::fabs(d));
  }
  out.rms = std::sqrt(out.rms);
  for (double& d : all) d = std::fabs(d);
  std::sort(all.begin(), all.end());
  const auto beyond = static_cast<std::size_t>(static_cast<double>(all.size()) * 0.01);
  out.within_99 = all[all.size() - 1 - beyond];
  return out;
}

SeenDifferences seen_between(const EyeMeasure& measure, const LightPlane& a, const LightPlane& b) {
  std::vector<LightPlane> first, second;
  for (const double part : kSeenParts) {
    first.push_back(measure.seen(a, part));
    second.push_back(measure.seen(b, part));
  }
  return seen_differences(measure, first, second);
}

EyeMeasure seen_measure(const SeenCase& c) { return {{c.pixels, {}}, c.eye, c.width, c.height}; }

/// Compares the measure with the definition, where the second picture is made of the first one's
/// light. Returns the RMS.
double expect_by_definition(const SeenCase& c, const SeenLight& other) {
  const EyeMeasure measure = seen_measure(c);
  const auto a = seen_test_plane(c.width, c.height, seen_test_light);
  const auto b = seen_test_plane(c.width, c.height, other);
  const SeenDifference got = seen_between(measure, a, b).all;
  const SeenFigures wanted = figures_by_definition(c, measure, seen_test_light, other);
  // The measure leaves out rows beyond four standard deviations, 6e-5 of the light.
  EXPECT_NEAR(got.rms, wanted.rms, 0.003) << c.pixels;
  EXPECT_NEAR(got.bias, wanted.bias, 0.003) << c.pixels;
  EXPECT_NEAR(got.largest, wanted.largest, 0.01) << c.pixels;
  EXPECT_NEAR(got.within_99, wanted.within_99, 0.01) << c.pixels;
  EXPECT_EQ(got.points, std::size_t{5} * measure.lenses() * measure.rows());
  return got.rms;
}

TEST(UnitSeenMeasure, APictureIsSeenByTheDefinition) {
  for (const SeenCase& c : kSeenCases) {
    const EyeMeasure measure = seen_measure(c);
    const auto plane = seen_test_plane(c.width, c.height, seen_test_light);
    EXPECT_EQ(measure.lenses(), static_cast<std::uint32_t>((c.width + 0.5) / c.pixels));
    for (const double part : kSeenParts) {
      const LightPlane seen = measure.seen(plane, part);
      for (std::uint32_t lens = 0; lens < seen.width; ++lens) {
        for (std::uint32_t row = 0; row < seen.height; row += 3) {
          const double wanted = seen_by_definition(c, seen_test_light, static_cast<int>(lens), part,
                                                   static_cast<int>(row + measure.first_row()));
          ASSERT_NEAR(seen.at(lens, row), wanted, 1e-4) << c.pixels << " " << part << " " << lens;
        }
      }
    }
  }
}

TEST(UnitSeenMeasure, EqualSheetsDoNotDiffer) {
  for (const SeenCase& c : kSeenCases) {
    const EyeMeasure measure = seen_measure(c);
    const auto plane = seen_test_plane(c.width, c.height, seen_test_light);
    const SeenDifferences same = seen_between(measure, plane, plane);
    EXPECT_EQ(same.all.rms, 0.0);
    EXPECT_EQ(same.all.largest, 0.0);
    EXPECT_EQ(same.all.within_99, 0.0);
    EXPECT_EQ(same.parts.size(), kSeenParts.size());
  }
}

TEST(UnitSeenMeasure, ASheetMovedByAViewDiffers) {
  for (const SeenCase& c : kSeenCases) {
    const double rms = expect_by_definition(
        c, [](int column, int row) { return seen_test_light(column + 1, row); });
    EXPECT_GT(rms, 1.0) << c.pixels;
  }
}

TEST(UnitSeenMeasure, ASheetMovedByARowDiffers) {
  for (const SeenCase& c : kSeenCases) {
    const double rms = expect_by_definition(
        c, [](int column, int row) { return seen_test_light(column, row - 1); });
    EXPECT_GT(rms, 0.2) << c.pixels;
  }
}

TEST(UnitSeenMeasure, RowsThatTheEyeBlendsAnywayHardlyDiffer) {
  const auto blurred = [](int column, int row) {
    double sum = 0.0;
    for (int y = -1; y <= 1; ++y) sum += seen_test_light(column, row + y) / 3.0;
    return sum;
  };
  for (const SeenCase& c : kSeenCases) {
    const double rms = expect_by_definition(c, blurred);
    const double moved = expect_by_definition(
        c, [](int column, int row) { return seen_test_light(column, row - 1); });
    EXPECT_LT(rms, moved) << c.pixels;
  }
}

TEST(UnitSeenMeasure, NoiseIsAveraged) {
  for (const SeenCase& c : kSeenCases) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0.0, 0.01);
    std::vector<double> noise(std::size_t{c.width} * c.height);
    for (double& value : noise) value = normal(random);
    const auto noisy = [&](int column, int row) {
      return seen_test_light(column, row) +
             noise[static_cast<std::size_t>(row) * c.width + static_cast<std::size_t>(column)];
    };
    expect_by_definition(c, noisy);
    // Of light that is even, the noise that is left is that of the mean: what the weights' squares
    // add up to.
    const EyeMeasure measure = seen_measure(c);
    const auto grey = seen_test_plane(c.width, c.height, [](int, int) { return 0.5; });
    const auto specks = seen_test_plane(c.width, c.height, [&](int column, int row) {
      return 0.5 + noisy(column, row) - seen_test_light(column, row);
    });
    double squares = 0.0;
    for (const double weight : row_weights(c.eye)) squares += weight * weight;
    const double slope = 116.0 / 3.0 * std::pow(0.5, -2.0 / 3.0);  // dL*/dY
    const double over_rows = slope * 0.01 * std::sqrt(squares);
    const double rms = seen_between(measure, grey, specks).all.rms;
    EXPECT_LT(rms, over_rows) << c.pixels;
    EXPECT_GT(rms, 0.25 * over_rows) << c.pixels;
  }
}

TEST(UnitSeenMeasure, TheLargestDifferenceIsFound) {
  const SeenCase c{15.02, {600.0, 400.0, 1.0}, 90, 40};
  const EyeMeasure measure = seen_measure(c);
  const auto grey = seen_test_plane(c.width, c.height, [](int, int) { return 0.4; });
  // A speck in the middle of lens 3, and a lesser one in lens 1.
  const auto specks = seen_test_plane(c.width, c.height, [](int column, int row) {
    return 0.4 + (column == 52 && row == 21 ? 0.5 : 0.0) + (column == 20 && row == 9 ? 0.2 : 0.0);
  });
  const SeenDifferences got = seen_between(measure, grey, specks);
  EXPECT_EQ(got.all.where.lens, 3);
  EXPECT_EQ(got.all.where.row, 21u);
  EXPECT_EQ(got.all.where.part, 0.5);
  EXPECT_GT(got.all.bias, 0.0);
  EXPECT_EQ(got.largest.at(3, 21 - measure.first_row()), static_cast<float>(got.all.largest));
  EXPECT_EQ(got.parts[1].where.lens, 1);
}

TEST(UnitSeenMeasure, NothingIsMixedAcrossLenses) {
  const SeenCase c{7.49, {300.0, 400.0, 1.0}, 60, 30};
  const auto striped = seen_test_plane(c.width, c.height, [](int column, int) {
    return static_cast<int>((column + 0.5) / 7.49) % 2 == 0 ? 1.0 : 0.0;
  });
  const EyeMeasure measure = seen_measure(c);
  for (const double part : {0.0, 0.1, 0.9, 0.999}) {
    const LightPlane seen = measure.seen(striped, part);
    for (std::uint32_t lens = 0; lens < seen.width; ++lens) {
      EXPECT_NEAR(seen.at(lens, 2), lens % 2 == 0 ? 1.0 : 0.0, 1e-6);
    }
  }
}

TEST(UnitSeenMeasure, SlantedLensesAreFollowed) {
  // Each lens has its own light, and so has each part of it: both are seen in every row.
  constexpr std::uint32_t kWidth = 100, kHeight = 60;
  constexpr double kPixels = 10.25;
  LensRows lenses{kPixels, {}};
  for (std::uint32_t row = 0; row < kHeight; ++row) lenses.origins.push_back(6.0 - 0.2 * row);
  const auto light = [&](int column, int row) {
    const double at = (column + 0.5 - lenses.origins[static_cast<std::size_t>(row)]) / kPixels;
    return 0.05 * std::floor(at) + 0.2 + 0.04 * (at - std::floor(at));
  };
  const EyeBeforePrint eye{600.0, 400.0, 1.0};
  const EyeMeasure measure(lenses, eye, kWidth, kHeight);
  const LightPlane seen = measure.seen(seen_test_plane(kWidth, kHeight, light), 0.5);
  std::size_t count = 0;
  for (std::uint32_t row = 0; row < measure.rows(); ++row) {
    for (std::uint32_t i = 0; i < measure.lenses(); ++i) {
      const double lens = static_cast<double>(measure.first_lens() + i);
      const auto left = [&](std::uint32_t y) { return lenses.origins[y] + lens * kPixels; };
      const std::uint32_t last = row + 2 * measure.first_row();
      const bool fits = left(row) >= -0.5 && left(last) >= -0.5 && left(row) + kPixels <= 100.5 &&
                        left(last) + kPixels <= 100.5;
      EXPECT_EQ(measure.is_seen(i, row), fits) << i << " " << row;
      if (!fits) continue;
      ++count;
      EXPECT_NEAR(seen.at(i, row), 0.05 * lens + 0.22, 0.001) << i << " " << row;
      const double edge = std::ceil(left(row + measure.first_row()) - 0.5);
      EXPECT_EQ(measure.lens_at(edge + 0.2, row), i);
      EXPECT_NE(measure.lens_at(edge - 0.2, row), i);
    }
  }
  EXPECT_GT(count, 7u * measure.rows());
}

TEST(UnitSeenMeasure, WhatCannotBeSeenIsRefused) {
  const EyeBeforePrint eye;
  EXPECT_THROW(EyeMeasure({15.0, {}}, eye, 90, 5), std::invalid_argument);
  EXPECT_THROW(EyeMeasure({15.0, {}}, eye, 10, 50), std::invalid_argument);
  EXPECT_THROW(EyeMeasure({15.0, {}}, {600.0, 1e300, 1.0}, 90, 50), std::invalid_argument);
  const EyeMeasure measure({15.0, {}}, eye, 90, 50);
  EXPECT_THROW(measure.seen(seen_test_plane(90, 49, seen_test_light), 0.5), std::invalid_argument);
}

TEST(UnitSeenMeasure, AMinuteOfArcBlendsFourRowsOf600AtArmsLength) {
  const EyeBeforePrint eye;
  EXPECT_NEAR(eye.sigma(), 1.167, 0.001);
  double sum = 0.0, squares = 0.0;
  for (const double weight : row_weights(eye)) {
    sum += weight;
    squares += weight * weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(1.0 / squares, 4.26, 0.01);
}

TEST(UnitSeenMeasure, LightnessIsOfTheCie) {
  EXPECT_EQ(lightness(0.0), 0.0);
  EXPECT_NEAR(lightness(1.0), 100.0, 1e-9);
  EXPECT_NEAR(lightness(0.184187), 50.0, 1e-3);
  EXPECT_NEAR(lightness(0.001), 0.9033, 1e-4);
}

}  // namespace
}  // namespace lentray::diff
