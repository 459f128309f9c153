// Room on a disk that something holds which is worth less than a picture: it is given up where
// the picture would not fit otherwise. Any thread.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace lentray::core {

class SpareRoom {
 public:
  virtual ~SpareRoom() = default;
  /// That can be freed.
  virtual std::uint64_t bytes() = 0;
  /// Frees it, or a part of it. False: there is nothing more to free.
  virtual bool give() = 0;
};

/// Several, freed one after another. They must outlive it.
class SpareRooms final : public SpareRoom {
 public:
  explicit SpareRooms(std::vector<SpareRoom*> rooms) : m_rooms(std::move(rooms)) {}
  std::uint64_t bytes() override {
    std::uint64_t sum = 0;
    for (SpareRoom* const room : m_rooms) sum += room->bytes();
    return sum;
  }
  bool give() override {
    for (SpareRoom* const room : m_rooms) {
      if (room->give()) return true;
    }
    return false;
  }

 private:
  const std::vector<SpareRoom*> m_rooms;
};

}  // namespace lentray::core
