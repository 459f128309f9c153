// Orders by lists of columns, and along Hilbert curves.
#include <array>
#include <bit>
#include <iterator>
#include <span>
#include <utility>

#include "shadow/pixel_orders.h"
#include "shadow/sequence.h"

namespace lentray::shadow {
namespace {

/// A pixel of a square, from its left and top. Without initializers, so that many are copied at once.
struct Place {
  std::uint8_t x, y;
};

/// The Hilbert curve through a square, from the upper left corner to the upper right one.
/// Source: D. Hilbert 1891; the usual reading of a place's number two bits at a time.
constexpr std::array<Place, kHilbert * kHilbert> hilbert_curve() {
  static_assert(std::has_single_bit(kHilbert) && kHilbert <= 256);
  std::array<Place, kHilbert * kHilbert> curve{};
  for (std::uint32_t number = 0; number < curve.size(); ++number) {
    std::uint32_t x = 0, y = 0, d = number;
    for (std::uint32_t s = 1; s < kHilbert; s *= 2, d /= 4) {
      const std::uint32_t right = d / 2 & 1, down = (d ^ right) & 1;
      if (down == 0) {
        if (right == 1) {
          x = s - 1 - x;
          y = s - 1 - y;
        }
        std::swap(x, y);
      }
      x += s * right;
      y += s * down;
    }
    curve[number] = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)};
  }
  return curve;
}
constexpr std::array kCurve = hilbert_curve();

/// Squares, a row of squares after another; those at the right and the lower border may be cut.
class HilbertOrder final : public Sequence {
 public:
  explicit HilbertOrder(const PixelRegion& r) : Sequence(r) {
    const std::size_t columns = m_width % kHilbert, rows = m_height % kHilbert;
    if (columns > 0 && m_height >= kHilbert) m_right = cut(columns, kHilbert);
    if (rows > 0 && m_width >= kHilbert) m_lower = cut(kHilbert, rows);
    if (columns > 0 && rows > 0) m_corner = cut(columns, rows);
  }

 private:
  /// What of the curve lies in so many columns and rows. The curve passes block after block; most
  /// are inside or outside as a whole.
  static std::vector<Place> cut(std::size_t columns, std::size_t rows) {
    constexpr std::size_t kSide = 8;
    std::vector<Place> places;
    places.reserve(columns * rows);
    for (auto block = kCurve.begin(); block != kCurve.end(); block += kSide * kSide) {
      const auto end = block + kSide * kSide;
      const std::size_t left = block->x / kSide * kSide, top = block->y / kSide * kSide;
      if (left >= columns || top >= rows) continue;
      if (left + kSide <= columns && top + kSide <= rows) {
        places.insert(places.end(), block, end);
      } else {
        std::copy_if(block, end, std::back_inserter(places),
                     [&](const Place& p) { return p.x < columns && p.y < rows; });
      }
    }
    return places;
  }
  std::span<const Place> places_of(std::size_t columns, std::size_t rows) const {
    if (columns < kHilbert) return rows < kHilbert ? m_corner : m_right;
    if (rows < kHilbert) return m_lower;
    return kCurve;
  }
  void list(std::size_t first, std::size_t count, core::Pixel* out) const override {
    std::size_t top = first / (m_width * kHilbert) * kHilbert;
    first -= top * m_width;
    std::size_t left =
        first / (std::min<std::size_t>(kHilbert, m_height - top) * kHilbert) * kHilbert;
    first -= left * std::min<std::size_t>(kHilbert, m_height - top);
    while (count > 0) {
      const std::span<const Place> places = places_of(m_width - left, m_height - top);
      const std::size_t number = std::min(count, places.size() - first);
      const core::Pixel corner = at(left, top);
      for (const Place& p : places.subspan(first, number)) {
        *out++ = {corner.column + p.x, corner.row + p.y};
      }
      count -= number;
      first = 0;
      left += kHilbert;
      if (left < m_width) continue;
      left = 0;
      top += kHilbert;
    }
  }

  std::vector<Place> m_right, m_lower, m_corner;  ///< of squares cut at the border
};

class ListOrder final : public Sequence {
 public:
  ListOrder(const PixelRegion& r, std::shared_ptr<const ColumnLists> lists, std::size_t height,
            bool turns)
      : Sequence(r), m_lists(std::move(lists)), m_group(std::min(height, m_height)),
        m_turns(turns) {}

 private:
  void list(std::size_t first, std::size_t count, core::Pixel* out) const override {
    const std::vector<std::size_t>& before = m_lists->before;
    std::size_t top = first / (m_width * m_group) * m_group;
    std::size_t rows = std::min(m_group, m_height - top);
    first -= top * m_width;
    const auto next = std::upper_bound(before.begin(), before.end(), first / rows);
    auto i = static_cast<std::size_t>(next - before.begin() - 1);
    first -= before[i] * rows;
    std::size_t x = first % (before[i + 1] - before[i]), y = first / (before[i + 1] - before[i]);
    for (; count > 0; --count) {
      const std::size_t down = m_turns && i % 2 == 1 ? rows - 1 - y : y;
      *out++ = {m_lists->columns[before[i] + x], at(0, top + down).row};
      if (++x < before[i + 1] - before[i]) continue;
      x = 0;
      if (++y < rows) continue;
      y = 0;
      if (++i + 1 < before.size()) continue;
      i = 0;
      top += m_group;
      rows = std::min(m_group, m_height - std::min(top, m_height));
    }
  }

  const std::shared_ptr<const ColumnLists> m_lists;
  const std::size_t m_group;
  const bool m_turns;
};

}  // namespace

OrderPtr make_list_order(const PixelRegion& region, std::shared_ptr<const ColumnLists> lists,
                         std::size_t height, bool turns) {
  return std::make_unique<ListOrder>(region, std::move(lists), height, turns);
}

OrderPtr make_hilbert_order(const PixelRegion& region) {
  return std::make_unique<HilbertOrder>(region);
}

}  // namespace lentray::shadow
