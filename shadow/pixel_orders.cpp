#include "shadow/pixel_orders.h"

#include <algorithm>
#include <stdexcept>

#include "shadow/names.h"

namespace lentray::shadow {
namespace {

constexpr std::size_t kJobsWanted = 256;       ///< more than any machine's threads, several times
constexpr std::size_t kSmallestJob = 64;       ///< pixels
constexpr std::size_t kLargestJob = 16384;     ///< pixels

// Bands of lines along one axis: `along` is the length of a line, `across` the number of lines.
class Bands {
 public:
  Bands(std::size_t along, std::size_t across) : m_across(along == 0 ? 0 : across) {
    const std::size_t job =
        std::clamp(along * across / kJobsWanted, kSmallestJob, kLargestJob);
    m_lines = along == 0 ? 1 : std::max<std::size_t>(1, job / along);
  }
  std::size_t count() const { return (m_across + m_lines - 1) / m_lines; }
  std::size_t first(std::size_t band) const { return band * m_lines; }
  std::size_t last(std::size_t band) const { return std::min(m_across, first(band) + m_lines); }

 private:
  std::size_t m_across;
  std::size_t m_lines = 1;
};

/// Row after row, each from the left.
class RowOrder final : public core::PixelOrder {
 public:
  explicit RowOrder(const PixelRegion& r)
      : m_region(r), m_bands(r.right - r.left, r.bottom - r.top) {}
  std::size_t jobs() const override { return m_bands.count(); }
  void pixels(std::size_t job, std::vector<core::Pixel>& out) const override {
    out.clear();
    for (std::size_t line = m_bands.first(job); line < m_bands.last(job); ++line) {
      const auto row = static_cast<std::uint32_t>(m_region.top + line);
      for (std::uint32_t c = m_region.left; c < m_region.right; ++c) out.push_back({c, row});
    }
  }

 private:
  PixelRegion m_region;
  Bands m_bands;
};

/// Column after column, each from the top.
class ColumnOrder final : public core::PixelOrder {
 public:
  explicit ColumnOrder(const PixelRegion& r)
      : m_region(r), m_bands(r.bottom - r.top, r.right - r.left) {}
  std::size_t jobs() const override { return m_bands.count(); }
  void pixels(std::size_t job, std::vector<core::Pixel>& out) const override {
    out.clear();
    for (std::size_t line = m_bands.first(job); line < m_bands.last(job); ++line) {
      const auto column = static_cast<std::uint32_t>(m_region.left + line);
      for (std::uint32_t r = m_region.top; r < m_region.bottom; ++r) out.push_back({column, r});
    }
  }

 private:
  PixelRegion m_region;
  Bands m_bands;
};

struct Entry {
  std::string_view name;
  std::unique_ptr<core::PixelOrder> (*make)(const PixelRegion&);
};

template <class Order>
std::unique_ptr<core::PixelOrder> make_one(const PixelRegion& region) {
  return std::make_unique<Order>(region);
}

constexpr Entry kOrders[] = {
    {"rows", make_one<RowOrder>},
    {"columns", make_one<ColumnOrder>},
};

std::vector<std::string_view> names_of_orders() {
  std::vector<std::string_view> names;
  for (const Entry& entry : kOrders) names.push_back(entry.name);
  return names;
}

}  // namespace

const std::vector<std::string_view>& order_names() {
  static const std::vector<std::string_view> kNames = names_of_orders();
  return kNames;
}

std::unique_ptr<core::PixelOrder> make_order(std::string_view name, const PixelRegion& region) {
  PixelRegion valid = region;
  valid.right = std::max(valid.right, valid.left);
  valid.bottom = std::max(valid.bottom, valid.top);
  for (const Entry& entry : kOrders) {
    if (same_name(entry.name, name)) return entry.make(valid);
  }
  throw std::invalid_argument(unknown_name("pixel order", name, order_names()));
}

std::unique_ptr<core::PixelOrder> make_order(std::string_view name, std::uint32_t width,
                                             std::uint32_t height) {
  return make_order(name, PixelRegion{0, 0, width, height});
}

}  // namespace lentray::shadow
