#include "tools/lentray-diff/eye_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "core/base/formed.h"
#include "core/numeric/lens_columns.h"

namespace lentray::diff {
namespace {

constexpr double kBlurOfLens = 2.0 / 15.0;
constexpr double kMmAnInch = 25.4;
/// Beyond so many standard deviations a row counts no more.
constexpr double kReachInSigmas = 4.0;

core::LensColumns lens_columns(const LensRows& lens, std::uint32_t row) {
  return {lens.pixels, lens.origin(row)};
}

/// What is collected of some points.
class Tally {
 public:
  void add(float difference, const SeenPoint& point) {
    m_sum += difference;
    m_squares += double{difference} * difference;
    const float size = std::abs(difference);
    if (m_sizes.empty() || size > m_largest) {
      m_largest = size;
      m_where = point;
    }
    m_sizes.push_back(size);
  }
  void add(const Tally& other) {
    if (m_sizes.empty() || (!other.m_sizes.empty() && other.m_largest > m_largest)) {
      m_largest = other.m_largest;
      m_where = other.m_where;
    }
    m_sum += other.m_sum;
    m_squares += other.m_squares;
    m_sizes.insert(m_sizes.end(), other.m_sizes.begin(), other.m_sizes.end());
  }
  SeenDifference result() const {
    SeenDifference out;
    out.points = m_sizes.size();
    if (m_sizes.empty()) return out;
    const auto count = static_cast<double>(out.points);
    std::vector<float> sizes = m_sizes;
    const auto rank = sizes.begin() + static_cast<std::ptrdiff_t>(std::ceil(0.99 * count)) - 1;
    std::nth_element(sizes.begin(), rank, sizes.end());
    out.rms = std::sqrt(m_squares / count);
    out.within_99 = *rank;
    out.largest = m_largest;
    out.bias = m_sum / count;
    out.where = m_where;
    return out;
  }

