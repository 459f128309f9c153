// Pictures of stock's mesh_camera.
#pragma once

#include "core/image/reader.h"

namespace lentray::test {

/// Stock 3.7 shows the first row of a mesh_camera twice.
inline core::StoredImage without_first_row(const core::StoredImage& image) {
  core::StoredImage out = image;
  --out.height;
  const std::size_t row = std::size_t{image.width} * static_cast<std::size_t>(image.channels);
  out.samples = {};
  out.samples.resize(row * out.height);
  for (std::size_t i = 0; i < row * out.height; ++i) out.samples[i] = image.samples[i + row];
  return out;
}

}  // namespace lentray::test
