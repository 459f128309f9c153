#include "tests/support/stock_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lentray::test {
namespace {

constexpr std::uint32_t kBlock = 16;

std::array<double, 3> sum_in_block(const StoredImage& a, const StoredImage& b, std::uint32_t left,
                                   std::uint32_t top, int& pixels) {
  std::array<double, 3> sum{};
  for (std::uint32_t row = top; row < std::min(top + kBlock, a.height); ++row) {
    for (std::uint32_t column = left; column < std::min(left + kBlock, a.width); ++column) {
      const auto x = core::level(a, column, row), y = core::level(b, column, row);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += x[c] - y[c];
      ++pixels;
    }
  }
  return sum;
}

}  // namespace

BlockDifference block_difference(const StoredImage& a, const StoredImage& b) {
  BlockDifference result;
  int blocks = 0;
  for (std::uint32_t top = 0; top < a.height; top += kBlock) {
    for (std::uint32_t left = 0; left < a.width; left += kBlock) {
      int pixels = 0;
      for (const double sum : sum_in_block(a, b, left, top, pixels)) {
        result.rms += sum * sum / pixels / pixels;
        result.mean += sum;
      }
      ++blocks;
    }
  }
  result.rms = std::sqrt(result.rms / (3.0 * blocks));
  result.mean /= 3.0 * a.width * a.height;
  return result;
}

::testing::AssertionResult within_stocks_noise(const SceneText& scene) {
  const auto stock = [&](const std::vector<std::string>& more) {
    SceneText one = scene;
    one.arguments.insert(one.arguments.end(), more.begin(), more.end());
    return stock_render(one);
  };
  const StoredImage reference = stock({"+WT1"});
  double rms = 0.0, mean = 0.0;
  for (const std::vector<std::string>& other :
       {std::vector<std::string>{"+WT1", "+BS8"}, {"+WT1", "+BS256"}, {"+WT2"}}) {
    const BlockDifference noise = block_difference(stock(other), reference);
    rms += noise.rms * noise.rms / 3.0;
    mean += noise.mean * noise.mean / 3.0;
  }
  const double most_rms = std::max(0.3, 1.5 * std::sqrt(rms));
  const double most_mean = std::max(0.2, 1.5 * std::sqrt(mean));
  const BlockDifference ours = block_difference(lentray_render(scene), reference);
  const bool passes = ours.rms <= most_rms && std::fabs(ours.mean) <= most_mean;
  return (passes ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
         << "block means differ by " << ours.rms << "/255 (at most " << most_rms
         << "), the whole by " << ours.mean << " (at most " << most_mean << ")";
}

}  // namespace lentray::test