 private:
  double m_sum = 0.0, m_squares = 0.0;
  float m_largest = 0.0f;
  SeenPoint m_where{};
  std::vector<float> m_sizes;
};

}  // namespace

double EyeBeforePrint::sigma() const {
  const double angle = arc_minutes / 60.0 * std::numbers::pi / 180.0;
  const double full_width = distance * std::tan(angle) * rows_an_inch / kMmAnInch;
  return full_width / (2.0 * std::sqrt(2.0 * std::numbers::ln2));
}

std::vector<double> row_weights(const EyeBeforePrint& eye) {
  const double scale = eye.sigma() * std::numbers::sqrt2;
  const auto reach = static_cast<int>(std::ceil(kReachInSigmas * eye.sigma()));
  std::vector<double> out;
  double sum = 0.0;
  for (int row = -reach; row <= reach; ++row) {
    out.push_back(std::erf((row + 0.5) / scale) - std::erf((row - 0.5) / scale));
    sum += out.back();
  }
  for (double& weight : out) weight /= sum;
  return out;
}

double lightness(double luminance) {
  constexpr double kLinearTo = 216.0 / 24389.0, kSlope = 24389.0 / 27.0;
  return luminance > kLinearTo ? 116.0 * std::cbrt(luminance) - 16.0 : kSlope * luminance;
}

EyeMeasure::EyeMeasure(LensRows lenses, const EyeBeforePrint& eye, std::uint32_t width,
                       std::uint32_t height)
    : m_lens(std::move(lenses)), m_width(width), m_height(height),
      m_blur(std::max(1.0, kBlurOfLens * m_lens.pixels)) {
  // Far more rows than any picture has would not fit into memory.
  if (2.0 * kReachInSigmas * eye.sigma() < height) m_weights = row_weights(eye);
  if (m_weights.empty() || m_weights.size() > height) {
    throw std::invalid_argument(
        core::formed("the eye blends %.6g rows, and the picture has %u: that takes a higher "
                     "picture, a nearer eye "
                     "or fewer minutes of arc",
                     2.0 * std::ceil(kReachInSigmas * eye.sigma()) + 1.0, height));
  }
  m_reach = static_cast<std::uint32_t>(m_weights.size() / 2);
  std::int64_t first = std::numeric_limits<std::int64_t>::max(), end = 0;
  for (const std::uint32_t row : {0u, height - 1}) {
    const core::LensColumns columns = lens_columns(m_lens, row);
    // A lens that begins left of the picture may end within: it is cut.
    std::int64_t lens = columns.lens_of(0);
    if (columns.first_column(lens) < 0) ++lens;
    first = std::min(first, lens);
    end = std::max(end, columns.lens_of(width));
    if (row == 0) continue;
    if (end <= first) {
      throw std::invalid_argument(core::formed(
          "no lens of %.6g pixels is whole in a picture of %u columns", m_lens.pixels, width));
    }
  }
  m_first_lens = first;
  m_lenses = static_cast<std::uint32_t>(end - first);
}

bool EyeMeasure::is_whole(std::int64_t lens, std::uint32_t row) const {
  const core::LensColumns columns = lens_columns(m_lens, row);
  return columns.first_column(lens) >= 0 && columns.first_column(lens + 1) <= m_width;
}

bool EyeMeasure::is_seen(std::uint32_t lens, std::uint32_t row) const {
  if (m_lens.origins.empty()) return true;
  // Lenses lean one way: what is whole at both ends is whole between.
  const std::int64_t number = m_first_lens + lens;
  return is_whole(number, row) && is_whole(number, row + 2 * m_reach);
}

std::optional<std::uint32_t> EyeMeasure::lens_at(double column, std::uint32_t row) const {
  const core::LensColumns columns = lens_columns(m_lens, row + m_reach);
  const auto lens = columns.lens_of(static_cast<std::int64_t>(std::floor(column))) - m_first_lens;
  if (lens < 0 || lens >= m_lenses) return std::nullopt;
  const auto out = static_cast<std::uint32_t>(lens);
  return is_seen(out, row) ? std::optional(out) : std::nullopt;
}

std::vector<EyeMeasure::Taps> EyeMeasure::taps(std::uint32_t row, double part) const {
  const core::LensColumns columns = lens_columns(m_lens, row);
  std::vector<Taps> out(m_lenses);
  for (std::uint32_t i = 0; i < m_lenses; ++i) {
    const std::int64_t lens = m_first_lens + i;
    if (!is_whole(lens, row)) continue;
    const double x = columns.edge(static_cast<double>(lens) + part);
    const auto begin = std::max(columns.first_column(lens),
                                static_cast<std::int64_t>(std::ceil(x - m_blur - 0.5)));
    const auto end = std::min(columns.first_column(lens + 1),
                              static_cast<std::int64_t>(std::floor(x + m_blur - 0.5)) + 1);
    double sum = 0.0;
    for (std::int64_t k = begin; k < end; ++k) {
      sum += 1.0 - std::abs(static_cast<double>(k) + 0.5 - x) / m_blur;
    }
    out[i].first = static_cast<std::uint32_t>(begin);
    for (std::int64_t k = begin; k < end; ++k) {
      const double weight = 1.0 - std::abs(static_cast<double>(k) + 0.5 - x) / m_blur;
      out[i].weights.push_back(static_cast<float>(weight / sum));
    }
  }
  return out;
}

LightPlane EyeMeasure::through_lenses(const LightPlane& picture, double part) const {
  LightPlane out{m_lenses, m_height, std::vector<float>(std::size_t{m_lenses} * m_height)};
  std::vector<Taps> lenses;
  for (std::uint32_t row = 0; row < m_height; ++row) {
    if (row == 0 || !m_lens.origins.empty()) lenses = taps(row, part);
    const float* const pixels = picture.values.data() + std::size_t{row} * m_width;
    for (std::uint32_t i = 0; i < m_lenses; ++i) {
      float light = 0.0f;
      for (std::size_t j = 0; j < lenses[i].weights.size(); ++j) {
        light += lenses[i].weights[j] * pixels[lenses[i].first + j];
      }
      out.values[std::size_t{row} * m_lenses + i] = light;
    }
  }
  return out;
}

LightPlane EyeMeasure::seen(const LightPlane& picture, double part) const {
  if (picture.width != m_width || picture.height != m_height) {
    throw std::invalid_argument(core::formed("a picture of %u x %u pixels is expected, not %u x %u",
                                             m_width, m_height, picture.width, picture.height));
  }
  const LightPlane rows_apart = through_lenses(picture, part);
  LightPlane out{m_lenses, rows(), std::vector<float>(std::size_t{m_lenses} * rows())};
  std::vector<double> light(m_lenses);
  for (std::uint32_t row = 0; row < out.height; ++row) {
    std::ranges::fill(light, 0.0);
    for (std::size_t j = 0; j < m_weights.size(); ++j) {
      const float* const from = rows_apart.values.data() + (row + j) * m_lenses;
      for (std::uint32_t i = 0; i < m_lenses; ++i) light[i] += m_weights[j] * from[i];
    }
    for (std::uint32_t i = 0; i < m_lenses; ++i) {
      const double value = is_seen(i, row) ? light[i] : 0.0;
      out.values[std::size_t{row} * m_lenses + i] = static_cast<float>(value);
    }
  }
  return out;
}

SeenDifferences seen_differences(const EyeMeasure& measure, const std::vector<LightPlane>& first,
                                 const std::vector<LightPlane>& second) {
  SeenDifferences out;
  out.largest = {measure.lenses(), measure.rows(), std::vector<float>(first.at(0).values.size())};
  Tally all;
  for (std::size_t p = 0; p < kSeenParts.size(); ++p) {
    Tally tally;
    for (std::uint32_t row = 0; row < measure.rows(); ++row) {
      for (std::uint32_t lens = 0; lens < measure.lenses(); ++lens) {
        if (!measure.is_seen(lens, row)) continue;
        const double a = lightness(first.at(p).at(lens, row)),
                     b = lightness(second.at(p).at(lens, row));
        const auto difference = static_cast<float>(b - a);
        tally.add(difference,
                  {kSeenParts[p], measure.first_lens() + lens, measure.first_row() + row});
        float& largest = out.largest.values[std::size_t{row} * measure.lenses() + lens];
        largest = std::max(largest, std::abs(difference));
      }
    }
    out.parts.push_back(tally.result());
    all.add(tally);
  }
  out.all = all.result();
  return out;
}

}  // namespace lentray::diff
