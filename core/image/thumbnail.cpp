#include "core/image/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

#include "core/image/orientation.h"
#include "core/image/srgb.h"
#include "core/numeric/lens_columns.h"

namespace lentray::core {
namespace {

constexpr std::size_t kChannels =
    4;  ///< of sums: red, green, blue, by which alpha is multiplied, and alpha

/// How much of a target a source gives, of 1.
struct Share {
  std::uint32_t source = 0, target = 0;
  float weight = 0.0f;
};

/// `sources` laid over `targets`, both evenly: in ascending order of sources.
std::vector<Share> shares(std::size_t sources, std::uint32_t targets) {
  std::vector<Share> all;
  const auto n = static_cast<double>(sources);
  for (std::size_t s = 0; s < sources; ++s) {
    const double from = static_cast<double>(s) * targets / n,
                 to = static_cast<double>(s + 1) * targets / n;
    for (auto t = static_cast<std::uint32_t>(from); t < targets && t < to; ++t) {
      const double part = std::min(to, t + 1.0) - std::max(from, static_cast<double>(t));
      if (part > 1e-9) all.push_back({static_cast<std::uint32_t>(s), t, static_cast<float>(part)});
    }
  }
  return all;
}

/// Linear light of the samples that integers can have.
class Decoder {
 public:
  explicit Decoder(const StoredImage& image) : m_gamma(image.gamma) {
    if (image.bits == 32) return;
    const std::size_t count = std::size_t{1} << image.bits;
    m_table.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      m_table[i] = of(static_cast<float>(i) / static_cast<float>(count - 1));
  }
  float operator()(float sample) const {
    return m_table.empty()
               ? of(sample)
               : m_table[std::min(static_cast<std::size_t>(sample), m_table.size() - 1)];
  }

 private:
  float of(float value) const {
    if (!(value > 0.0f)) return 0.0f;  // NaN too
    const float clipped = std::min(value, 1.0f);
    if (m_gamma <= 0.0) return linear_of_srgb(clipped);
    return m_gamma == 1.0 ? clipped : static_cast<float>(std::pow(double{clipped}, m_gamma));
  }
  double m_gamma;
  std::vector<float> m_table{};
};

/// Linear light, one row after another.
class Rows {
 public:
  explicit Rows(const StoredImage& image)
      : m_image(image), m_decode(image), m_most(image.most()), m_row(kChannels * image.width) {}

  const float* operator[](std::uint32_t row) {
    const int channels = m_image.channels;
    std::size_t from = m_image.place(0, row, 0);
    float* to = m_row.data();
    for (std::uint32_t x = 0; x < m_image.width;
         ++x, from += static_cast<std::size_t>(channels), to += kChannels) {
      for (std::size_t c = 0; c < 3; ++c)
        to[c] = m_decode(m_image.samples[from + (channels < 3 ? 0 : c)]);
      to[3] = 1.0f;
      if (m_image.has_alpha())
        put_alpha(to, m_image.samples[from + static_cast<std::size_t>(channels - 1)] / m_most);
    }
    return m_row.data();
  }

 private:
  void put_alpha(float* pixel, float alpha) const {
    pixel[3] = alpha > 0.0f ? std::min(alpha, 1.0f) : 0.0f;
    if (m_image.premultiplied) return;
    for (int c = 0; c < 3; ++c) pixel[c] *= pixel[3];
  }
  const StoredImage& m_image;
  const Decoder m_decode;
  const float m_most;
  std::vector<float> m_row;
};

/// Sums of one thumbnail: columns of the picture, in any choice, over its width.
class Average {
 public:
  Average(std::vector<std::uint32_t> columns, ThumbnailSize size)
      : m_columns(std::move(columns)), m_size(size), m_shares(shares(m_columns.size(), size.width)),
        m_row(kChannels * size.width), m_sums(m_row.size() * size.height) {}

  void take_row(const float* row) {
    std::fill(m_row.begin(), m_row.end(), 0.0f);
    for (const Share& share : m_shares) {
      const float* from = row + kChannels * m_columns[share.source];
      float* to = m_row.data() + kChannels * share.target;
      for (std::size_t c = 0; c < kChannels; ++c) to[c] += share.weight * from[c];
    }
  }
  void add_row(std::uint32_t target, float weight) {
    float* to = m_sums.data() + m_row.size() * target;
    for (std::size_t i = 0; i < m_row.size(); ++i) to[i] += weight * m_row[i];
  }
  Thumbnail result() const;

