#include "core/image/sample_rows.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/color.h"

namespace lentray::core {
namespace {

/// Where nothing hides the background there may be light all the same.
constexpr float kLeastAlpha = 1e-6f;

ImageFormat with_levels(ImageFormat format) {
  format.bits = stored_as(format).levels;
  return format;
}

}  // namespace

SampleRows::SampleRows(const ImageFormat& format, std::uint32_t width)
    : m_format(with_levels(format)), m_stored(stored_as(format)), m_width(width),
      m_colours(m_stored.grey ? 1 : 3), m_channels(m_colours + (m_stored.alpha ? 1 : 0)),
      m_spreads(format.type == FileType::png && m_stored.levels != m_stored.bits),
      m_quantise(m_format) {
  const bool dithers = format.type != FileType::jpeg && format.type != FileType::exr;
  if (dithers && format.dither != DitherMethod::none) m_dither.emplace(format.dither, width);
}

const void* SampleRows::next(const Image& band, std::uint32_t first, std::uint32_t rows) {
  const float* from = band.pixel(0, first);
  const std::size_t pixels = std::size_t{m_width} * rows;
  if (m_format.type == FileType::radiance) {
    radiance(from, rows);
  } else if (m_stored.bits == 32) {
    floats(from, pixels);
  } else if (m_stored.bits == 16) {
    m_dither ? dithered(from, rows, m_words) : plain(from, pixels, m_words);
  } else {
    m_dither ? dithered(from, rows, m_bytes) : plain(from, pixels, m_bytes);
  }
  m_row += rows;
  if (m_stored.bits == 32) return m_floats.data();
  return m_stored.bits == 16 ? static_cast<const void*>(m_words.data()) : m_bytes.data();
}

/// A viewer clips colours before it multiplies them by alpha; so a pixel that is brighter than it is opaque, such
/// as a highlight on glass, is made more opaque.
Channels SampleRows::values(const float* pixel) const {
  const Rgb rgb{pixel[0], pixel[1], pixel[2]};
  const float bright = grey(rgb);
  Channels out = m_stored.grey ? Channels{bright} : Channels{rgb.r, rgb.g, rgb.b};
  if (!m_stored.alpha) return out;
  float alpha = pixel[3];
  if (alpha >= 1.0f) {
    out[static_cast<std::size_t>(m_colours)] = 1.0f;
    return out;
  }
  if (bright > alpha) alpha = std::min(1.0f, bright);
  const float whole = alpha == 0.0f ? kLeastAlpha : alpha;
  for (int c = 0; c < m_colours; ++c) out[static_cast<std::size_t>(c)] /= whole;
  out[static_cast<std::size_t>(m_colours)] = alpha;
  return out;
}

/// Left to right: the upper bits again in the lower ones.
unsigned SampleRows::spread(unsigned level) const {
  if (!m_spreads) return level;
  const int free = m_stored.bits - m_stored.levels;
  return level << free | level >> (m_stored.levels - free);
}

template <class Sample, class Quantise>
void SampleRows::plain_by(const Quantise& quantise, const float* from, std::size_t pixels,
                          Sample* to) const {
  if (m_channels == 3 && !m_spreads) {
    for (std::size_t p = 0; p < pixels; ++p, from += 4, to += 3) {
      for (int c = 0; c < 3; ++c) to[c] = static_cast<Sample>(quantise(from[c]));
    }
    return;
  }
  for (std::size_t p = 0; p < pixels; ++p, from += 4, to += m_channels) {
    const Channels v = values(from);
    for (int c = 0; c < m_colours; ++c)
      to[c] = static_cast<Sample>(spread(quantise(v[static_cast<std::size_t>(c)])));
    if (m_stored.alpha) {
      to[m_colours] = static_cast<Sample>(
          spread(scaled_to_integer(v[static_cast<std::size_t>(m_colours)], m_format.bits)));
    }
  }
}

template <class Sample>
void SampleRows::plain(const float* from, std::size_t pixels, std::vector<Sample>& samples) const {
  samples.resize(pixels * static_cast<std::size_t>(m_channels));
  if (m_quantise.has_table()) {
    plain_by(m_quantise.table(), from, pixels, samples.data());
  } else {
    plain_by(std::cref(m_quantise), from, pixels, samples.data());
  }
}

template <class Sample>
void SampleRows::dithered(const float* from, std::uint32_t rows, std::vector<Sample>& samples) {
  samples.resize(std::size_t{m_width} * rows * static_cast<std::size_t>(m_channels));
  const float most = static_cast<float>((1u << m_format.bits) - 1u);
  Sample* to = samples.data();
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t x = 0; x < m_width; ++x, from += 4, to += m_channels) {
      const Dither::Offset offset = m_dither->offset(x, m_row + row);
      Channels v = values(from), lacks{};
      for (int i = 0; i < m_channels; ++i) {
        const auto c = static_cast<std::size_t>(i);
        const bool is_alpha = i == m_colours;
        v[c] += offset.light[c];
        const float shown = is_alpha ? v[c] : encoded(v[c], m_format);
        const unsigned level = scaled_to_integer(shown + offset.levels / most, m_format.bits);
        const float stored = static_cast<float>(level) / most;
        lacks[c] = std::clamp(v[c], 0.0f, 1.0f) - (is_alpha ? stored : decoded(stored, m_format));
        to[c] = static_cast<Sample>(spread(level));
      }
      m_dither->lacks(x, lacks);
    }
  }
}

void SampleRows::floats(const float* from, std::size_t pixels) {
  m_floats.resize(pixels * static_cast<std::size_t>(m_channels));
  float* to = m_floats.data();
  for (std::size_t p = 0; p < pixels; ++p, from += 4, to += m_channels) {
    for (int c = 0; c < 3; ++c) to[c] = linear_of(from[c], m_format);
    if (m_stored.alpha) to[3] = from[3];
  }
}

/// Three mantissas of 8 bits and the exponent of the greatest; each stands for the middle of its step.
void SampleRows::radiance(const float* from, std::uint32_t rows) {
  constexpr float kBlack = 1e-32f;
  m_bytes.resize(std::size_t{4} * m_width * rows);
  std::uint8_t* to = m_bytes.data();
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t x = 0; x < m_width; ++x, from += 4, to += 4) {
      const Dither::Offset offset = m_dither ? m_dither->offset(x, m_row + row) : Dither::Offset{};
      Channels v{};
      for (std::size_t c = 0; c < 3; ++c) v[c] = linear_of(from[c], m_format) + offset.light[c];
      const float greatest = std::max({v[0], v[1], v[2]});
      std::fill_n(to, 4, std::uint8_t{0});
      if (!(greatest > kBlack) || !std::isfinite(greatest)) continue;
      int exponent = 0;
      const float scale = static_cast<float>(std::frexp(greatest, &exponent) * 256.0 / greatest);
      Channels lacks{};
      for (std::size_t c = 0; c < 3; ++c) {
        to[c] = static_cast<std::uint8_t>(std::clamp(v[c] * scale + offset.levels, 0.0f, 255.0f));
        lacks[c] = static_cast<float>(v[c] - (to[c] + 0.5) / scale);
      }
      to[3] = static_cast<std::uint8_t>(std::clamp(exponent + 128, 0, 255));
      if (m_dither) m_dither->lacks(x, lacks);
    }
  }
}

}  // namespace lentray::core
