// Rows of a picture as a file's samples: straight or premultiplied, encoded, dithered, rounded.
// Space: the format's; alpha is a share, not light, and has no gamma. Errors: none. One thread.
// Source: measured on stock, tests/image/file_types_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/image/dither.h"
#include "core/image/image.h"
#include "core/image/quantiser.h"
#include "core/image/writer.h"

namespace lentray::core {

/// Samples of a pixel are side by side: grey or R, G, B, then alpha; Radiance's are its four bytes.
class SampleRows {
 public:
  SampleRows(const ImageFormat& format, std::uint32_t width);
  /// The next rows of the picture, which are those of the band from `first` on. Until the next call.
  const void* next(const Image& band, std::uint32_t first, std::uint32_t rows);

 private:
  /// What a pixel's samples say, before they are encoded.
  Channels values(const float* pixel) const;
  template <class Sample>
  void plain(const float* from, std::size_t pixels, std::vector<Sample>& samples) const;
  template <class Sample, class Quantise>
  void plain_by(const Quantise& quantise, const float* from, std::size_t pixels, Sample* to) const;
  template <class Sample>
  void dithered(const float* from, std::uint32_t rows, std::vector<Sample>& samples);
  void floats(const float* from, std::size_t pixels);
  void radiance(const float* from, std::uint32_t rows);
  unsigned spread(unsigned level) const;

  ImageFormat m_format;  ///< its bits are those that carry information
  const StoredAs m_stored;
  const std::uint32_t m_width;
  const int m_colours, m_channels;
  const bool m_spreads;  ///< the levels are spread over all bits
  const Quantiser m_quantise;
  std::optional<Dither> m_dither{};
  std::uint32_t m_row = 0;
  std::vector<std::uint8_t> m_bytes{};
  std::vector<std::uint16_t> m_words{};
  std::vector<float> m_floats{};
};

}  // namespace lentray::core
