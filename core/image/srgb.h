// The transfer curve of sRGB, both ways: linear light and stored values, 0 to 1, in single precision as stock.
// Pure, any number of threads. Source: IEC 61966-2-1; measured on stock, tests/unit/image/image_files_test.
#pragma once

#include <cmath>

namespace lentray::core {

inline float srgb_of_linear(float v) {
  return v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
}
inline float linear_of_srgb(float v) {
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

}  // namespace lentray::core
