#include "shadow/hit_model/ideal_orders.h"

#include <algorithm>

namespace lentray::shadow {
namespace {

using core::Pixel;

class Listed final : public core::PixelOrder {
 public:
  explicit Listed(std::vector<Pixel> pixels) : m_pixels(std::move(pixels)) {}
  std::size_t jobs() const override { return (m_pixels.size() + kJob - 1) / kJob; }
  void pixels(std::size_t job, std::vector<Pixel>& out) const override {
    const auto first = m_pixels.begin() + static_cast<std::ptrdiff_t>(job * kJob);
    const auto left = static_cast<std::size_t>(m_pixels.end() - first);
    out.assign(first, first + static_cast<std::ptrdiff_t>(std::min(kJob, left)));
  }

 private:
  static constexpr std::size_t kJob = 16384;  // pixels
  std::vector<Pixel> m_pixels;
};

class IdealOrders final : public core::BandOrders {
 public:
  IdealOrders(const Enumeration& shadow, Style::Kind kind, std::uint32_t left, std::uint32_t right,
              std::uint32_t top)
      : m_shadow(shadow), m_kind(kind), m_top(top) {
    for (std::uint32_t k = left; k < right; ++k) {
      (shadow.columns()[k] == Enumeration::kBlocked ? m_blocked : m_rest).push_back(k);
    }
  }

  std::unique_ptr<core::PixelOrder> band(std::uint32_t top, std::uint32_t bottom) const override {
    std::vector<Pixel> out;
    out.reserve((m_blocked.size() + m_rest.size()) * (bottom - top));
    if (m_kind == Style::Kind::kCombined) {
      for (std::uint32_t r = top; r < bottom; ++r) {
        for (const std::uint32_t k : m_blocked) out.push_back({k, r});
        for (const std::uint32_t k : m_rest) out.push_back({k, r});
      }
    } else {
      strips(top, bottom, out);
    }
    return std::make_unique<Listed>(std::move(out));
  }

 private:
  bool blocked_row(std::uint32_t r) const {
    return m_shadow.rows()[m_top + r] == Enumeration::kBlocked;
  }

  void strips(std::uint32_t top, std::uint32_t bottom, std::vector<Pixel>& out) const {
    // Blocked columns that are neighbours are a strip; those of two lenses may meet, which only
    // makes one strip of them.
    for (std::size_t first = 0, end = 0; first < m_blocked.size(); first = end) {
      end = first + 1;
      while (end < m_blocked.size() && m_blocked[end] == m_blocked[end - 1] + 1) ++end;
      for (std::uint32_t r = top; r < bottom; ++r) {
        if (!blocked_row(r)) continue;
        for (std::size_t i = first; i < end; ++i) out.push_back({m_blocked[i], r});
      }
    }
    for (std::uint32_t r = top; r < bottom; ++r) {
      if (!blocked_row(r)) {
        for (const std::uint32_t k : m_blocked) out.push_back({k, r});
      }
      for (const std::uint32_t k : m_rest) out.push_back({k, r});
    }
  }

  const Enumeration& m_shadow;
  const Style::Kind m_kind;
  const std::uint32_t m_top;
  std::vector<std::uint32_t> m_blocked, m_rest;
};

}  // namespace

std::unique_ptr<core::BandOrders> make_ideal_orders(const Enumeration& shadow, Style::Kind kind,
                                                    std::uint32_t left, std::uint32_t right,
                                                    std::uint32_t top) {
  return std::make_unique<IdealOrders>(shadow, kind, left, right, top);
}

}  // namespace lentray::shadow
