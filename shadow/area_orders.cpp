// Orders over areas: tiles, serpentines, strips of lenses, Hilbert curves.
#include <array>
#include <bit>
#include <iterator>
#include <span>
#include <utility>

#include "shadow/pixel_orders.h"
#include "shadow/sequence.h"

namespace lentray::shadow {
namespace {

/// Squares, a row of squares after another; those at the right and the lower border may be cut.
class SquareOrder : public Sequence {
 public:
  SquareOrder(const PixelRegion& r, std::size_t side) : Sequence(r), m_side(side) {}

 protected:
  /// Columns and rows of the square.
  struct Square {
    std::size_t left = 0, top = 0, columns = 0, rows = 0;
  };
  /// Writes the square's pixels but for the first `skip`, at most `count`; returns how many.
  virtual std::size_t list_square(const Square& square, std::size_t skip, std::size_t count,
                                  core::Pixel* out) const = 0;
  /// A square as lines of `length` pixels each; pixel_at(line, along) is where one lies.
  template <class PixelAt>
  static std::size_t list_lines(const Square& s, std::size_t length, std::size_t skip,
                                std::size_t count, core::Pixel* out, PixelAt&& pixel_at) {
    const std::size_t number = std::min(count, s.columns * s.rows - skip);
    std::size_t line = skip / length, along = skip % length;
    for (std::size_t i = 0; i < number; ++i) {
      *out++ = pixel_at(line, along);
      if (++along < length) continue;
      along = 0;
      ++line;
    }
    return number;
  }
  const std::size_t m_side;

 private:
  void list(std::size_t first, std::size_t count, core::Pixel* out) const final {
    Square s;
    s.top = first / (m_width * m_side) * m_side;
    s.rows = std::min(m_side, m_height - s.top);
    s.left = (first - s.top * m_width) / (s.rows * m_side) * m_side;
    std::size_t skip = first - s.top * m_width - s.left * s.rows;
    while (count > 0) {
      s.columns = std::min(m_side, m_width - s.left);
      const std::size_t listed = list_square(s, skip, count, out);
      out += listed;
      count -= listed;
      skip = 0;
      s.left += m_side;
      if (s.left < m_width) continue;
      s.left = 0;
      s.top += m_side;
      s.rows = std::min(m_side, m_height - std::min(s.top, m_height));
    }
  }
};

class TileOrder final : public SquareOrder {
 public:
  using SquareOrder::SquareOrder;

 private:
  std::size_t list_square(const Square& s, std::size_t skip, std::size_t count,
                          core::Pixel* out) const override {
    return list_lines(s, s.columns, skip, count, out,
                      [&](std::size_t y, std::size_t x) { return at(s.left + x, s.top + y); });
  }
};

/// Column after column, down and up in turn: neighbours follow each other as along a column, in
/// less memory than a whole column's rays meet.
class SerpentineOrder final : public SquareOrder {
 public:
  using SquareOrder::SquareOrder;

 private:
  std::size_t list_square(const Square& s, std::size_t skip, std::size_t count,
                          core::Pixel* out) const override {
    return list_lines(s, s.rows, skip, count, out, [&](std::size_t x, std::size_t y) {
      return at(s.left + x, s.top + (x % 2 == 0 ? y : s.rows - 1 - y));
    });
  }
};

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

class HilbertOrder final : public SquareOrder {
 public:
  explicit HilbertOrder(const PixelRegion& r) : SquareOrder(r, kHilbert) {
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
  std::span<const Place> places_of(const Square& s) const {
    if (s.columns < kHilbert) return s.rows < kHilbert ? m_corner : m_right;
    if (s.rows < kHilbert) return m_lower;
    return kCurve;
  }
  std::size_t list_square(const Square& s, std::size_t skip, std::size_t count,
                          core::Pixel* out) const override {
    const std::span<const Place> places = places_of(s);
    const std::size_t number = std::min(count, places.size() - skip);
    const core::Pixel corner = at(s.left, s.top);
    for (const Place& p : places.subspan(skip, number)) {
      *out++ = {corner.column + p.x, corner.row + p.y};
    }
    return number;
  }

  std::vector<Place> m_right, m_lower, m_corner;  ///< of squares cut at the border
};

class StripOrder final : public Sequence {
 public:
  StripOrder(const PixelRegion& r, SharedStrips strips, std::size_t height)
      : Sequence(r), m_strips(std::move(strips)), m_group(std::min(height, m_height)) {}

 private:
  void list(std::size_t first, std::size_t count, core::Pixel* out) const override {
    const std::vector<Strip>& strips = m_strips->strips;
    const std::vector<std::size_t>& before = m_strips->before;
    std::size_t top = first / (m_width * m_group) * m_group;
    std::size_t rows = std::min(m_group, m_height - top);
    first -= top * m_width;
    const auto next = std::upper_bound(before.begin(), before.end(), first / rows);
    auto i = static_cast<std::size_t>(next - before.begin() - 1);
    first -= before[i] * rows;
    std::size_t x = first % (strips[i].end - strips[i].begin);
    std::size_t y = first / (strips[i].end - strips[i].begin);
    for (; count > 0; --count) {
      *out++ = {static_cast<std::uint32_t>(strips[i].begin + x), at(0, top + y).row};
      if (++x < strips[i].end - strips[i].begin) continue;
      x = 0;
      if (++y < rows) continue;
      y = 0;
      if (++i < strips.size()) continue;
      i = 0;
      top += m_group;
      rows = std::min(m_group, m_height - std::min(top, m_height));
    }
  }

  const SharedStrips m_strips;
  const std::size_t m_group;
};

}  // namespace

OrderPtr make_tile_order(const PixelRegion& region, std::size_t side) {
  return std::make_unique<TileOrder>(region, side);
}

OrderPtr make_serpentine_order(const PixelRegion& region, std::size_t side) {
  return std::make_unique<SerpentineOrder>(region, side);
}

OrderPtr make_strip_order(const PixelRegion& region, SharedStrips strips, std::size_t height) {
  return std::make_unique<StripOrder>(region, std::move(strips), height);
}

OrderPtr make_hilbert_order(const PixelRegion& region) {
  return std::make_unique<HilbertOrder>(region);
}

}  // namespace lentray::shadow
