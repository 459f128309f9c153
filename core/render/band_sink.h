// Receives the finished rows of a picture.
#pragma once

#include <cstdint>

#include "core/image/image.h"

namespace lentray::core {

class BandSink {
 public:
  virtual ~BandSink() = default;
  /// The rows [top, top + band.height) of the picture. Bands come from the top, one call at a
  /// time, from any thread. What it throws ends the frame.
  virtual void put(const Image& band, std::uint32_t top) = 0;
};

}  // namespace lentray::core
