// The photons nearest to a point. World space. Built once, then const: many threads ask.
// A balanced k-d tree in an array: the photon in the middle of a range splits it in two, on the axis along
// which the range is widest, down to single photons. So there are no pointers, and the order in which
// photons are visited, on which the choice depends in part (see find()), is fixed.
// Source: Jensen, "Realistic Image Synthesis Using Photon Mapping"; the choice is measured in
// tests/unit/photon/photon_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/vec3.h"
#include "core/photon/photon.h"

namespace lentray::core {

struct PhotonSearch {
  Vec3 point;
  /// Unit; distances off the plane through the point count more (d^2 (1 + 16 off)). Null: they do not.
  const Vec3* normal;
  double radius;     ///< nearer than this
  std::size_t most;  ///< so many, at least 1
  /// Slower, and now and then another photon is missed.
  bool one_by_one = false;
};

/// In an order that depends on tree and search alone. A buffer that is used from search to search.
class FoundPhotons {
 public:
  struct One {
    double distance;  ///< squared, as the search measures it
    std::uint32_t number;
  };
  const One* begin() const { return m_room.data(); }
  const One* end() const { return m_room.data() + m_size; }
  std::size_t size() const { return m_size; }
  bool is_empty() const { return m_size == 0; }
  /// Within which they are all: that of the search, or where there are more, the farthest's.
  double radius() const { return m_radius; }

 private:
  friend class PhotonTree;
  std::vector<One> m_room;  ///< may be longer than what was found
  std::size_t m_size = 0;
  double m_radius = 0.0;
};

class PhotonTree {
 public:
  enum class Order { kOfShooting, kOfTree };
  /// kOfTree: they lie as a tree left them, with their axes. `portable`: no AVX2 even where there is any.
  PhotonTree(std::vector<Photon> photons, Order order, bool portable = false);

  bool is_empty() const { return m_photons.empty(); }
  std::size_t size() const { return m_photons.size(); }
  /// In the tree's order: FoundPhotons' numbers are places here.
  const std::vector<Photon>& photons() const { return m_photons; }
  const Photon& operator[](std::uint32_t number) const { return m_photons[number]; }

  /// The nearest. Where there are more than wanted, the farthest of those that were visited first
  /// makes room for the next, also if that is farther.
  void find(const PhotonSearch& search, FoundPhotons& found) const;

 private:
  void split(std::size_t begin, std::size_t end);
  /// The box around a range's photons.
  struct Box {
    std::array<float, 3> least, most;
    /// The square of the distance to a point, not greater than that of any photon in it, rounding included.
    double gap(const Vec3& point) const;
  };
  /// Notes boxes of ranges down to buckets, numbered as a heap, and in these the photons on the wrong side of
  /// one that splits: buckets pass them by where the tree would, too.
  Box note(std::size_t begin, std::size_t end, std::size_t number);
  void note_hidden(std::size_t begin, std::size_t end);
  template <bool kFlattened>
  void find_in(const PhotonSearch& search, FoundPhotons& found) const;

  std::vector<Photon> m_photons;
  std::vector<Box> m_boxes;
  bool m_avx2;
};

}  // namespace lentray::core
