// The walk of a bundle of rays through a bounding hierarchy, as one: a node is visited if any of the rays may meet
// it. In the leaves, boxes of single parts say which groups of rays may meet them. The tree's frame. Needs AVX2.
// Source: the interval rays of Boulos, Wald and Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray
// Packets", 2006.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "core/bundle/bundle_hull.h"

namespace lentray::core {

/// The box of one part, rounded outwards as a node's boxes are.
struct PartBox {
  float low[3], high[3];

  PartBox() = default;
  PartBox(const Bounds& box, const WideFrame& frame) {
    const Vec3 lo = frame.point(box.lo), hi = frame.point(box.hi);
    for (int a = 0; a < 3; ++a) {
      low[a] = WideLimits::down(lo[a] - frame.pad);
      high[a] = WideLimits::up(hi[a] + frame.pad);
    }
  }
};

/// How far the groups still look, as the box tests count.
class BundleReach {
 public:
  /// Groups without rays see nothing.
  BundleReach(int groups, float to) : m_farthest(to) {
    for (int i = 0; i < RayBundle::kGroups; ++i) m_to[i] = i < groups ? to : -1.0f;
  }
  void set(int group, float to) { m_to[group] = to; }
  LENTRAY_SIMD32 void update() {
    const Float8 v = simd::float8_at(m_to);
    const Float8 w = simd::max(v, simd::shuffled<4, 5, 6, 7, 0, 1, 2, 3>(v));
    const Float8 x = simd::max(w, simd::shuffled<2, 3, 0, 1, 6, 7, 4, 5>(w));
    m_farthest = simd::max(x, simd::shuffled<1, 0, 3, 2, 5, 4, 7, 6>(x))[0];
  }
  float farthest() const { return m_farthest; }
  /// A bit for each group of which a ray may meet the box.
  LENTRAY_SIMD32 unsigned groups_at(const BundleHull& hull, const PartBox& box) const {
    HullRange range(simd::float8_at(m_to));
    for (int a = 0; a < 3; ++a) {
      range.cut(hull.groups[a], simd::float8(box.low[a]), simd::float8(box.high[a]));
    }
    return range.meets();
  }

 private:
  alignas(32) float m_to[RayBundle::kGroups];
  float m_farthest;
};

/// Calls leaf(code) for the leaves that a ray may meet, near ones first, as long as it returns true; the leaf
/// lowers the reach. `nodes`: at most so many are visited. False if it did not come to an end.
template <class Leaf>
LENTRAY_AVX2 bool walk_bundle(const WideBvh& tree, const BundleHull& hull, const BundleReach& reach,
                              int nodes, Leaf& leaf) {
  struct Entry {
    float t;
    std::uint32_t child;
  };
  Entry stack[WideBvh::most_waiting()];
  int top = 0;
  std::uint32_t at = 0;
  alignas(32) float entered[WideNode::kWidth];
  for (;;) {
    if (at & WideNode::kLeaf) {
      if (!leaf(at & ~WideNode::kLeaf)) return false;
    } else {
      if (--nodes < 0) return false;
      const WideNode& node = tree.nodes()[at];
      HullRange range(simd::float8(reach.farthest()));
      for (int a = 0; a < 3; ++a) {
        range.cut(hull.all[a], simd::float8_at(node.planes[a][0]),
                  simd::float8_at(node.planes[a][1]));
      }
      unsigned hit = range.meets() & ((1u << node.used) - 1u);
      simd::store(entered, range.enter);
      const int base = top;
      for (; hit != 0; hit &= hit - 1) {
        const int i = std::countr_zero(hit);
        const Entry entry{entered[i], node.child[i]};
        int place = top++;
        for (; place > base && stack[place - 1].t < entry.t; --place)
          stack[place] = stack[place - 1];
        stack[place] = entry;
      }
    }
    do {
      if (top == 0) return true;
      --top;
    } while (stack[top].t > reach.farthest());
    at = stack[top].child;
  }
}

}  // namespace lentray::core
