#include "tools/lentray-views/page_strips.h"

#include <optional>

#include "core/image/thumbnail.h"
#include "core/image/writer.h"
#include "tools/common/page_text.h"
#include "tools/lentray-views/moving.h"
#include "tools/lentray-views/picture.h"
#include "tools/lentray-views/resize.h"

namespace lentray::views {
namespace {

using core::StoredImage;

/// RGB of 8 bits and sRGB's curve; what is transparent stands before black.
StoredImage opaque_rgb(const StoredImage& image) {
  if (image.bits == 8 && image.gamma <= 0.0 && image.channels == 3) return image;
  const Light light = light_of(image);
  Light colours{light.width, light.height, 3, {}};
  colours.values.reserve(std::size_t{3} * light.width * light.height);
  for (std::uint32_t row = 0; row < light.height; ++row) {
    for (std::uint32_t column = 0; column < light.width; ++column) {
      const float* const pixel = light.pixel(column, row);
      for (std::size_t c = 0; c < 3; ++c)
        colours.values.push_back(light.channels < 3 ? pixel[0] : pixel[c]);
    }
  }
  return for_viewers(colours);
}

/// A picture for each place behind the lenses; black where a lens has fewer columns than others.
std::vector<StoredImage> strips_of(const StoredImage& image, const camera::LensSheet& sheet) {
  std::vector<StoredImage> strips;
  std::int64_t lens = -1;
  std::size_t place = 0;
  for (std::uint32_t k = 0; k < sheet.width(); ++k) {
    place = sheet.lens_of(k) == lens ? place + 1 : 0;
    lens = sheet.lens_of(k);
    if (place == strips.size())
      strips.push_back(blank_like(image, sheet.lens_count(), image.height));
    copy_pixels(image, {k, 0, 1, image.height}, strips[place], static_cast<std::uint32_t>(lens), 0);
  }
  return strips;
}

std::string jpeg_strip(const StoredImage& strip, int quality) {
  core::Thumbnail picture{strip.width, strip.height, {}};
  picture.rgb.reserve(strip.samples.size());
  for (std::size_t i = 0; i < strip.samples.size(); ++i)
    picture.rgb.push_back(static_cast<std::uint8_t>(strip.samples[i]));
  return core::jpeg_of(picture, quality);
}

/// Nothing where they take more than the limit.
std::optional<std::vector<std::string>> coded(const std::vector<StoredImage>& strips, int quality,
                                              std::size_t limit) {
  std::vector<std::string> links;
  std::size_t bytes = 0;
  for (const StoredImage& strip : strips) {
    links.push_back(quality == 0
                        ? "data:image/png;base64," + tool::base64(png_of(strip))
                        : "data:image/jpeg;base64," + tool::base64(jpeg_strip(strip, quality)));
    bytes += links.back().size() + 3;  // quotes and comma
    if (bytes > limit) return std::nullopt;
  }
  return links;
}

std::vector<StoredImage> in_rows(const std::vector<StoredImage>& strips, std::uint32_t rows) {
  std::vector<StoredImage> out;
  for (const StoredImage& strip : strips)
    out.push_back(resized(strip, strip.width, rows, Filter::kTriangle));
  return out;
}

}  // namespace

PageStrips page_strips(const StoredImage& integral, const camera::LensSheet& sheet,
                       std::size_t limit) {
  const std::vector<StoredImage> strips = strips_of(opaque_rgb(integral), sheet);
  for (const int quality : {0, 95, 90, 84}) {
    if (auto links = coded(strips, quality, limit))
      return {std::move(*links), integral.height, quality};
  }
  constexpr int kQuality = 84;
  for (double rows = 0.75 * integral.height; rows >= 1.0; rows *= 0.75) {
    const auto whole = static_cast<std::uint32_t>(rows);
    if (auto links = coded(in_rows(strips, whole), kQuality, limit))
      return {std::move(*links), whole, kQuality};
  }
  throw core::ImageError("the picture does not go into a page of that size: raise --page-limit");
}

}  // namespace lentray::views
