// Orders over areas: tiles, strips of lenses, Hilbert curves.
#include <utility>

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
  /// Appends the square's pixels but for the first `skip`, at most `count`; returns how many.
  virtual std::size_t list_square(const Square& square, std::size_t skip, std::size_t count,
                                  std::vector<core::Pixel>& out) const = 0;
  const std::size_t m_side;

 private:
  void list(std::size_t first, std::size_t count, std::vector<core::Pixel>& out) const final {
    Square s;
    s.top = first / (m_width * m_side) * m_side;
    s.rows = std::min(m_side, m_height - s.top);
    s.left = (first - s.top * m_width) / (s.rows * m_side) * m_side;
    std::size_t skip = first - s.top * m_width - s.left * s.rows;
    while (count > 0) {
      s.columns = std::min(m_side, m_width - s.left);
      count -= list_square(s, skip, count, out);
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
                          std::vector<core::Pixel>& out) const override {
    const std::size_t number = std::min(count, s.columns * s.rows - skip);
    std::size_t x = skip % s.columns, y = skip / s.columns;
    for (std::size_t i = 0; i < number; ++i) {
      out.push_back(at(s.left + x, s.top + y));
      if (++x < s.columns) continue;
      x = 0;
      ++y;
    }
    return number;
  }
};

/// Place number `d` of the Hilbert curve in a square of 2^k: from the upper left corner to the
/// upper right one. Source: D. Hilbert 1891; the usual reading of d two bits at a time.
std::pair<std::size_t, std::size_t> hilbert_place(std::size_t side, std::size_t d) {
  std::size_t x = 0, y = 0;
  for (std::size_t s = 1; s < side; s *= 2, d /= 4) {
    const std::size_t right = d / 2 & 1, down = (d ^ right) & 1;
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
  return {x, y};
}

class HilbertOrder final : public SquareOrder {
 public:
  HilbertOrder(const PixelRegion& r, std::size_t side) : SquareOrder(r, side) {
    m_curve.reserve(side * side);
    for (std::size_t d = 0; d < side * side; ++d) m_curve.push_back(hilbert_place(side, d));
  }

 private:
  std::size_t list_square(const Square& s, std::size_t skip, std::size_t count,
                          std::vector<core::Pixel>& out) const override {
    const std::size_t before = out.size();
    const bool whole = s.columns == m_side && s.rows == m_side;
    std::size_t d = whole ? skip : 0;
    if (whole) skip = 0;
    for (; d < m_side * m_side && out.size() - before < count; ++d) {
      const auto [x, y] = m_curve[d];
      if (x >= s.columns || y >= s.rows) continue;
      if (skip > 0) {
        --skip;
      } else {
        out.push_back(at(s.left + x, s.top + y));
      }
    }
    return out.size() - before;
  }

  std::vector<std::pair<std::size_t, std::size_t>> m_curve;  ///< the places in order
};

class StripOrder final : public Sequence {
 public:
  StripOrder(const PixelRegion& r, SharedStrips strips, std::size_t height)
      : Sequence(r), m_strips(std::move(strips)), m_group(std::min(height, m_height)) {}

 private:
  void list(std::size_t first, std::size_t count, std::vector<core::Pixel>& out) const override {
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
      out.push_back({static_cast<std::uint32_t>(strips[i].begin + x), at(0, top + y).row});
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

OrderPtr make_strip_order(const PixelRegion& region, SharedStrips strips, std::size_t height) {
  return std::make_unique<StripOrder>(region, std::move(strips), height);
}

OrderPtr make_hilbert_order(const PixelRegion& region, std::size_t side) {
  return std::make_unique<HilbertOrder>(region, side);
}

}  // namespace lentray::shadow
