#include "core/image/compare.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "core/numeric/lens_columns.h"

namespace lentray::core {

namespace {

/// By grade.
constexpr std::string_view kGradeNames[] = {"fails", "close", "noise", "match", "exact"};
constexpr std::uint32_t kBox = 8, kNoiseBlock = 16;
// Differences of quantised values are whole on their own scale; this only absorbs rounding.
constexpr double kSlack = 1e-6;

double psnr_of(double mean_square) {
  if (mean_square == 0.0) return std::numeric_limits<double>::infinity();
  return 10.0 * std::log10(255.0 * 255.0 / mean_square);
}

void check_sizes(const StoredImage& a, const StoredImage& b) {
  if (a.width == b.width && a.height == b.height) return;
  const auto size = [](const StoredImage& i) {
    return std::to_string(i.width) + " x " + std::to_string(i.height);
  };
  throw std::invalid_argument("the pictures differ in size: " + size(a) + " and " + size(b));
}

/// Sums of a - b over blocks of 8 x 8 pixels.
class BlockSums {
 public:
  BlockSums(const StoredImage& a, const StoredImage& b, const Columns& columns)
      : m_columns(static_cast<std::uint32_t>(columns.list.size())), m_rows(a.height),
        m_across((m_columns + kBox - 1) / kBox), m_down((m_rows + kBox - 1) / kBox),
        m_sums(std::size_t{m_across} * m_down) {
    for (std::uint32_t y = 0; y < m_rows; ++y) {
      for (std::uint32_t x = 0; x < m_columns; ++x) {
        const auto p = level(a, columns.list[x], y), q = level(b, columns.list[x], y);
        auto& sum = m_sums[std::size_t{y / kBox} * m_across + x / kBox];
        for (int c = 0; c < 3; ++c) sum[c] += p[c] - q[c];
      }
    }
  }

  /// Mean square of the means of blocks of `side` x `side`, a multiple of 8.
  double mean_square(std::uint32_t side) const {
    double squares = 0.0;
    std::size_t blocks = 0;
    for (std::uint32_t y = 0; y < m_rows; y += side) {
      for (std::uint32_t x = 0; x < m_columns; x += side, ++blocks) {
        const double count =
            double(std::min(side, m_columns - x)) * double(std::min(side, m_rows - y));
        for (const double sum : block(x / kBox, y / kBox, side / kBox))
          squares += (sum / count) * (sum / count);
      }
    }
    return squares / (3.0 * static_cast<double>(blocks));
  }

  BlockDifference difference() const {
    BlockDifference d{.rms = std::sqrt(mean_square(kNoiseBlock)), .bias = 0.0};
    for (const double sum : block(0, 0, std::max(m_across, m_down))) {
      const double bias = sum / (double(m_columns) * double(m_rows));
      if (std::abs(bias) > std::abs(d.bias)) d.bias = bias;
    }
    return d;
  }

 private:
  std::array<double, 3> block(std::uint32_t column, std::uint32_t row, std::uint32_t size) const {
    std::array<double, 3> all{};
    for (std::uint32_t y = row; y < std::min(row + size, m_down); ++y) {
      for (std::uint32_t x = column; x < std::min(column + size, m_across); ++x) {
        for (int c = 0; c < 3; ++c) all[c] += m_sums[std::size_t{y} * m_across + x][c];
      }
    }
    return all;
  }

