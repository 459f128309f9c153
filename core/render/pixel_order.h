// The order in which pixels are traced. An order cuts the image into jobs (each traced by one
// thread, in sequence) and lists each job's pixels. Every pixel of the region occurs once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lentray::core {

struct Pixel { std::uint32_t column = 0, row = 0; };

class PixelOrder {
 public:
  virtual ~PixelOrder() = default;
  virtual std::size_t jobs() const = 0;
  /// Replaces `out` with the job's pixels in their order.
  virtual void pixels(std::size_t job, std::vector<Pixel>& out) const = 0;
};

}  // namespace lentray::core
