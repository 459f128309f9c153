#include "shadow/pixel_orders.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "shadow/names.h"

namespace lentray::shadow {
namespace {

constexpr std::size_t kJobsWanted = 256;       ///< more than any machine's threads, several times
constexpr std::size_t kSmallestJob = 64;       ///< pixels
constexpr std::size_t kLargestJob = 16384;     ///< pixels
constexpr double kHighBand = 8.0 * 1024 * 1024;  ///< pixels, where an order gains by height
constexpr double kLowBand = 512.0 * 1024;        ///< pixels, elsewhere

/// Columns, those of one view after those of another; views[j] is where view j begins, and the
/// last entry is the end.
struct ViewColumns {
  std::vector<std::uint32_t> columns;
  std::vector<std::size_t> views;
};

using SharedViews = std::shared_ptr<const ViewColumns>;

SharedViews columns_by_view(const PixelRegion& region, const camera::LensSheet* sheet) {
  std::vector<std::vector<std::uint32_t>> by_view;
  std::uint32_t lens = 0, lens_begin = 0;
  if (sheet == nullptr) by_view.resize(1);
  for (std::uint32_t k = 0; k < region.right; ++k) {
    if (sheet != nullptr && sheet->column(k).lens != lens) {
      lens = sheet->column(k).lens;
      lens_begin = k;
    }
    const std::size_t view = sheet == nullptr ? 0 : k - lens_begin;
    if (view >= by_view.size()) by_view.resize(view + 1);
    if (k >= region.left) by_view[view].push_back(k);
  }
  auto out = std::make_shared<ViewColumns>();
  for (const std::vector<std::uint32_t>& view : by_view) {
    if (view.empty()) continue;
    out->views.push_back(out->columns.size());
    out->columns.insert(out->columns.end(), view.begin(), view.end());
  }
  out->views.push_back(out->columns.size());
  return out;
}

/// All pixels of a region one after another; jobs are runs of equal length.
class Sequence : public core::PixelOrder {
 public:
  explicit Sequence(const PixelRegion& r)
      : m_region(r), m_width(r.right - r.left), m_height(r.bottom - r.top),
        m_count(m_width * m_height),
        m_job(std::clamp(m_count / kJobsWanted, kSmallestJob, kLargestJob)) {}

  std::size_t jobs() const final { return (m_count + m_job - 1) / m_job; }

  void pixels(std::size_t job, std::vector<core::Pixel>& out) const final {
    const std::size_t first = job * m_job, last = std::min(m_count, first + m_job);
    out.clear();
    out.reserve(last - first);
    list(first, last - first, out);
  }

 protected:
  /// Appends `count` pixels of the sequence, beginning with number `first`.
  virtual void list(std::size_t first, std::size_t count, std::vector<core::Pixel>& out) const = 0;

  core::Pixel at(std::size_t x, std::size_t y) const {
    return {static_cast<std::uint32_t>(m_region.left + x),
            static_cast<std::uint32_t>(m_region.top + y)};
  }

  const PixelRegion m_region;
  const std::size_t m_width, m_height;

 private:
  const std::size_t m_count, m_job;
};

class RowOrder final : public Sequence {
 public:
  RowOrder(const PixelRegion& r, const SharedViews&) : Sequence(r) {}

 private:
  void list(std::size_t first, std::size_t count, std::vector<core::Pixel>& out) const override {
    std::size_t x = first % m_width, y = first / m_width;
    for (; count > 0; --count) {
      out.push_back(at(x, y));
      if (++x < m_width) continue;
      x = 0;
      ++y;
    }
  }
};

class ColumnOrder final : public Sequence {
 public:
  ColumnOrder(const PixelRegion& r, const SharedViews&) : Sequence(r) {}

