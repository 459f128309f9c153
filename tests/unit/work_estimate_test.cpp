// What is foreseen of a picture's work, fed with costs and counts instead of clocks.
#include "core/render/work_estimate.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "core/render/work_meter.h"
#include "core/render/work_pace.h"

namespace {

using namespace lentray::core;

/// 64 x 64 pixels: 4 x 4 cells of 256 pixels.
constexpr PixelRegion kRegion{0, 0, 64, 64};

void visit(WorkCells& cells, std::size_t cell, std::uint32_t pixels, double seconds) {
  cells[cell].visits[0] += pixels;
  cells[cell].nanoseconds += static_cast<std::uint64_t>(seconds * 1e9);
  cells.add_seconds(0, seconds);
}

/// What a pixel takes: the lower half ten times the upper.
double cost(std::size_t cell) { return cell < 8 ? 1e-3 : 1e-2; }

TEST(UnitCoreWorkEstimate, CellsCoverTheRegionAndNoMore) {
  const WorkCells cells({10, 20, 51, 37});
  EXPECT_EQ(cells.columns(), 3u);
  EXPECT_EQ(cells.rows(), 2u);
  std::uint32_t all = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) all += cells.pixels(i, 0);
  EXPECT_EQ(all, 41u * 17u);
  EXPECT_EQ(cells.index(-1, -1), 0u);
  EXPECT_EQ(cells.index(26, 36), 4u);
  EXPECT_EQ(cells.index(900, 900), 5u);
  EXPECT_LE(WorkCells({0, 0, 30000, 20000}).size(), 65536u);
}

TEST(UnitCoreWorkEstimate, WorkIsWhatPixelsCostNotHowManyThereAre) {
  WorkCells cells(kRegion);
  WorkEstimate estimate(cells, {});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (int k = 0; k < 9; ++k) estimate.probe(i, cost(i), 0, 0);
  }
  EXPECT_NEAR(estimate.work().left, 8 * 256 * 0.011, 0.7);
  EXPECT_EQ(estimate.work().fraction(), 0.0);
  for (std::size_t i = 0; i < 8; ++i) visit(cells, i, 256, 256 * cost(i));
  EXPECT_TRUE(estimate.is_traced(7));
  EXPECT_FALSE(estimate.is_traced(8));
  EXPECT_NEAR(estimate.work().fraction(), 1.0 / 11.0, 0.02) << "half of the pixels";
  for (std::size_t i = 8; i < 16; ++i) visit(cells, i, 128, 128 * cost(i));
  EXPECT_NEAR(estimate.work().fraction(), 6.0 / 11.0, 0.02);
  for (std::size_t i = 8; i < 16; ++i) visit(cells, i, 128, 128 * cost(i));
  EXPECT_EQ(estimate.work().left, 0.0);
  EXPECT_EQ(estimate.work().fraction(), 1.0);
}

TEST(UnitCoreWorkEstimate, WhatWasDoneSaysHowFarProbesAreOff) {
  WorkCells cells(kRegion);
  WorkEstimate estimate(cells, {});
  for (std::size_t i = 0; i < cells.size(); ++i) estimate.probe(i, 1e-3, 0, 0);
  const double foreseen = estimate.work().left;
  EXPECT_NEAR(foreseen, 4.096, 1e-6);
  for (std::size_t i = 0; i < 8; ++i) visit(cells, i, 256, 256 * 2e-3);
  EXPECT_GT(estimate.work().left, 0.8 * foreseen) << "half of the pixels, each twice as dear";
  EXPECT_LE(estimate.work().left, foreseen);
}

TEST(UnitCoreWorkEstimate, CellsWithoutProbesSayNothingOfProbes) {
  WorkCells cells(kRegion);
  WorkEstimate estimate(cells, {});
  // A fast sky that was traced before the first probe.
  for (std::size_t i = 0; i < 8; ++i) visit(cells, i, 256, 256 * 1e-6);
  for (std::size_t i = 8; i < 16; ++i) estimate.probe(i, 1e-2, 0, 0);
  EXPECT_NEAR(estimate.work().left, 8 * 256 * 1e-2, 0.1);
}

TEST(UnitCoreWorkEstimate, AFewProbesAreShrunkTowardsWhatIsAround) {
  WorkCells cells(kRegion);
  WorkEstimate estimate(cells, {});
  for (std::size_t i = 0; i < cells.size(); ++i) estimate.probe(i, i == 5 ? 1.0 : 1e-3, 0, 0);
  const double left = estimate.work().left;
  EXPECT_LT(left, 256 * 1.1);
  EXPECT_GT(left, 256 * 0.8) << "the mean of all stays";
  visit(cells, 5, 256, 256 * 1.0);
  EXPECT_GT(estimate.work().left, 256 * 0.2) << "and neighbours may be as dear";
}

