// The binary tree that a WideBvh is made from: the boxes of its branches in floats. In the tree's frame. Internal to
// core/bvh.
#pragma once

#include <cstdint>
#include <limits>

#include "core/base/simd.h"

namespace lentray::core {

/// A box in the tree's frame, in floats as the nodes have them; lows negated, so that one maximum
/// joins boxes. Lane 3 is anything but a small or no number.
struct FloatBox {
  Float4 low = simd::float4(-std::numeric_limits<float>::infinity());
  Float4 high = low;

  void include(const FloatBox& b) {
    low = simd::max(low, b.low);
    high = simd::max(high, b.high);
  }
  /// Half of it; not of an empty box.
  float surface() const {
    const Float4 d = simd::min(high + low, simd::float4(1e18f));  // its square is a float
    const Float4 products = d * simd::shuffled<1, 2, 0, 3>(d);
    return products[0] + products[1] + products[2];
  }
  /// Twice its middle.
  Float4 middle() const { return high - low; }
};

/// Of two branches, or a leaf of parts that have their places one after the other.
class Branch {
 public:
  void set_box(const FloatBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
      m_low[axis] = box.low[axis];
      m_high[axis] = box.high[axis];
    }
  }
  void set_leaf(std::uint32_t first, std::uint32_t count) {
    m_first = first;
    m_second = kLeaf | count;
  }
  void set_left(std::uint32_t branch) { m_first = branch; }
  void set_right(std::uint32_t branch) { m_second = branch; }

  FloatBox box() const {
    return {Float4{m_low[0], m_low[1], m_low[2], 0.0f},
            Float4{m_high[0], m_high[1], m_high[2], 0.0f}};
  }
  bool is_leaf() const { return (m_second & kLeaf) != 0; }
  std::uint32_t left() const { return m_first; }
  std::uint32_t right() const { return m_second; }
  std::uint32_t first() const { return m_first; }
  std::uint32_t count() const { return m_second & ~kLeaf; }

 private:
  static constexpr std::uint32_t kLeaf = 0x80000000u;
  float m_low[3], m_high[3];  ///< as in FloatBox
  std::uint32_t m_first, m_second;
};

}  // namespace lentray::core
