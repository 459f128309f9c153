// The order in which pixels are traced. An order cuts a part of the image into jobs (each traced
// by one thread, in sequence) and lists each job's pixels. Every pixel of the part occurs once.
// Immutable, any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/pixel.h"

namespace lentray::core {

class PixelOrder {
 public:
  virtual ~PixelOrder() = default;
  virtual std::size_t jobs() const = 0;
  /// Replaces `out` with the job's pixels in their order.
  virtual void pixels(std::size_t job, std::vector<Pixel>& out) const = 0;
};

/// One way of ordering, for whatever band of an image is asked for.
class BandOrders {
 public:
  virtual ~BandOrders() = default;
  /// The pixels of the rows [top, bottom), which must not be empty.
  virtual std::unique_ptr<PixelOrder> band(std::uint32_t top, std::uint32_t bottom) const = 0;
};

}  // namespace lentray::core
