// A picture in memory: linear float RGB + alpha, row 0 on top.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/color.h"

namespace lentray::core {

struct Image {
  std::uint32_t width = 0, height = 0;
  std::vector<float> rgba;  ///< 4 floats a pixel, linear light, alpha 1: opaque, premultiplied

  Image() = default;
  Image(std::uint32_t w, std::uint32_t h)
      : width(w), height(h), rgba(std::size_t{4} * w * h, 0.0f) {}
  float* pixel(std::uint32_t column, std::uint32_t row) {
    return rgba.data() + (std::size_t{row} * width + column) * 4;
  }
  const float* pixel(std::uint32_t column, std::uint32_t row) const {
    return rgba.data() + (std::size_t{row} * width + column) * 4;
  }
};

}  // namespace lentray::core
