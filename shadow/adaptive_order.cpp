#include "shadow/adaptive_order.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shadow/run_meter.h"

namespace lentray::shadow {
namespace {

/// A strip's size in pixels, and whether it is traced down its columns.
struct Shape {
  std::uint32_t width = 4, height = 32;
  bool down = false;
};

Shape shape_by(const RunMeter* meter) {
  Shape shape;
  if (!meter) return shape;
  const double across = meter->run_length(RunMeter::kLeft);
  const double down = meter->run_length(RunMeter::kAbove);
  if (across == 0.0 || down == 0.0) return shape;
  const auto size = [](double run) {
    return static_cast<std::uint32_t>(std::clamp(std::round(run), 1.0, 1.0 * kBlock));
  };
  shape.width = size(across);
  shape.height = size(down);
  shape.down = down > across;
  return shape;
}

class AdaptiveOrder final : public core::PixelOrder {
 public:
  AdaptiveOrder(const PixelRegion& region, std::shared_ptr<const LensBlocks> blocks,
                const RunMeter* meter)
      : m_region(region), m_blocks(std::move(blocks)), m_meter(meter) {}

  std::size_t jobs() const override {
    if (m_region.left >= m_region.right) return 0;
    const std::size_t down = (m_region.bottom - m_region.top + kBlock - 1) / kBlock;
    return down * across();
  }

  /// Asked once a job, when it is begun: later jobs know more.
  void pixels(std::size_t job, std::vector<core::Pixel>& out) const override {
    out.clear();
    const auto row = static_cast<std::uint32_t>(m_region.top + job / across() * kBlock);
    const std::uint32_t end = std::min(row + kBlock, m_region.bottom);
    const std::size_t block = job % across();
    const auto lenses = m_blocks->lenses.begin();
    const auto from = lenses + static_cast<std::ptrdiff_t>(m_blocks->first[block]);
    const auto to = lenses + static_cast<std::ptrdiff_t>(m_blocks->first[block + 1]);
    const Shape shape = shape_by(m_meter);
    for (std::uint32_t top = row; top < end; top += shape.height) {
      const std::uint32_t bottom = std::min(top + shape.height, end);
      std::uint32_t at = 0;
      while (add_strips(shape, at, top, bottom, from, to, out)) at += shape.width;
    }
  }

 private:
  std::size_t across() const { return m_blocks->first.size() - 1; }

  /// The strips that begin `at` pixels into their lenses; false if there is none.
  template <class Lens>
  static bool add_strips(const Shape& shape, std::uint32_t at, std::uint32_t top,
                         std::uint32_t bottom, Lens from, Lens to, std::vector<core::Pixel>& out) {
    bool any = false;
    for (Lens lens = from; lens != to; ++lens) {
      const std::uint32_t begin = lens->begin + at;
      if (begin >= lens->end) continue;
      const std::uint32_t end = std::min(begin + shape.width, lens->end);
      any = true;
      if (shape.down) {
        for (std::uint32_t x = begin; x < end; ++x) {
          for (std::uint32_t y = top; y < bottom; ++y) out.push_back({x, y});
        }
      } else {
        for (std::uint32_t y = top; y < bottom; ++y) {
          for (std::uint32_t x = begin; x < end; ++x) out.push_back({x, y});
        }
      }
    }
    return any;
  }

  const PixelRegion m_region;
  const std::shared_ptr<const LensBlocks> m_blocks;
  const RunMeter* const m_meter;
};

}  // namespace

LensBlocks blocks_of(std::uint32_t left, std::uint32_t right, const camera::LensSheet* sheet) {
  LensBlocks blocks;
  for (const Strip& lens : lenses_of(right, sheet)) {
    // Wide lenses, and pictures without lenses, in pieces.
    for (std::uint32_t begin = std::max(lens.begin, left); begin < lens.end; begin += kBlock) {
      blocks.lenses.push_back({begin, std::min(begin + kBlock, lens.end)});
    }
  }
  std::uint32_t width = kBlock;
  for (std::size_t i = 0; i < blocks.lenses.size(); ++i) {
    const std::uint32_t more = blocks.lenses[i].end - blocks.lenses[i].begin;
    if (width + more > kBlock) {
      blocks.first.push_back(i);
      width = 0;
    }
    width += more;
  }
  blocks.first.push_back(blocks.lenses.size());
  return blocks;
}

OrderPtr make_adaptive_order(const PixelRegion& region, std::shared_ptr<const LensBlocks> blocks,
                             const RunMeter* meter) {
  return std::make_unique<AdaptiveOrder>(region, std::move(blocks), meter);
}

}  // namespace lentray::shadow
