// What pixel orders are made of: all pixels of a region one after another, cut into jobs of equal
// length. An order says which pixels come from a number on. Immutable, any number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/render/pixel_order.h"
#include "shadow/lens_columns.h"

namespace lentray::shadow {

using core::PixelRegion;

class Sequence : public core::PixelOrder {
 public:
  explicit Sequence(const PixelRegion& r)
      : m_region(r), m_width(r.right - r.left), m_height(r.bottom - r.top),
        m_count(m_width * m_height),
        m_job(std::clamp(m_count / kJobsWanted, kSmallestJob, kLargestJob)) {}

  std::size_t jobs() const final { return (m_count + m_job - 1) / m_job; }

  void pixels(std::size_t job, std::vector<core::Pixel>& out) const final {
    const std::size_t first = job * m_job, last = std::min(m_count, first + m_job);
    out.resize(last - first);  // most often as long as the job before
    list(first, last - first, out.data());
  }

 protected:
  /// Writes `count` pixels of the sequence, beginning with number `first`.
  virtual void list(std::size_t first, std::size_t count, core::Pixel* out) const = 0;

  core::Pixel at(std::size_t x, std::size_t y) const {
    return {static_cast<std::uint32_t>(m_region.left + x),
            static_cast<std::uint32_t>(m_region.top + y)};
  }

  const PixelRegion m_region;
  const std::size_t m_width, m_height;

 private:
  static constexpr std::size_t kJobsWanted = 256;    ///< more than any machine's threads
  static constexpr std::size_t kSmallestJob = 64;    ///< pixels
  static constexpr std::size_t kLargestJob = 16384;  ///< pixels

  const std::size_t m_count, m_job;
};

using OrderPtr = std::unique_ptr<core::PixelOrder>;

/// Rows in groups of `height`; in a group list after list, each row after row: all columns of the
/// region. `turns`: every second list from its lowest row up.
OrderPtr make_list_order(const PixelRegion& region, std::shared_ptr<const ColumnLists> lists,
                         std::size_t height, bool turns);
/// Squares of kHilbert pixels, each along a Hilbert curve; one square ends beside where the next
/// begins.
OrderPtr make_hilbert_order(const PixelRegion& region);

}  // namespace lentray::shadow
