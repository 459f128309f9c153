// Orders along lines: rows, columns, views.
#include "shadow/sequence.h"

namespace lentray::shadow {
namespace {

class RowOrder final : public Sequence {
 public:
  using Sequence::Sequence;

 private:
  void list(std::size_t first, std::size_t count, core::Pixel* out) const override {
    std::size_t x = first % m_width, y = first / m_width;
    for (; count > 0; --count) {
      *out++ = at(x, y);
      if (++x < m_width) continue;
      x = 0;
      ++y;
    }
  }
};

class ColumnOrder final : public Sequence {
 public:
  using Sequence::Sequence;

 private:
  void list(std::size_t first, std::size_t count, core::Pixel* out) const override {
    std::size_t x = first / m_height, y = first % m_height;
    for (; count > 0; --count) {
      *out++ = at(x, y);
      if (++y < m_height) continue;
      y = 0;
      ++x;
    }
  }
};

class ViewOrder final : public Sequence {
 public:
  ViewOrder(const PixelRegion& r, SharedViews views) : Sequence(r), m_views(std::move(views)) {}

 private:
  void list(std::size_t first, std::size_t count, core::Pixel* out) const override {
    std::size_t view = 0;
    for (; first >= (*m_views)[view].size() * m_height; ++view) {
      first -= (*m_views)[view].size() * m_height;
    }
    std::size_t lens = first % (*m_views)[view].size(), y = first / (*m_views)[view].size();
    for (; count > 0; --count) {
      *out++ = {(*m_views)[view][lens], at(0, y).row};
      if (++lens < (*m_views)[view].size()) continue;
      lens = 0;
      if (++y < m_height) continue;
      y = 0;
      ++view;
    }
  }

  const SharedViews m_views;
};

}  // namespace

OrderPtr make_row_order(const PixelRegion& region) { return std::make_unique<RowOrder>(region); }

OrderPtr make_column_order(const PixelRegion& region) {
  return std::make_unique<ColumnOrder>(region);
}

OrderPtr make_view_order(const PixelRegion& region, SharedViews views) {
  return std::make_unique<ViewOrder>(region, std::move(views));
}

}  // namespace lentray::shadow
