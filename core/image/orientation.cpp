#include "core/image/orientation.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/memory_limit.h"

namespace lentray::core {
namespace {

/// How to find the stored pixel of a shown one.
struct Turn {
  bool is_across = false;      ///< rows are shown as columns
  bool right_to_left = false;  ///< the stored column 0 is shown at the right, or at the bottom
  bool bottom_to_top = false;  ///< the stored row 0 is shown at the bottom, or at the right
};

Turn turn_of(int orientation) {
  switch (orientation) {
    case 2: return {false, true, false};
    case 3: return {false, true, true};
    case 4: return {false, false, true};
    case 5: return {true, false, false};
    case 6: return {true, false, true};
    case 7: return {true, true, true};
    case 8: return {true, true, false};
    default: return {};
  }
}

void turn_samples(StoredImage& image, const Turn& turn) {
  const std::uint32_t width = turn.is_across ? image.height : image.width,
                      height = turn.is_across ? image.width : image.height;
  image.samples.visit([&](auto& from) {
    check_room(static_cast<double>(from.size() * sizeof from[0]));
    std::decay_t<decltype(from)> to;
    to.reserve(from.size());
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        std::uint32_t column = turn.is_across ? y : x, row = turn.is_across ? x : y;
        if (turn.right_to_left) column = image.width - 1 - column;
        if (turn.bottom_to_top) row = image.height - 1 - row;
        const auto* pixel = from.data() + image.place(column, row, 0);
        to.insert(to.end(), pixel, pixel + image.channels);
      }
    }
    from = std::move(to);
  });
  image.width = width;
  image.height = height;
}

void exchange(std::map<std::string, std::string>& attributes, const char* a, const char* b) {
  const bool has_both = attributes.contains(a) && attributes.contains(b);
  if (has_both) std::swap(attributes[a], attributes[b]);
}

}  // namespace

StoredImage rearranged(const StoredImage& image, const std::vector<std::uint32_t>& columns,
                       const std::vector<std::uint32_t>& rows) {
  const auto channels = static_cast<std::size_t>(image.channels);
  StoredImage out{.width = static_cast<std::uint32_t>(columns.size()),
                  .height = static_cast<std::uint32_t>(rows.size()),
                  .channels = image.channels,
                  .bits = image.bits,
                  .gamma = image.gamma,
                  .premultiplied = image.premultiplied,
                  .samples = {},
                  .entries = {},
                  .attributes = image.attributes,
                  .profile = image.profile};
  image.samples.visit([&](const auto& from) {
    check_room(static_cast<double>(columns.size() * rows.size() * channels * sizeof from[0]));
    std::decay_t<decltype(from)> to;
    to.reserve(columns.size() * rows.size() * channels);
    for (const std::uint32_t row : rows) {
      const auto* line = from.data() + std::size_t{row} * image.width * channels;
      for (const std::uint32_t column : columns) {
        const auto* pixel = line + column * channels;
        to.insert(to.end(), pixel, pixel + channels);
      }
    }
    out.samples.store(std::move(to));
  });
  return out;
}

StoredImage upright(StoredImage image, int orientation) {
  if (orientation <= 1 || orientation > 8) return image;
  const Turn turn = turn_of(orientation);
  turn_samples(image, turn);
  image.entries.clear();
  if (turn.is_across) exchange(image.attributes, "XResolution", "YResolution");
  return image;
}

}  // namespace lentray::core
