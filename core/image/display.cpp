#include "core/image/display.h"

#include <algorithm>
#include <cmath>

#include "core/image/srgb.h"

namespace lentray::core {
namespace {

/// 0 to 1, for a display of sRGB's curve.
float shown(float value, double gamma) {
  if (gamma > 0.0) {
    const float linear = value <= 0.0f ? 0.0f : static_cast<float>(std::pow(double{value}, gamma));
    value = srgb_of_linear(linear);
  }
  return std::clamp(value, 0.0f, 1.0f);
}

}  // namespace

bool is_shown_as_stored(const StoredImage& image) {
  return image.bits != 32 && !image.has_alpha() && image.gamma <= 0.0;
}

StoredImage without_alpha(const StoredImage& image) {
  StoredImage out = image;
  out.channels = image.channels - (image.has_alpha() ? 1 : 0);
  out.samples.assign(
      std::size_t{image.width} * image.height * static_cast<std::size_t>(out.channels), 0.0f);
  std::size_t to = 0;
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    const auto channel = static_cast<int>(i % static_cast<std::size_t>(image.channels));
    if (channel < out.channels) out.samples[to++] = image.samples[i];
  }
  return out;
}

StoredImage displayed(const StoredImage& image) {
  constexpr float kScale = 255.0f;
  const float most = image.most();
  StoredImage out;
  out.width = image.width;
  out.height = image.height;
  out.channels = 3;
  out.attributes = image.attributes;
  out.samples.assign(std::size_t{3} * image.width * image.height, 0.0f);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const float alpha = image.has_alpha()
                              ? std::clamp(image.at(x, y, image.channels - 1) / most, 0.0f, 1.0f)
                              : 1.0f;
      const float behind = (x / kCheckerSize + y / kCheckerSize) % 2 == 0 ? 0.0f : 1.0f;
      for (int c = 0; c < 3; ++c) {
        float value = image.at(x, y, image.channels < 3 ? 0 : c) / most;
        if (image.premultiplied && alpha > 0.0f) value /= alpha;
        out.at(x, y, c) = kScale * (shown(value, image.gamma) * alpha + behind * (1.0f - alpha));
      }
    }
  }
  return out;
}

}  // namespace lentray::core
