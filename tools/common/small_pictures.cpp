#include "tools/common/small_pictures.h"

#include <algorithm>
#include <cmath>

namespace lentray::tool {

using core::ThumbnailSize;

ThumbnailSize size_within(std::uint32_t width, std::uint32_t height, std::uint32_t across,
                          std::uint32_t side) {
  const double scale = std::min(1.0, static_cast<double>(side) / std::max({1u, width, height}));
  const auto scaled = [&](std::uint32_t length) {
    return std::max(1u, static_cast<std::uint32_t>(std::lround(length * scale)));
  };
  return {std::min(scaled(width), std::max(1u, across)), scaled(height)};
}

std::size_t bytes_within(std::size_t bytes, std::size_t pixels) {
  constexpr std::size_t kHead = 800, kPixelsAByte = 3;
  return std::min(bytes, kHead + pixels / kPixelsAByte);
}

std::string jpeg_within(const core::Thumbnail& thumbnail, std::size_t most, int best) {
  for (const int quality : {95, 90, 84, 76, 66, 54, 40, 26, 12}) {
    if (quality > best) continue;
    std::string jpeg = core::jpeg_of(thumbnail, quality);
    if (jpeg.size() <= most) return jpeg;
  }
  return {};
}

std::size_t bytes_in_page(std::size_t bytes) {
  constexpr std::size_t kAround = 40;
  return bytes == 0 ? 0 : (bytes + 2) / 3 * 4 + kAround;
}

}  // namespace lentray::tool
