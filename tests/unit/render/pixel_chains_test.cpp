#include "core/render/pixel_chains.h"

#include <gtest/gtest.h>

#include <map>

namespace lentray::core::test {
namespace {

constexpr std::size_t kChainRows = 7;

/// Behind lenses of so many pixels; columns join those of the same place in the lens before.
PixelLattice lattice_of_lenses(double pixels, std::uint32_t width) {
  PixelLattice lattice;
  for (std::uint32_t k = 0; k < width; ++k) {
    lattice.left.push_back(static_cast<std::int32_t>(k - pixels));
  }
  lattice.tiles = {0, width / 2, width};
  return lattice;
}

/// By row and place, when it is visited.
using Steps = std::map<std::pair<std::size_t, std::size_t>, std::size_t>;

Steps steps_of(const PixelChain& chain) {
  Steps steps;
  for (std::size_t step = 0; step < chain.steps(kChainRows); ++step) {
    chain.at_step(step, kChainRows, [&](std::size_t place, std::size_t row) {
      EXPECT_TRUE(steps.emplace(std::pair{row, place}, step).second);
    });
  }
  return steps;
}

/// Whoever looks at a pixel or changes it does so in the order of rows, one after the other.
void expect_order(const PixelChain& chain) {
  Steps steps = steps_of(chain);
  ASSERT_EQ(steps.size(), kChainRows * chain.visits());
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> last;  // by pixel
  const auto touch = [&](std::size_t row, std::size_t place, std::size_t step) {
    const auto [at, is_new] = last.try_emplace({row, place}, step);
    if (!is_new) {
      EXPECT_LT(at->second, step) << "row " << row << " place " << place;
      at->second = step;
    }
  };
  const std::size_t count = chain.columns.size();
  for (std::size_t row = 0; row < kChainRows; ++row) {
    for (std::size_t place = 0; place < chain.visits(); ++place) {
      const std::size_t step = steps[{row, place}];
      if (place >= count) {
        touch(row, chain.ahead[place - count].first, step);
        continue;
      }
      if (chain.left[place] != PixelChain::kOutside) touch(row, chain.left[place], step);
      if (row > 0) touch(row - 1, place, step);
      touch(row, place, step);
    }
  }
}

TEST(UnitPixelChains, AreVisitedAsRowByRow) {
  for (const double pixels : {1.0, 2.0, 4.0, 4.5, 5.3, 2.7}) {
    SCOPED_TRACE(pixels);
    const PixelLattice lattice = lattice_of_lenses(pixels, 46);
    std::size_t columns = 0;
    for (std::size_t tile = 0; tile < 2; ++tile) {
      for (const PixelChain& chain :
           chains_of_tile(lattice, lattice.tiles[tile], lattice.tiles[tile + 1])) {
        columns += chain.columns.size();
        expect_order(chain);
      }
    }
    EXPECT_EQ(columns, 46u);
  }
}

TEST(UnitPixelChains, OfAnOrdinaryPictureHaveRowsTwoPlacesBehind) {
  const PixelLattice lattice = PixelLattice::in_rows(200);
  const std::vector<PixelChain> chains = chains_of_tile(lattice, 0, 128);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_EQ(chains[0].columns.size(), 128u);
  EXPECT_EQ(chains[0].ahead.size(), 1u);
  EXPECT_EQ(chains[0].lag, 2u);
  EXPECT_EQ(chains[0].steps(0), 0u);
}

}  // namespace
}  // namespace lentray::core::test
