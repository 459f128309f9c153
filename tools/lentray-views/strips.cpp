#include "tools/lentray-views/strips.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "camera/lenticular.h"
#include "core/image/writer.h"
#include "tools/lentray-views/picture.h"

namespace lentray::views {
namespace {

using core::StoredImage;

bool is_in(double column, std::uint32_t width) { return column >= 0.0 && column < width; }

}  // namespace

std::vector<double> places_seen(const camera::LensSheet& sheet, const Eye& eye) {
  const camera::LensParameters& lens = sheet.lens();
  const double tangent = std::tan(eye.angle * std::numbers::pi / 180.0);
  std::vector<double> out;
  for (std::uint32_t i = 0; i < sheet.lens_count(); ++i) {
    const double axis = (i + 0.5 - 0.5 * sheet.lenses()) * lens.pitch;
    const double slope = (eye.distance > 0.0 ? axis / eye.distance : 0.0) - tangent;
    const double print = axis + camera::offset_of(lens, slope);
    out.push_back((print - sheet.column(0).centre) / lens.pixel_size());
  }
  return out;
}

StoredImage view_of(const StoredImage& integral, const camera::LensSheet& sheet, std::uint32_t view,
                    std::uint32_t count) {
  const std::uint32_t width = view < count ? camera::view_width(sheet, view, count) : 0;
  if (width == 0) {
    throw core::ImageError("there is no view " + std::to_string(view) + ": the views are 0 to " +
                           std::to_string(count - 1));
  }
  StoredImage out = blank_like(integral, width, integral.height);
  for (std::uint32_t i = 0; i < width; ++i) {
    const auto column =
        static_cast<std::uint32_t>(camera::view_column(sheet.lens().pixels, view, count, i));
    copy_pixels(integral, {column, 0, 1, integral.height}, out, i, 0);
  }
  return out;
}

StoredImage lens_of(const StoredImage& integral, const camera::LensSheet& sheet,
                    std::uint32_t lens) {
  std::uint32_t first = sheet.width(), end = 0;
  for (std::uint32_t k = 0; k < sheet.width(); ++k) {
    if (sheet.lens_of(k) != lens) continue;
    first = std::min(first, k);
    end = k + 1;
  }
  if (first >= end) {
    throw core::ImageError("there is no lens " + std::to_string(lens) + ": the lenses are 0 to " +
                           std::to_string(sheet.lens_count() - 1));
  }
  StoredImage out = blank_like(integral, end - first, integral.height);
  copy_pixels(integral, {first, 0, end - first, integral.height}, out, 0, 0);
  return out;
}

StoredImage seen_by(const StoredImage& integral, const camera::LensSheet& sheet, const Eye& eye,
                    bool between) {
  const std::vector<double> places = places_seen(sheet, eye);
  const auto width = static_cast<std::uint32_t>(places.size());
  if (!between) {
    StoredImage out = blank_like(integral, width, integral.height);
    for (std::uint32_t i = 0; i < width; ++i) {
      const double column = std::floor(places[i] + 0.5);
      if (!is_in(column, integral.width)) continue;
      copy_pixels(integral, {static_cast<std::uint32_t>(column), 0, 1, integral.height}, out, i, 0);
    }
    return out;
  }
  const Light from = light_of(integral);
  Light to{width, integral.height, from.channels, {}};
  to.values.resize(std::size_t{width} * integral.height * static_cast<std::size_t>(to.channels));
  for (std::uint32_t i = 0; i < width; ++i) {
    const double left = std::floor(places[i]);
    const auto share = static_cast<float>(places[i] - left);
    for (const auto& [column, weight] :
         {std::pair(left, 1.0f - share), std::pair(left + 1.0, share)}) {
      if (!is_in(column, integral.width) || weight == 0.0f) continue;
      for (std::uint32_t row = 0; row < integral.height; ++row) {
        const float* const pixel = from.pixel(static_cast<std::uint32_t>(column), row);
        for (int c = 0; c < to.channels; ++c) to.pixel(i, row)[c] += weight * pixel[c];
      }
    }
  }
  return stored(to, integral);
}

}  // namespace lentray::views
