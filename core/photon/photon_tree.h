// The photons nearest to a point. World space. Built once, then const: many threads ask.
// A balanced k-d tree in an array: the photon in the middle of a range splits it in two, on the axis along
// which the range is widest, down to single photons. So there are no pointers, and the order in which
// photons are met, on which stock's choice depends in part (see find()), is that of stock.
// Source: Jensen, "Realistic Image Synthesis Using Photon Mapping"; stock's choice as tests/unit/
// photon_test.cpp has it.
#pragma once

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
};

/// A buffer that is used from search to search.
struct FoundPhotons {
  struct One {
    double distance;  ///< squared, as the search measures it
    std::uint32_t number;
  };
  std::vector<One> list;  ///< in an order that depends on tree and search alone
  double radius =
      0.0;  ///< within which they are all: that of the search, or where they are many, less
};

class PhotonTree {
 public:
  enum class Order { kOfShooting, kOfTree };
  /// kOfTree: they lie as a tree left them, with their axes.
  PhotonTree(std::vector<Photon> photons, Order order);

  bool is_empty() const { return m_photons.empty(); }
  std::size_t size() const { return m_photons.size(); }
  /// In the tree's order: FoundPhotons' numbers are places here.
  const std::vector<Photon>& photons() const { return m_photons; }
  const Photon& operator[](std::uint32_t number) const { return m_photons[number]; }

  /// The nearest. As in stock, where there are more than wanted, the farthest of those that were met first
  /// makes room for the next, also if that is farther.
  void find(const PhotonSearch& search, FoundPhotons& found) const;

 private:
  void split(std::size_t begin, std::size_t end);
  template <bool kFlattened>
  void find_in(const PhotonSearch& search, FoundPhotons& found) const;

  std::vector<Photon> m_photons;
};

}  // namespace lentray::core
