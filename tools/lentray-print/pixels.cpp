#include "tools/lentray-print/pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "camera/text.h"
#include "core/base/memory_limit.h"
#include "core/image/orientation.h"
#include "core/image/quantiser.h"
#include "core/image/srgb.h"
#include "tools/lentray-print/page_error.h"

namespace lentray::print {

using core::StoredImage;

StoredImage as_printed(StoredImage image, int bits, Colour background) {
  const bool has_alpha = image.has_alpha();
  if (!has_alpha && image.bits == bits) {
    image.entries.clear();
    return image;
  }
  StoredImage out;
  out.width = image.width;
  out.height = image.height;
  out.bits = bits;
  const bool is_grey = image.channels < 3 && (!has_alpha || background == kWhite);
  out.channels = is_grey ? 1 : 3;
  out.attributes = std::move(image.attributes);
  out.profile = std::move(image.profile);
  const double behind[] = {background.red, background.green, background.blue};
  const float most = image.most();
  const std::size_t pixels = std::size_t{image.width} * image.height;
  const std::size_t count = pixels * static_cast<std::size_t>(out.channels);
  core::check_room(static_cast<double>(count) * bits / 8);
  out.samples.store_bits(bits, count);
  out.samples.visit([&](auto& to) {
    for (std::size_t p = 0; p < pixels; ++p) {
      const std::size_t from = p * static_cast<std::size_t>(image.channels);
      const float alpha =
          has_alpha ? image.samples[from + static_cast<std::size_t>(image.channels) - 1] / most
                    : 1.0f;
      for (int c = 0; c < out.channels; ++c) {
        const std::size_t source = from + static_cast<std::size_t>(image.channels < 3 ? 0 : c);
        float value = image.samples[source] / most;
        if (image.bits == 32) {
          if (image.premultiplied && alpha > 0.0f) value /= alpha;
          value = core::srgb_of_linear(value);
        }
        if (has_alpha) value = value * alpha + static_cast<float>(behind[c]) * (1.0f - alpha);
        to[p * static_cast<std::size_t>(out.channels) + static_cast<std::size_t>(c)] =
            static_cast<std::decay_t<decltype(to[0])>>(core::scaled_to_integer(value, bits));
      }
    }
  });
  return out;
}

std::vector<std::uint32_t> continued_columns(std::int64_t first, std::uint32_t count,
                                             std::uint32_t width, const core::LensColumns& lenses) {
  const std::int64_t last_lens = lenses.lens_of(std::int64_t{width} - 1);
  std::vector<std::uint32_t> columns;
  for (std::int64_t k = first; k < first + std::int64_t{count}; ++k) {
    const std::int64_t lens = lenses.lens_of(k);
    const std::int64_t nearest = std::clamp(lens, std::int64_t{0}, last_lens);
    // The column nearest to the same place in that lens's strip.
    std::int64_t column =
        std::llround(static_cast<double>(k) + static_cast<double>(nearest - lens) * lenses.pixels);
    if (lenses.lens_of(column) < nearest) ++column;
    if (lenses.lens_of(column) > nearest) --column;
    columns.push_back(
        static_cast<std::uint32_t>(std::clamp(column, std::int64_t{0}, std::int64_t{width} - 1)));
  }
  return columns;
}

std::vector<std::uint32_t> continued_rows(std::int64_t first, std::uint32_t count,
                                          std::uint32_t height) {
  std::vector<std::uint32_t> rows;
  for (std::int64_t row = first; row < first + std::int64_t{count}; ++row) {
    rows.push_back(
        static_cast<std::uint32_t>(std::clamp(row, std::int64_t{0}, std::int64_t{height} - 1)));
  }
  return rows;
}

StoredImage of_whole_lenses(StoredImage image, double lens_pixels) {
  const core::LensColumns lenses{lens_pixels};
  const std::int64_t whole = lenses.whole_lenses(image.width);
  if (whole == 0) {
    throw PageError("the picture is " + std::to_string(image.width) +
                    " pixels wide, less than a lens of " + camera::format(lens_pixels));
  }
  const auto columns = static_cast<std::uint32_t>(lenses.first_column(whole));
  if (columns == image.width) return image;
  return core::rearranged(image, continued_columns(0, columns, image.width, lenses),
                          continued_rows(0, image.height, image.height));
}

}  // namespace lentray::print
