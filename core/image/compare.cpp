#include "core/image/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "core/numeric/lens_columns.h"

namespace lentray::core {

namespace {

constexpr std::uint32_t kBox = 8;
// Differences of quantised values are whole on their own scale; this only absorbs rounding.
constexpr double kSlack = 1e-6;

double psnr_of(double squares, double values) {
  if (squares == 0.0) return std::numeric_limits<double>::infinity();
  return 10.0 * std::log10(255.0 * 255.0 * values / squares);
}

void check_sizes(const StoredImage& a, const StoredImage& b) {
  if (a.width == b.width && a.height == b.height) return;
  const auto size = [](const StoredImage& i) {
    return std::to_string(i.width) + " x " + std::to_string(i.height);
  };
  throw std::invalid_argument("the pictures differ in size: " + size(a) + " and " + size(b));
}

/// Squared differences of the means of 8 x 8 blocks, summed over blocks and channels.
class BoxFilter {
 public:
  BoxFilter(const StoredImage& a, const StoredImage& b, const Columns& columns)
      : m_a(a), m_b(b), m_columns(columns) {}

  double psnr() const {
    double squares = 0.0, values = 0.0;
    const auto width = static_cast<std::uint32_t>(m_columns.list.size());
    for (std::uint32_t y = 0; y < m_a.height; y += kBox) {
      for (std::uint32_t x = 0; x < width; x += kBox) {
        squares += block(x, std::min(x + kBox, width), y, std::min(y + kBox, m_a.height));
        values += 3.0;
      }
    }
    return psnr_of(squares, values);
  }

 private:
  double block(std::uint32_t x0, std::uint32_t x1, std::uint32_t y0, std::uint32_t y1) const {
    std::array<double, 3> sum{};
    for (std::uint32_t y = y0; y < y1; ++y) {
      for (std::uint32_t x = x0; x < x1; ++x) {
        const auto p = level(m_a, m_columns.list[x], y), q = level(m_b, m_columns.list[x], y);
        for (int c = 0; c < 3; ++c) sum[c] += p[c] - q[c];
      }
    }
    const double count = double(x1 - x0) * double(y1 - y0);
    double squares = 0.0;
    for (const double s : sum) squares += (s / count) * (s / count);
    return squares;
  }

  const StoredImage &m_a, &m_b;
  const Columns& m_columns;
};

Grade grade_of(const Comparison& c, std::uint64_t allowance) {
  const double pixels = static_cast<double>(c.pixels);
  if (static_cast<double>(c.beyond_1) <= 0.001 * pixels) return Grade::exact;
  const bool few = static_cast<double>(c.beyond_2) <= 0.01 * pixels || c.beyond_2 <= allowance;
  if (few && c.psnr >= 40.0) return Grade::match;
  return c.smooth_psnr >= 30.0 ? Grade::close : Grade::fails;
}

}  // namespace

std::string_view name_of(Grade grade) {
  switch (grade) {
    case Grade::exact: return "exact";
    case Grade::match: return "match";
    case Grade::close: return "close";
    case Grade::fails: break;
  }
  return "fails";
}

std::optional<Grade> grade_named(std::string_view name) {
  for (const Grade g : {Grade::fails, Grade::close, Grade::match, Grade::exact}) {
    if (name == name_of(g)) return g;
  }
  return std::nullopt;
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
  result.psnr = psnr_of(squares, 3.0 * static_cast<double>(result.pixels));
  result.smooth_psnr = BoxFilter(a, b, columns).psnr();
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
    // Neighbours in an interlaced picture are not neighbours on screen: the box filter of the
    // whole is that of its views together.
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

bool reaches(const LensComparison& result, Grade asked) {
  const Grade part = std::min(asked, Grade::match);
  const auto good = [&](const Comparison& c) { return c.grade >= part; };
  return result.whole.grade >= asked &&
         std::all_of(result.lenses.begin(), result.lenses.end(), good) &&
         std::all_of(result.views.begin(), result.views.end(), good);
}

}  // namespace lentray::core
