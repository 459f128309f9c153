// What a listener is told of a frame, fed with times instead of clocks.
#include "core/render/frame_progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include "core/render/film.h"

namespace {

using namespace lentray::core;
using Clock = FrameProgress::Clock;
using std::chrono::milliseconds;

struct Said final : Progress {
  void advance(double fraction_done, double seconds_left) override {
    fractions.push_back(fraction_done);
    left.push_back(seconds_left);
  }
  std::vector<double> fractions, left;
};

/// 100 x 100 pixels.
FilmSetup setup_of(AntialiasingMethod method) {
  FilmSetup film;
  film.width = film.height = 128;
  film.region = {0, 0, 100, 100};
  film.antialiasing.method = method;
  film.antialiasing.depth = 2;
  if (film.antialiasing.compares()) film.lattice = PixelLattice::in_rows(film.width);
  return film;
}

TEST(UnitCoreFrameProgress, TellsNothingInTheFirstSecondAndThenNowAndThen) {
  Said said;
  const Clock::time_point start = Clock::now();
  FrameProgress progress(said, setup_of(AntialiasingMethod::kPlain), start);
  for (int i = 1; i <= 20; ++i) {
    progress.add(0, 10, milliseconds(100), start + milliseconds(100 * i));
    EXPECT_EQ(said.fractions.size(), i < 10 ? 0u : 1u + (static_cast<unsigned>(i) - 10) / 2) << i;
  }
}

TEST(UnitCoreFrameProgress, WhatIsLeftCostsWhatWasDone) {
  Said said;
  const Clock::time_point start = Clock::now();
  FrameProgress progress(said, setup_of(AntialiasingMethod::kPlain), start);
  // Two threads.
  progress.add(0, 1'000, milliseconds(2'000), start + milliseconds(500));
  progress.add(0, 1'500, milliseconds(2'000), start + milliseconds(2'000));
  ASSERT_EQ(said.fractions.size(), 1u);
  EXPECT_DOUBLE_EQ(said.fractions[0], 0.25);
  EXPECT_DOUBLE_EQ(said.left[0], 6.0);
  progress.add(0, 7'500, milliseconds(2'000), start + milliseconds(3'000));
  ASSERT_EQ(said.fractions.size(), 2u);
  EXPECT_EQ(said.fractions[1], 1.0);
  EXPECT_EQ(said.left[1], 0.0);
}

TEST(UnitCoreFrameProgress, AntialiasingIsGuessedUntilItIsSeen) {
  Said said;
  const Clock::time_point start = Clock::now();
  const FilmSetup film = setup_of(AntialiasingMethod::kCorners);
  const PixelRegion traced = Film::traced_region(film);
  const std::uint64_t pixels =
      std::uint64_t{traced.right - traced.left} * (traced.bottom - traced.top);
  FrameProgress progress(said, film, start);
  progress.add(0, pixels, milliseconds(1'000), start + milliseconds(1'000));
  ASSERT_EQ(said.left.size(), 1u);
  EXPECT_NEAR(said.left[0], 0.8, 1e-9);
  progress.add(1, pixels / 4, milliseconds(2'000), start + milliseconds(3'000));
  ASSERT_EQ(said.left.size(), 2u);
  EXPECT_NEAR(said.fractions[1], 3.0 / 9.0, 0.01);
  EXPECT_NEAR(said.left[1], 6.0, 0.05);
}

struct Known final : PictureLedger {
  Known() {
    for (std::uint32_t row = 0; row < 50; ++row) {
      for (std::uint32_t k = 0; k < 128; ++k) set.add({k, row});
    }
  }
  const PixelSet* known(std::size_t) const override { return &set; }
  void recall(std::size_t, std::uint32_t, std::uint32_t,
              const std::function<void(const Pixel&, const float*)>&) override {}
  bool listens() const override { return false; }
  void add(std::size_t, const std::vector<Pixel>&, const std::vector<float>&) override {}
  PixelSet set{128, 128};
};

TEST(UnitCoreFrameProgress, WhatIsKnownAlreadyIsNotLeft) {
  Said said;
  Known known;
  const Clock::time_point start = Clock::now();
  FilmSetup film = setup_of(AntialiasingMethod::kPlain);
  film.ledger = &known;
  FrameProgress progress(said, film, start);
  progress.add(0, 2'500, milliseconds(1'000), start + milliseconds(1'000));
  ASSERT_EQ(said.fractions.size(), 1u);
  EXPECT_DOUBLE_EQ(said.fractions[0], 0.5);
}

TEST(UnitCoreFrameProgress, AMeterReportsAWholeJob) {
  Said said;
  FrameProgress progress(said, setup_of(AntialiasingMethod::kPlain),
                         Clock::now() - std::chrono::seconds(5));
  FrameMeter meter(progress);
  meter.begin(0);
  for (int i = 0; i < 9'999; ++i) meter.pixel();
  meter.end();
  ASSERT_FALSE(said.fractions.empty());
  EXPECT_LT(said.fractions.front(), 0.1) << "of the first pixels, not of the job";
}

}  // namespace
