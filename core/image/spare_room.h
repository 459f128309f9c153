// Room on a disk that something holds which is worth less than a picture: it is given up where
// the picture would not fit otherwise. Any thread.
#pragma once

#include <cstdint>

namespace lentray::core {

class SpareRoom {
 public:
  virtual ~SpareRoom() = default;
  /// That give() would free.
  virtual std::uint64_t bytes() = 0;
  virtual void give() = 0;
};

}  // namespace lentray::core