 private:
  void list(std::size_t first, std::size_t count, std::vector<core::Pixel>& out) const override {
    std::size_t x = first / m_height, y = first % m_height;
    for (; count > 0; --count) {
      out.push_back(at(x, y));
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
  void list(std::size_t first, std::size_t count, std::vector<core::Pixel>& out) const override {
    const std::vector<std::size_t>& views = m_views->views;
    std::size_t view = 0;
    while (views[view + 1] * m_height <= first) ++view;
    std::size_t lenses = views[view + 1] - views[view];
    const std::size_t within = first - views[view] * m_height;
    std::size_t lens = within % lenses, y = within / lenses;
    for (; count > 0; --count) {
      out.push_back({m_views->columns[views[view] + lens], at(0, y).row});
      if (++lens < lenses) continue;
      lens = 0;
      if (++y < m_height) continue;
      y = 0;
      if (++view + 1 < views.size()) lenses = views[view + 1] - views[view];
    }
  }

  const SharedViews m_views;
};

class TileOrder final : public Sequence {
 public:
  TileOrder(const PixelRegion& r, const SharedViews&) : Sequence(r) {}

 private:
  void list(std::size_t first, std::size_t count, std::vector<core::Pixel>& out) const override {
    const std::size_t tile = kTile;
    std::size_t top = first / (m_width * tile) * tile;
    std::size_t rows = std::min(tile, m_height - top);
    std::size_t left = (first - top * m_width) / (rows * tile) * tile;
    std::size_t columns = std::min(tile, m_width - left);
    const std::size_t within = first - top * m_width - left * rows;
    std::size_t x = within % columns, y = within / columns;
    for (; count > 0; --count) {
      out.push_back(at(left + x, top + y));
      if (++x < columns) continue;
      x = 0;
      if (++y < rows) continue;
      y = 0;
      left += tile;
      if (left >= m_width) {
        left = 0;
        top += tile;
        rows = std::min(tile, m_height - std::min(top, m_height));
      }
      columns = std::min(tile, m_width - left);
    }
  }
};

struct Entry {
  std::string_view name;
  std::unique_ptr<core::PixelOrder> (*make)(const PixelRegion&, const SharedViews&);
  /// Bands that are multiples of this many rows leave the order as it is in the whole image;
  /// 0: the higher the better.
  std::uint32_t rows;
};

template <class Order>
std::unique_ptr<core::PixelOrder> make_one(const PixelRegion& region, const SharedViews& views) {
  return std::make_unique<Order>(region, views);
}

constexpr Entry kOrders[] = {
    {"rows", make_one<RowOrder>, 1},
    {"views", make_one<ViewOrder>, 0},
    {"columns", make_one<ColumnOrder>, 0},
    {"tiles", make_one<TileOrder>, kTile},
};

const Entry& entry_of(std::string_view name) {
  for (const Entry& entry : kOrders) {
    if (same_name(entry.name, name)) return entry;
  }
  throw std::invalid_argument(unknown_name("pixel order", name, order_names()));
}

std::vector<std::string_view> names_of_orders() {
  std::vector<std::string_view> names;
  for (const Entry& entry : kOrders) names.push_back(entry.name);
  return names;
}

class Orders final : public core::BandOrders {
 public:
  Orders(const Entry& entry, std::uint32_t width, const camera::LensSheet* sheet)
      : m_entry(entry), m_width(width), m_views(columns_by_view({0, 0, width, 0}, sheet)) {}
  std::unique_ptr<core::PixelOrder> band(std::uint32_t top, std::uint32_t bottom) const override {
    return m_entry.make({0, top, m_width, bottom}, m_views);
  }

 private:
  const Entry& m_entry;
  const std::uint32_t m_width;
  const SharedViews m_views;
};

std::uint64_t divided_up(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

}  // namespace

const std::vector<std::string_view>& order_names() {
  static const std::vector<std::string_view> kNames = names_of_orders();
  return kNames;
}

std::unique_ptr<core::PixelOrder> make_order(std::string_view name, const PixelRegion& region,
                                             const camera::LensSheet* sheet) {
  const Entry& entry = entry_of(name);
  PixelRegion valid = region;
  valid.right = std::max(valid.right, valid.left);
  valid.bottom = std::max(valid.bottom, valid.top);
  return entry.make(valid, columns_by_view(valid, sheet));
}

std::unique_ptr<core::PixelOrder> make_order(std::string_view name, std::uint32_t width,
                                             std::uint32_t height) {
  return make_order(name, PixelRegion{0, 0, width, height});
}

std::unique_ptr<core::BandOrders> make_band_orders(std::string_view name, std::uint32_t width,
                                                   const camera::LensSheet* sheet) {
  return std::make_unique<Orders>(entry_of(name), width, sheet);
}

std::uint32_t band_height(std::string_view name, std::uint32_t width, std::uint32_t height,
                          double bytes_a_row, double memory) {
  const Entry& entry = entry_of(name);
  if (width == 0 || height == 0) return 1;
  const double wanted = (entry.rows > 0 ? kLowBand : kHighBand) / width;
  const double fitting = memory / bytes_a_row;
  const double rows = std::floor(std::min({wanted, fitting, 1.0 * height}));
  const auto most = static_cast<std::uint64_t>(std::max(1.0, rows));
  // Bands of about one height, of whole tiles if that fits.
  std::uint64_t even = divided_up(height, divided_up(height, most));
  const std::uint64_t grain = std::max(entry.rows, 1u);
  if (divided_up(even, grain) * grain <= fitting) even = divided_up(even, grain) * grain;
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(even, height));
}

}  // namespace lentray::shadow
