// Dithering: quantisation errors are spread over neighbours, or a fixed pattern is laid over the picture.
// Space: light in the picture's working space; levels are steps of the file's integers. Pixels come row by row
// from the top, each row from the left. One thread. Source: reference manual 3.7, "Output File Dithering"; the
// weights and their order measured on stock, tests/image/file_types_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/image/writer.h"

namespace lentray::core {

/// R, G, B and alpha, or grey in the first.
using Channels = std::array<float, 4>;

class Dither {
 public:
  Dither(DitherMethod method, std::uint32_t width);

  struct Offset {
    Channels light{};     ///< to be added to the pixel's values
    float levels = 0.0f;  ///< to be added to each encoded value before it is rounded
  };
  Offset offset(std::uint32_t x, std::uint32_t y) const;
  /// What the file's value of that pixel lacks, light offset included. For every pixel after offset().
  void lacks(std::uint32_t x, const Channels& error);

 private:
  using Row = std::vector<Channels>;  ///< of pixel x at x + 1
  void next_row();

  const DitherMethod m_method;
  Row m_this, m_next;
  Channels m_last{};
};

}  // namespace lentray::core
