#include "core/image/quantiser.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/image/srgb.h"

namespace lentray::core {
namespace {

float power(float value, double exponent) {
  return value <= 0.0f ? value : static_cast<float>(std::pow(double{value}, exponent));
}

/// Powers less than a hundredth apart are one; values then stay as they are.
bool is_alike(const ImageFormat& f) {
  if (f.srgb || f.working_srgb) return f.srgb && f.working_srgb;
  return std::fabs(f.working_gamma / f.file_gamma - 1.0) < 0.01;
}

}  // namespace

float linear_of(float value, const ImageFormat& format) {
  if (format.working_srgb) return linear_of_srgb(value);
  return format.working_gamma == 1.0 ? value : power(value, format.working_gamma);
}

unsigned scaled_to_integer(float encoded, int bits) {
  const float max = static_cast<float>((1u << bits) - 1u);
  const float level = std::floor(encoded * max + 0.5f);
  if (!(level > 0.0f)) return 0u;  // NaN too
  return static_cast<unsigned>(std::min(level, max));
}

float encoded(float value, const ImageFormat& format) {
  if (is_alike(format)) return value;
  const float linear = linear_of(value, format);
  if (format.srgb) return srgb_of_linear(linear);
  return format.file_gamma == 1.0 ? linear : power(linear, 1.0 / format.file_gamma);
}

float decoded(float value, const ImageFormat& format) {
  ImageFormat back = format;
  back.working_gamma = format.file_gamma;
  back.working_srgb = format.srgb;
  back.file_gamma = format.working_gamma;
  back.srgb = format.working_srgb;
  return encoded(value, back);
}

unsigned quantised(float value, const ImageFormat& format) {
  return scaled_to_integer(encoded(value, format), format.bits);
}

Quantiser::Quantiser(const ImageFormat& format) : m_format(format) {
  if (format.bits != 8) return;
  // The least float of each level, by halving; floats of one sign are ordered as their bits.
  m_least.push_back(0.0f);
  std::uint32_t least = 0;
  for (unsigned level = 1; level < 256; ++level) {
    std::uint32_t high = std::bit_cast<std::uint32_t>(4.0f);
    while (least < high) {
      const std::uint32_t middle = least + (high - least) / 2;
      if (quantised(std::bit_cast<float>(middle), format) >= level) {
        high = middle;
      } else {
        least = middle + 1;
      }
    }
    m_least.push_back(std::bit_cast<float>(least));
  }
  m_least.push_back(std::numeric_limits<float>::quiet_NaN());  // nothing is beyond 255
  unsigned level = 0;
  m_start.push_back(0);
  for (std::uint32_t place = kFirst + 1; place <= kEnd; ++place) {
    const float value = std::bit_cast<float>(place << kDropped);
    while (value >= m_least[level + 1]) ++level;
    m_start.push_back(static_cast<std::uint8_t>(level));
  }
}

}  // namespace lentray::core
