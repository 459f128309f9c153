// The ledger of a picture: what its films have found out so far, kept outside so that a run that is
// cut off can be continued. A film finds something out in stages (FilmBand): without antialiasing
// the colours of the pixels; with it first one sample of every pixel, then their colours.
// Pixels of the image; four floats a pixel, which are the film's own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/render/pixel_order.h"

namespace lentray::core {

/// Some of an image's pixels. Any number of threads ask.
class PixelSet {
 public:
  PixelSet(std::uint32_t width, std::uint32_t height)
      : m_width(width), m_bits((std::size_t{width} * height + 63) / 64) {}
  bool has(const Pixel& p) const {
    const std::size_t i = index(p);
    return (m_bits[i / 64] >> (i % 64) & 1) != 0;
  }
  void add(const Pixel& p) {
    const std::size_t i = index(p);
    m_bits[i / 64] |= std::uint64_t{1} << (i % 64);
  }

 private:
  std::size_t index(const Pixel& p) const { return std::size_t{p.row} * m_width + p.column; }
  std::size_t m_width;
  std::vector<std::uint64_t> m_bits;
};

class PictureLedger {
 public:
  static constexpr std::size_t kStages = 2;
  static constexpr std::size_t kValues = 4;  ///< floats a pixel

  virtual ~PictureLedger() = default;
  /// What an earlier run found out; null: nothing. Does not change while the picture is made.
  virtual const PixelSet* known(std::size_t stage) const = 0;
  /// Tells the values of known pixels of the rows [top, bottom). One call at a time.
  virtual void recall(std::size_t stage, std::uint32_t top, std::uint32_t bottom,
                      const std::function<void(const Pixel&, const float*)>& tell) = 0;
  /// Whether add() would keep anything now.
  virtual bool listens() const = 0;
  /// `values`: kValues of each pixel. Any number of threads at once.
  virtual void add(std::size_t stage, const std::vector<Pixel>& pixels,
                   const std::vector<float>& values) = 0;
};

}  // namespace lentray::core
