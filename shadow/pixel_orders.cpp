#include "shadow/pixel_orders.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "core/base/trimmed.h"
#include "shadow/adaptive_order.h"
#include "shadow/names.h"

namespace lentray::shadow {
namespace {

constexpr double kHighBand = 8.0 * 1024 * 1024;    ///< pixels, where an order gains by height
constexpr double kLowBand = 512.0 * 1024;          ///< pixels, elsewhere
constexpr std::uint32_t kLargestStrip = 1 << 20;   ///< pixels
constexpr std::size_t kHighest = ~std::size_t{0};  ///< all rows are one group

using Numbers = std::array<std::uint32_t, 2>;
using Maker = std::function<OrderPtr(const PixelRegion&)>;

/// The columns [left, right) of an image that are rendered.
struct Columns {
  std::uint32_t left = 0, right = 0;
  const camera::LensSheet* sheet = nullptr;
  const RunMeter* meter = nullptr;
};

Maker in_lists(ColumnLists lists, std::size_t height = kHighest, bool turns = false) {
  return [shared = std::make_shared<const ColumnLists>(std::move(lists)), height, turns](
             const PixelRegion& region) { return make_list_order(region, shared, height, turns); };
}

/// As if all columns that are rendered were one lens.
ColumnLists even_strips(const Columns& columns, std::uint32_t width) {
  return lists_of_strips({{columns.left, columns.right}}, width, columns.left);
}

Maker prepare_rows(const Columns& columns, const Numbers&) {
  return in_lists(even_strips(columns, kLargestStrip), 1);
}

Maker prepare_columns(const Columns& columns, const Numbers&) {
  return in_lists(even_strips(columns, 1));
}

Maker prepare_tiles(const Columns& columns, const Numbers&) {
  return in_lists(even_strips(columns, kTile), kTile);
}

/// Column after column, down and up in turn: neighbours follow each other as along a column, in
/// less memory than a whole column's rays meet.
Maker prepare_serpentine(const Columns& columns, const Numbers&) {
  return in_lists(even_strips(columns, 1), kSerpentine, true);
}

Maker prepare_hilbert(const Columns&, const Numbers&) { return make_hilbert_order; }

/// View j: pixel j, counted from the left, of all lenses; where N is not whole, the last view has
/// only the wider lenses.
Maker prepare_views(const Columns& columns, const Numbers& numbers) {
  if (!columns.sheet) return prepare_rows(columns, numbers);
  return in_lists(lists_of_strips(lenses_of(columns.right, columns.sheet), 1, columns.left, true));
}

Maker prepare_strips(const Columns& columns, const Numbers& numbers) {
  return in_lists(
      lists_of_strips(lenses_of(columns.right, columns.sheet), numbers[0], columns.left),
      numbers[1]);
}

Maker prepare_adaptive(const Columns& columns, const Numbers&) {
  const auto blocks =
      std::make_shared<const LensBlocks>(blocks_of(columns.left, columns.right, columns.sheet));
  return [blocks, meter = columns.meter](const PixelRegion& region) {
    return make_adaptive_order(region, blocks, meter);
  };
}

/// Of all orders those that take the least time on the SPD scenes where light buffers leave no work to
/// a cache, and that need the fewest tests with the cache `last`, or hardly more (docs/paper.md).
Maker prepare_auto(const Columns& columns, const Numbers& numbers) {
  return columns.sheet ? prepare_serpentine(columns, numbers) : prepare_hilbert(columns, numbers);
}

struct Entry {
  std::string_view name;
  Maker (*prepare)(const Columns&, const Numbers&);
  std::size_t takes;  ///< how many numbers in brackets
  Numbers numbers;    ///< where none are given
  /// Bands that are multiples of this many rows leave the order as it is in the whole image;
  /// 0: the higher the better.
  std::uint32_t rows;
};

constexpr Entry kOrders[] = {
    {"auto", prepare_auto, 0, {}, kHilbert},
    {"rows", prepare_rows, 0, {}, 1},
    {"views", prepare_views, 0, {}, 0},
    {"columns", prepare_columns, 0, {}, 0},
    {"combined", prepare_strips, 1, {4, 1}, 1},
    {"strips", prepare_strips, 2, {4, 32}, 1},
    {"tiles", prepare_tiles, 0, {}, kTile},
    {"serpentine", prepare_serpentine, 0, {}, kSerpentine},
    {"hilbert", prepare_hilbert, 0, {}, kHilbert},
    {"adaptive", prepare_adaptive, 0, {}, kBlock},
};

/// An order that was asked for.
struct Asked {
  const Entry* entry = nullptr;
  Numbers numbers{};
  /// Entry::rows, or what the numbers make of it.
  std::uint32_t rows() const { return entry->takes == 2 ? numbers[1] : entry->rows; }
};

[[noreturn]] void refuse_numbers(std::string_view text, const Entry& entry) {
  std::string why = "pixel order '" + std::string(text) + "': " + std::string(entry.name);
  if (entry.takes == 0) why += " takes no numbers";
  if (entry.takes == 1) why += " takes a width of 1 or more pixels, such as combined(4)";
  if (entry.takes == 2) {
    why += " takes a width and a height of 1 or more pixels, such as strips(4,32)";
  }
  throw std::invalid_argument(why);
}

/// What is written between the brackets.
Numbers numbers_in(std::string_view text, std::string_view inside, const Entry& entry) {
  Numbers numbers = entry.numbers;
  for (std::size_t i = 0; i < std::max<std::size_t>(entry.takes, 1); ++i) {
    const std::size_t comma = inside.find(',');
    const bool last = i + 1 >= entry.takes;
    if (entry.takes == 0 || (comma == inside.npos) != last) refuse_numbers(text, entry);
    const std::string_view word = core::trimmed(inside.substr(0, comma), " ");
    const auto end = word.data() + word.size();
    const auto [at, error] = std::from_chars(word.data(), end, numbers[i]);
    if (error != std::errc() || at != end || numbers[i] < 1 || numbers[i] > kLargestStrip) {
      refuse_numbers(text, entry);
    }
    if (!last) inside.remove_prefix(comma + 1);
  }
  return numbers;
}

Asked asked_for(std::string_view text) {
  const std::string_view whole = core::trimmed(text, " ");
  const std::size_t bracket = whole.find('(');
  const std::string_view name = core::trimmed(whole.substr(0, bracket), " ");
  for (const Entry& entry : kOrders) {
    if (!same_name(entry.name, name)) continue;
    if (bracket == whole.npos) return {&entry, entry.numbers};
    if (whole.back() != ')') refuse_numbers(text, entry);
    return {&entry, numbers_in(text, whole.substr(bracket + 1, whole.size() - bracket - 2), entry)};
  }
  throw std::invalid_argument(unknown_name("pixel order", text, order_names()));
}

class Orders final : public core::BandOrders {
 public:
  Orders(const Asked& asked, const PixelColumns& columns, const camera::LensSheet* sheet,
         const RunMeter* meter)
      : m_columns(columns),
        m_make(asked.entry->prepare({columns.left, columns.right, sheet, meter}, asked.numbers)) {}
  std::unique_ptr<core::PixelOrder> band(std::uint32_t top, std::uint32_t bottom) const override {
    return m_make({m_columns.left, top, m_columns.right, bottom});
  }

