#include "core/image/orientation.h"

#include <algorithm>
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

template <typename Value>
void turn_samples(StoredImage& image, const Turn& turn) {
  check_room(static_cast<double>(image.samples.size()) * sizeof(Value));
  const std::vector<Value> from = image.samples.take<Value>();
  std::vector<Value> to;
  to.reserve(from.size());
  const std::uint32_t width = turn.is_across ? image.height : image.width,
                      height = turn.is_across ? image.width : image.height;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      std::uint32_t column = turn.is_across ? y : x, row = turn.is_across ? x : y;
      if (turn.right_to_left) column = image.width - 1 - column;
      if (turn.bottom_to_top) row = image.height - 1 - row;
      const Value* pixel = from.data() + image.place(column, row, 0);
      to.insert(to.end(), pixel, pixel + image.channels);
    }
  }
  image.samples.store(std::move(to));
  image.width = width;
  image.height = height;
}

void exchange(std::map<std::string, std::string>& attributes, const char* a, const char* b) {
  const bool has_both = attributes.contains(a) && attributes.contains(b);
  if (has_both) std::swap(attributes[a], attributes[b]);
}

}  // namespace

StoredImage upright(StoredImage image, int orientation) {
  if (orientation <= 1 || orientation > 8) return image;
  const Turn turn = turn_of(orientation);
  if (image.samples.is_stored_as<std::uint8_t>()) {
    turn_samples<std::uint8_t>(image, turn);
  } else if (image.samples.is_stored_as<std::uint16_t>()) {
    turn_samples<std::uint16_t>(image, turn);
  } else {
    turn_samples<float>(image, turn);
  }
  image.entries.clear();
  if (turn.is_across) exchange(image.attributes, "XResolution", "YResolution");
  return image;
}

}  // namespace lentray::core
