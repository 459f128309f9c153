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
using core::StoredImage;

void refuse_view(std::uint32_t view, std::uint32_t count) {
  throw core::ImageError("there is no view " + std::to_string(view) + ": the views are 0 to " +
                         std::to_string(count - 1));
}

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
  if (width == 0) refuse_view(view, count);
  return seen_at(integral, width, false, [&](std::uint32_t i, std::uint32_t) {
    return static_cast<double>(camera::view_column(sheet.lens().pixels, view, count, i));
  });
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

StoredImage seen_at(const StoredImage& integral, std::uint32_t width, bool between,
                    const PlaceInPrint& place_of) {
  const auto is_in = [&](double column) { return column >= 0.0 && column < integral.width; };
  if (!between) {
    StoredImage out = blank_like(integral, width, integral.height);
    for (std::uint32_t row = 0; row < integral.height; ++row) {
      for (std::uint32_t i = 0; i < width; ++i) {
        const double column = std::floor(place_of(i, row) + 0.5);
        if (!is_in(column)) continue;
        copy_pixels(integral, {static_cast<std::uint32_t>(column), row, 1, 1}, out, i, row);
      }
    }
    return out;
  }
  const Light from = light_of(integral);
  Light to{width, integral.height, from.channels, {}};
  to.values.resize(std::size_t{width} * integral.height * static_cast<std::size_t>(to.channels));
  for (std::uint32_t row = 0; row < integral.height; ++row) {
    for (std::uint32_t i = 0; i < width; ++i) {
      const double place = place_of(i, row), left = std::floor(place);
      const auto share = static_cast<float>(place - left);
      for (const auto& [column, weight] :
           {std::pair(left, 1.0f - share), std::pair(left + 1.0, share)}) {
        if (!is_in(column) || weight == 0.0f) continue;
        const float* const pixel = from.pixel(static_cast<std::uint32_t>(column), row);
        for (int c = 0; c < to.channels; ++c) to.pixel(i, row)[c] += weight * pixel[c];
      }
    }
  }
  return stored(to, integral);
}

StoredImage seen_by(const StoredImage& integral, const camera::LensSheet& sheet, const Eye& eye,
                    bool between) {
  const std::vector<double> places = places_seen(sheet, eye);
  return seen_at(integral, static_cast<std::uint32_t>(places.size()), between,
                 [&](std::uint32_t i, std::uint32_t) { return places[i]; });
}

}  // namespace lentray::views