 private:
  const PixelColumns m_columns;
  const Maker m_make;
};

std::uint64_t divided_up(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

}  // namespace

const std::vector<std::string_view>& order_names() {
  static const std::vector<std::string_view> kNames = names_of(kOrders);
  return kNames;
}

std::unique_ptr<core::PixelOrder> make_order(std::string_view name, const PixelRegion& region,
                                             const camera::LensSheet* sheet) {
  const Asked asked = asked_for(name);
  PixelRegion valid = region;
  valid.right = std::max(valid.right, valid.left);
  valid.bottom = std::max(valid.bottom, valid.top);
  return asked.entry->prepare({valid.left, valid.right, sheet, nullptr}, asked.numbers)(valid);
}

std::unique_ptr<core::PixelOrder> make_order(std::string_view name, std::uint32_t width,
                                             std::uint32_t height) {
  return make_order(name, PixelRegion{0, 0, width, height});
}

std::unique_ptr<core::BandOrders> make_band_orders(std::string_view name,
                                                   const PixelColumns& columns,
                                                   const camera::LensSheet* sheet,
                                                   const RunMeter* meter) {
  return std::make_unique<Orders>(asked_for(name), columns, sheet, meter);
}

bool follows_shadows(std::string_view name) {
  return asked_for(name).entry->prepare == prepare_adaptive;
}

std::uint32_t band_height(std::string_view name, std::uint32_t width, std::uint32_t height,
                          double bytes_a_row, double memory) {
  const Asked asked = asked_for(name);
  if (width == 0 || height == 0) return 1;
  const double wanted = (asked.rows() > 0 ? kLowBand : kHighBand) / width;
  const double fitting = memory / bytes_a_row;
  const double rows = std::floor(std::min({wanted, fitting, 1.0 * height}));
  const auto most = static_cast<std::uint64_t>(std::max(1.0, rows));
  // Bands of about one height, of whole tiles if that fits.
  std::uint64_t even = divided_up(height, divided_up(height, most));
  const std::uint64_t grain = std::max(asked.rows(), 1u);
  const std::uint64_t whole = divided_up(even, grain) * grain;
  if (whole <= fitting && whole * width <= kHighBand) even = whole;
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(even, height));
}

}  // namespace lentray::shadow