 private:
  const std::vector<std::uint32_t> m_columns;
  const ThumbnailSize m_size;
  const std::vector<Share> m_shares;
  std::vector<float> m_row, m_sums;
};

constexpr std::size_t kCurveSteps = 1 << 14;

std::uint8_t stored(float linear) {
  static const std::vector<std::uint8_t> table = [] {
    std::vector<std::uint8_t> all(kCurveSteps + 1);
    for (std::size_t i = 0; i <= kCurveSteps; ++i) {
      const float value = srgb_of_linear(static_cast<float>(i) / float{kCurveSteps});
      all[i] = static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
    }
    return all;
  }();
  return table[static_cast<std::size_t>(std::clamp(linear, 0.0f, 1.0f) * float{kCurveSteps} +
                                        0.5f)];
}

Thumbnail Average::result() const {
  constexpr std::uint32_t kSquare = 8;
  constexpr std::array<float, 2> kBehind{0.6f, 0.32f};  // light
  Thumbnail out{m_size.width, m_size.height, {}};
  out.rgb.resize(std::size_t{3} * out.width * out.height);
  std::uint8_t* to = out.rgb.data();
  const float* sum = m_sums.data();
  for (std::uint32_t y = 0; y < out.height; ++y) {
    for (std::uint32_t x = 0; x < out.width; ++x, sum += kChannels) {
      const float behind =
          kBehind[(x / kSquare + y / kSquare) % 2] * (1.0f - std::min(1.0f, sum[3]));
      for (std::size_t c = 0; c < 3; ++c) *to++ = stored(sum[c] + behind);
    }
  }
  return out;
}

std::vector<Thumbnail> averages(const StoredImage& image,
                                std::vector<std::vector<std::uint32_t>> choices,
                                ThumbnailSize size) {
  if (image.width == 0 || image.height == 0 || size.width == 0 || size.height == 0) {
    throw std::invalid_argument("a thumbnail of no pixels");
  }
  std::vector<Average> all;
  all.reserve(choices.size());
  for (auto& columns : choices) {
    if (columns.empty()) throw std::invalid_argument("a view of no columns");
    all.emplace_back(std::move(columns), size);
  }
  Rows rows(image);
  std::uint32_t taken = image.height;
  for (const Share& share : shares(image.height, size.height)) {
    if (share.source != taken) {
      const float* row = rows[share.source];
      for (Average& average : all) average.take_row(row);
      taken = share.source;
    }
    for (Average& average : all) average.add_row(share.target, share.weight);
  }
  std::vector<Thumbnail> out;
  for (const Average& average : all) out.push_back(average.result());
  return out;
}

}  // namespace

std::vector<std::uint32_t> view_columns(std::uint32_t width, double lens_pixels, double view) {
  if (!(lens_pixels >= 1.0)) throw std::invalid_argument("a lens of less than a pixel");
  const auto lenses = static_cast<std::size_t>(
      std::max<std::int64_t>(1, LensColumns{lens_pixels}.whole_lenses(width)));
  std::vector<std::uint32_t> columns;
  for (std::size_t lens = 0; lens < lenses; ++lens) {
    const double column = std::floor(view + lens_pixels * static_cast<double>(lens) + 0.5);
    columns.push_back(static_cast<std::uint32_t>(std::clamp(column, 0.0, width - 1.0)));
  }
  return columns;
}

Thumbnail thumbnail_of(const StoredImage& image, ThumbnailSize size) {
  std::vector<std::uint32_t> columns(image.width);
  std::iota(columns.begin(), columns.end(), 0u);
  return averages(image, {std::move(columns)}, size).front();
}

std::vector<Thumbnail> view_thumbnails(const StoredImage& image, double lens_pixels,
                                       const std::vector<double>& views, ThumbnailSize size) {
  std::vector<std::vector<std::uint32_t>> choices;
  for (const double view : views) choices.push_back(view_columns(image.width, lens_pixels, view));
  return averages(image, std::move(choices), size);
}

Thumbnail upright(Thumbnail thumbnail, int orientation) {
  if (orientation != kTurned) return thumbnail;
  Thumbnail out{thumbnail.height, thumbnail.width, {}};
  out.rgb.reserve(thumbnail.rgb.size());
  for (std::uint32_t y = 0; y < out.height; ++y) {
    for (std::uint32_t x = 0; x < out.width; ++x) {
      const std::size_t row = thumbnail.height - 1 - x;
      const auto from =
          thumbnail.rgb.begin() + static_cast<std::ptrdiff_t>(3 * (row * thumbnail.width + y));
      out.rgb.insert(out.rgb.end(), from, from + 3);
    }
  }
  return out;
}

Thumbnail stacked(const std::vector<Thumbnail>& thumbnails) {
  Thumbnail all;
  for (const Thumbnail& one : thumbnails) {
    all.width = one.width;
    all.height += one.height;
    all.rgb.insert(all.rgb.end(), one.rgb.begin(), one.rgb.end());
  }
  return all;
}

}  // namespace lentray::core
