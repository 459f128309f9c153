#include "tools/lentray-print/pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "camera/text.h"
#include "core/base/memory_limit.h"
#include "core/image/quantiser.h"
#include "core/image/srgb.h"
#include "tools/lentray-print/page_error.h"

namespace lentray::print {

using core::StoredImage;

namespace {

/// Calls `work` with the vector of samples as they are stored, and with an empty one for the result.
template <class Work>
void with_samples(core::Samples& samples, const Work& work) {
  const auto go = [&]<class Value>(Value) {
    std::vector<Value> from = samples.take<Value>();
    std::vector<Value> to;
    work(from, to);
    samples.store(std::move(to));
  };
  if (samples.is_stored_as<std::uint8_t>()) {
    go(std::uint8_t{});
  } else if (samples.is_stored_as<std::uint16_t>()) {
    go(std::uint16_t{});
  } else {
    go(0.0f);
  }
}

std::vector<std::uint32_t> counted(std::uint32_t count) {
  std::vector<std::uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

void check_room_of(std::size_t samples, std::size_t bytes) {
  core::check_room(static_cast<double>(samples) * static_cast<double>(bytes));
}

}  // namespace

StoredImage rearranged(StoredImage image, const std::vector<std::uint32_t>& columns,
                       const std::vector<std::uint32_t>& rows) {
  const auto channels = static_cast<std::size_t>(image.channels);
  with_samples(image.samples, [&](const auto& from, auto& to) {
    check_room_of(columns.size() * rows.size() * channels, sizeof(from[0]));
    to.reserve(columns.size() * rows.size() * channels);
    for (const std::uint32_t row : rows) {
      const auto* line = from.data() + std::size_t{row} * image.width * channels;
      for (const std::uint32_t column : columns) {
        const auto* pixel = line + column * channels;
        to.insert(to.end(), pixel, pixel + channels);
      }
    }
  });
  image.width = static_cast<std::uint32_t>(columns.size());
  image.height = static_cast<std::uint32_t>(rows.size());
  image.entries.clear();
  return image;
}

StoredImage mirrored(StoredImage image) {
  std::vector<std::uint32_t> columns = counted(image.width);
  std::ranges::reverse(columns);
  const std::vector<std::uint32_t> rows = counted(image.height);
  return rearranged(std::move(image), columns, rows);
}

StoredImage turned(StoredImage image) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t width = image.width, height = image.height;
  with_samples(image.samples, [&](const auto& from, auto& to) {
    check_room_of(from.size(), sizeof(from[0]));
    to.resize(from.size());
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t column = 0; column < width; ++column) {
        const auto* pixel = from.data() + (row * width + column) * channels;
        std::copy(pixel, pixel + channels,
                  to.begin() + static_cast<std::ptrdiff_t>((column * height + (height - 1 - row)) *
                                                           channels));
      }
    }
  });
  std::swap(image.width, image.height);
  image.entries.clear();
  return image;
}

StoredImage as_printed(StoredImage image, int bits, Colour background) {
  const bool has_alpha = image.channels == 2 || image.channels == 4;
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
  const float most = image.bits == 32 ? 1.0f : static_cast<float>((1u << image.bits) - 1u);
  const std::size_t pixels = std::size_t{image.width} * image.height;
  const auto convert = [&](auto& to) {
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
  };
  const std::size_t count = pixels * static_cast<std::size_t>(out.channels);
  check_room_of(count, static_cast<std::size_t>(bits / 8));
  if (bits == 8) {
    convert(out.samples.store<std::uint8_t>(count));
  } else {
    convert(out.samples.store<std::uint16_t>(count));
  }
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
  const std::uint32_t width = image.width, height = image.height;
  return rearranged(std::move(image), continued_columns(0, columns, width, lenses),
                    continued_rows(0, height, height));
}

}  // namespace lentray::print