TEST(UnitCoreWorkEstimate, AntialiasingIsASecondStageWhereSamplesDiffer) {
  WorkCells cells(kRegion);
  const FinerWork finer = FinerWork::of({.method = 1, .depth = 3});
  EXPECT_EQ(finer.samples, 9.0);
  WorkEstimate estimate(cells, finer);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (int k = 0; k < 20; ++k) estimate.probe(i, 1e-3, 2, i < 8 ? 0 : 2);
  }
  const double first = 16 * 256 * 1e-3;
  EXPECT_NEAR(estimate.work().left, first + 9 * first / 2, 0.15 * first);
  for (std::size_t i = 0; i < 16; ++i) {
    visit(cells, i, 256, 256 * 1e-3);
    cells[i].pairs += 250;
    cells[i].differing += i < 8 ? 0 : 250;
  }
  EXPECT_NEAR(estimate.work().fraction(), 1.0 / 5.5, 0.01);
  for (std::size_t i = 0; i < 8; ++i) cells[i].visits[1] += 256;
  EXPECT_NEAR(estimate.work().fraction(), 1.0 / 5.5, 0.03) << "nothing to do there";
  for (std::size_t i = 8; i < 12; ++i) cells[i].visits[1] += 256;
  cells.add_seconds(1, 9 * first / 4);
  EXPECT_NEAR(estimate.work().fraction(), 3.25 / 5.5, 0.03);
  for (std::size_t i = 12; i < 16; ++i) cells[i].visits[1] += 256;
  cells.add_seconds(1, 9 * first / 4);
  EXPECT_EQ(estimate.work().left, 0.0);
}

TEST(UnitCoreWorkEstimate, OneThreadDoesTheLongestJob) {
  WorkCells cells({0, 0, 256, 64});
  WorkEstimate estimate(cells, {});
  for (std::size_t i = 0; i < cells.size(); ++i) estimate.probe(i, 1e-3, 0, 0);
  EXPECT_NEAR(estimate.work().longest, estimate.work().left / 4.0, 1e-6) << "squares of 64";
  for (std::size_t i = 0; i < cells.size(); ++i) visit(cells, i, i % 16 == 0 ? 128 : 256, 0.256);
  EXPECT_NEAR(estimate.work().longest, estimate.work().left, 1e-9);
}

TEST(UnitCoreWorkEstimate, OverlappingBandsTraceMoreThanThePixels) {
  WorkCells cells(kRegion);
  WorkEstimate estimate(cells, {}, 1.5);
  for (std::size_t i = 0; i < cells.size(); ++i) estimate.probe(i, 1e-3, 0, 0);
  EXPECT_NEAR(estimate.work().left, 1.5 * 4.096, 1e-6);
}

TEST(UnitCoreWorkEstimate, TimeIsWorkByThePaceOfLate) {
  WorkPace pace;
  EXPECT_EQ(pace.seconds(1.0), 0.0) << "nothing is known";
  pace.add(1.0, 2.0);
  EXPECT_NEAR(pace.seconds(6.0), 3.0, 1e-9) << "two threads";
  for (int i = 1; i <= 100; ++i) pace.add(1.0 + 0.2 * i, 2.0 + 0.1 * i);
  EXPECT_NEAR(pace.seconds(6.0), 12.0, 1.0) << "the machine has become four times slower";
}

TEST(UnitCoreWorkEstimate, AMeterReportsVisitsTimeAndDifferences) {
  WorkCells cells(kRegion);
  const PixelLattice rows = PixelLattice::in_rows(64);
  WorkMeter meter(cells, rows, 0.3);
  meter.begin(0);
  for (std::int32_t row = 0; row < 64; ++row) {
    for (std::int32_t column = 0; column < 64; ++column) {
      meter.pixel(column, row);
      meter.seen(column, row, {Rgb(column < 24 ? 0.0f : 1.0f), 0.0f});
    }
  }
  meter.end();
  meter.begin(1);
  for (std::int32_t row = 0; row < 10; ++row) meter.pixel(3, row);
  meter.end();
  double spent = 0.0;
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(cells[i].visits[0], 256u);
    EXPECT_EQ(cells[i].visits[1], i == 0 ? 10u : 0u);
    EXPECT_EQ(cells[i].pairs, i % 4 == 0 ? 240u : 256u);
    EXPECT_EQ(cells[i].differing, i % 4 == 1 ? 16u : 0u);
    spent += 1e-9 * static_cast<double>(cells[i].nanoseconds);
  }
  EXPECT_GT(cells.seconds(0), 0.0);
  EXPECT_NEAR(cells.seconds(0), spent,
              1e-6 + 0.01 * spent);  // nanoseconds are rounded cell by cell
}

}  // namespace
