// Linear light to the integers of a file, many values at a time.
// Immutable, any number of threads. Source: measured on stock, tests/unit/image/image_files_test.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/image/writer.h"

namespace lentray::core {

/// 8 bits by a table of the least value of each level; 16 bits by the formula.
class Quantiser {
 public:
  explicit Quantiser(const ImageFormat& format);
  /// As quantised().
  unsigned operator()(float value) const {
    return m_least.empty() ? quantised(value, m_format) : table()(value);
  }

  /// Borrows; to be had once for many values.
  class Table {
   public:
    unsigned operator()(float value) const {
      if (!(value > 0.0f)) return 0u;  // NaN too
      const std::uint32_t place = std::bit_cast<std::uint32_t>(value) >> kDropped;
      unsigned level = m_start[std::clamp(place, kFirst, kEnd) - kFirst];
      while (value >= m_least[level + 1]) ++level;
      return level;
    }

   private:
    friend class Quantiser;
    Table(const float* least, const std::uint8_t* start) : m_least(least), m_start(start) {}
    const float* m_least;
    const std::uint8_t* m_start;
  };
  bool has_table() const { return !m_least.empty(); }
  Table table() const { return {m_least.data(), m_start.data()}; }

 private:
  // The table's places: positive floats by their leading bits, from 2^-12 up to 1; smaller ones
  // share the first place, greater ones the last.
  static constexpr int kDropped = 15;  ///< bits that are left out: 8 of the fraction stay
  static constexpr std::uint32_t kFirst = ((127u - 12u) << 8) - 1, kEnd = (127u << 8) - 1;

  ImageFormat m_format;
  std::vector<float> m_least;         ///< of level k, k = 1..256 (no number); empty: no table
  std::vector<std::uint8_t> m_start;  ///< by the leading bits of a value: its level or less
};

/// A value in the picture's working space as linear light, and as the file encodes it; and back.
float linear_of(float value, const ImageFormat& format);
float encoded(float value, const ImageFormat& format);
float decoded(float value, const ImageFormat& format);

/// clip(floor(v * max + 0.5)); NaN becomes 0.
unsigned scaled_to_integer(float encoded, int bits);

}  // namespace lentray::core
