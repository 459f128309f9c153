// Linear light to the integers of a file, many values at a time.
// Immutable, any number of threads. Source: measured on stock, tests/unit/image_files_test.
#pragma once

#include <cstdint>
#include <vector>

#include "core/image/writer.h"

namespace lentray::core {

/// 8 bits by a table of the least value of each level; 16 bits by the formula.
class Quantiser {
 public:
  explicit Quantiser(const ImageFormat& format);
  /// As quantised().
  unsigned operator()(float value) const;

 private:
  ImageFormat m_format;
  std::vector<float> m_least;        ///< of level k, k = 1..255; empty: no table
  std::vector<std::uint8_t> m_start; ///< by the leading bits of a value: its level or less
};

/// A value in the picture's working space as linear light.
float linear_of(float value, const ImageFormat& format);

/// clip(floor(v * max + 0.5)); NaN becomes 0.
unsigned scaled_to_integer(float encoded, int bits);

}  // namespace lentray::core