  std::uint32_t m_columns, m_rows, m_across, m_down;
  std::vector<std::array<double, 3>> m_sums;
};

Grade grade_of(const Comparison& c, std::uint64_t allowance) {
  const double pixels = static_cast<double>(c.pixels);
  if (static_cast<double>(c.beyond_1) <= 0.001 * pixels) return Grade::exact;
  const bool few = static_cast<double>(c.beyond_2) <= 0.01 * pixels || c.beyond_2 <= allowance;
  if (few && c.psnr >= 40.0) return Grade::match;
  return c.smooth_psnr >= 30.0 ? Grade::close : Grade::fails;
}

}  // namespace

std::string_view name_of(Grade grade) { return kGradeNames[static_cast<std::size_t>(grade)]; }

std::optional<Grade> grade_named(std::string_view name) {
  const auto* const row = std::ranges::find(kGradeNames, name);
  if (row == std::end(kGradeNames)) return std::nullopt;
  return static_cast<Grade>(row - std::begin(kGradeNames));
}

Columns Columns::all(std::uint32_t width) { return range(0, width); }

Columns Columns::range(std::uint32_t begin, std::uint32_t end) {
  Columns c;
  c.list.resize(end > begin ? end - begin : 0);
  std::iota(c.list.begin(), c.list.end(), begin);
  return c;
}

Columns Columns::every(std::uint32_t first, std::uint32_t step, std::uint32_t width) {
  Columns c;
  for (std::uint64_t k = first; k < width; k += step) {
    c.list.push_back(static_cast<std::uint32_t>(k));
  }
  return c;
}

std::array<double, 3> level(const StoredImage& image, std::uint32_t column, std::uint32_t row) {
  const double scale = image.bits == 8 ? 1.0 : image.bits == 16 ? 255.0 / 65535.0 : 255.0;
  const bool grey = image.channels < 3;
  std::array<double, 3> out{};
  for (int c = 0; c < 3; ++c) out[c] = scale * image.at(column, row, grey ? 0 : c);
  return out;
}

double pixel_difference(const StoredImage& a, const StoredImage& b, std::uint32_t column,
                        std::uint32_t row) {
  const auto p = level(a, column, row), q = level(b, column, row);
  return std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

Comparison compare(const StoredImage& a, const StoredImage& b, const Columns& columns,
                   std::uint64_t allowance) {
  check_sizes(a, b);
  Comparison result;
  double sum = 0.0, squares = 0.0;
  for (std::uint32_t row = 0; row < a.height; ++row) {
    for (const std::uint32_t column : columns.list) {
      const auto p = level(a, column, row), q = level(b, column, row);
      double worst = 0.0;
      for (int c = 0; c < 3; ++c) {
        const double d = std::abs(p[c] - q[c]);
        worst = std::max(worst, d);
        squares += d * d;
      }
      ++result.pixels;
      if (worst > 1.0 + kSlack) ++result.beyond_1;
      if (worst > 2.0 + kSlack) ++result.beyond_2;
      result.largest = std::max(result.largest, worst);
      sum += worst;
    }
  }
  if (result.pixels == 0) throw std::invalid_argument("no pixels to compare");
  result.mean = sum / static_cast<double>(result.pixels);
  result.psnr = psnr_of(squares / (3.0 * static_cast<double>(result.pixels)));
  const BlockSums sums(a, b, columns);
  result.smooth_psnr = psnr_of(sums.mean_square(kBox));
  result.blocks = sums.difference();
  result.grade = grade_of(result, allowance);
  return result;
}

LensComparison compare_lenses(const StoredImage& a, const StoredImage& b, double lens_pixels) {
  check_sizes(a, b);
  if (!(lens_pixels >= 1.0)) throw std::invalid_argument("a lens has at least one pixel");
  LensComparison result;
  result.whole = compare(a, b, Columns::all(a.width));
  const LensColumns columns{lens_pixels};
  for (std::uint32_t begin = 0; begin < a.width;) {
    std::uint32_t end = begin + 1;
    while (end < a.width && columns.lens_of(end) == columns.lens_of(begin)) ++end;
    result.lenses.push_back(compare(a, b, Columns::range(begin, end), kLensAllowance));
    begin = end;
  }
  if (lens_pixels == std::floor(lens_pixels)) {
    const auto views = static_cast<std::uint32_t>(std::min(lens_pixels, double(a.width)));
    for (std::uint32_t j = 0; j < views; ++j) {
      result.views.push_back(compare(a, b, Columns::every(j, views, a.width)));
    }
    // Neighbours in an interlaced picture are not neighbours on screen: the blocks of the
    // whole are those of its views together.
    std::vector<BlockDifference> blocks;
    for (const Comparison& v : result.views) blocks.push_back(v.blocks);
    result.whole.blocks = root_mean_square(blocks);
    double squares = 0.0, pixels = 0.0;
    for (const Comparison& v : result.views) {
      squares += double(v.pixels) * std::pow(10.0, -v.smooth_psnr / 10.0);
      pixels += double(v.pixels);
    }
    result.whole.smooth_psnr = squares == 0.0 ? std::numeric_limits<double>::infinity()
                                              : -10.0 * std::log10(squares / pixels);
    result.whole.grade = grade_of(result.whole, 0);
  }
  return result;
}

BlockDifference root_mean_square(std::span<const BlockDifference> differences) {
  BlockDifference sum;
  for (const BlockDifference& d : differences) {
    sum.rms += d.rms * d.rms;
    sum.bias += d.bias * d.bias;
  }
  const auto count = static_cast<double>(differences.size());
  return {std::sqrt(sum.rms / count), std::sqrt(sum.bias / count)};
}

bool is_within(const BlockDifference& difference, const BlockDifference& noise) {
  constexpr double kTimes = 1.5, kRms = 0.3, kBias = 0.2;
  return difference.rms <= std::max(kRms, kTimes * noise.rms) &&
         std::abs(difference.bias) <= std::max(kBias, kTimes * noise.bias);
}

void grade_by_noise(LensComparison& result, const StoredImage& stock,
                    std::span<const StoredImage> others) {
  const auto grade = [](Comparison& c, const BlockDifference& noise) {
    c.noise = noise;
    if (c.grade < Grade::match) c.grade = is_within(c.blocks, noise) ? Grade::noise : Grade::fails;
  };
  const auto noise_of = [&](const Columns& columns) {
    std::vector<BlockDifference> all;
    for (const StoredImage& other : others) {
      check_sizes(stock, other);
      all.push_back(BlockSums(stock, other, columns).difference());
    }
    return root_mean_square(all);
  };
  if (result.views.empty()) return grade(result.whole, noise_of(Columns::all(stock.width)));
  const auto views = static_cast<std::uint32_t>(result.views.size());
  std::vector<BlockDifference> noises;
  for (std::uint32_t j = 0; j < views; ++j) {
    noises.push_back(noise_of(Columns::every(j, views, stock.width)));
    grade(result.views[j], noises.back());
  }
  grade(result.whole, root_mean_square(noises));
}

bool reaches(const LensComparison& result, Grade asked) {
  const Grade part = std::min(asked, Grade::match);
  const auto good = [&](const Comparison& c) { return c.grade >= part; };
  const bool with_lenses = !result.whole.noise;
  return result.whole.grade >= asked &&
         (!with_lenses || std::all_of(result.lenses.begin(), result.lenses.end(), good)) &&
         std::all_of(result.views.begin(), result.views.end(), good);
}

}  // namespace lentray::core
