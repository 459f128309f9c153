// A bounding hierarchy over anything that has boxes: 8 boxes a node, tested at once, leaves
// answered by the caller. Used by the scene's Hierarchy and by shapes of many parts (meshes,
// large unions). Space: the boxes' own.
//
// Conservative: a leaf is visited whenever the ray, for some t in [t_min, t_max], comes within
// the rounding of the numbers involved (2^-46 of the whole, 2^-23 of the coordinate counted from
// the middle of all boxes) of one of its boxes. Boxes are floats in the tree's own frame (middle
// of all boxes 0, half size 1), rounded outwards; far origins are first moved to the boxes in
// double; origin, limits and distances carry their rounding outwards. So neither coordinates of
// 1e7, rays along an axis or in the plane of a box's side, nor flat boxes lose a hit.
// A few boxes that reach a thousand times farther than the others do not count for the frame: a
// vertex at 1e30 leaves the boxes of the rest as sharp as they are.
//
// Immutable once built; any number of threads. AVX2 is used where the processor has it; the
// order of the leaves visited may differ then, the set of hits found does not.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "core/base/bounds.h"
#include "core/base/processor.h"
#include "core/base/ray.h"
#include "core/base/simd.h"

namespace lentray::core {

/// Eight children. A child is a node's index, or kLeaf + a code of 31 bits, for the caller to
/// choose; as built it is count * 2^27 + first place.
struct alignas(64) WideNode {
  static constexpr int kWidth = 8;
  static constexpr std::uint32_t kLeaf = 0x80000000u;
  static constexpr std::uint32_t kFirstBits = 27, kMaxCount = 15;

  float planes[3][2][kWidth];  ///< axis; 0 low, 1 high; empty slots are inside out
  std::uint32_t child[kWidth];
  std::uint32_t used = 0;  ///< slots 0 .. used - 1 are taken
};

/// Maps the boxes' space to the tree's: p' = (p - offset) * scale, scale a power of two.
struct WideFrame {
  Vec3 offset;
  double scale = 1.0;
  double pad = 0.0;      ///< rounding to allow for, in the tree's units
  bool has_far = false;  ///< there are boxes beyond -1 .. 1
  Vec3 point(const Vec3& p) const { return (p - offset) * scale; }
};

/// What the ways of testing boxes share: t as the tree has it, t' = (t - start) * rate.
struct WideLimits {
  bool misses = false;  ///< the ray cannot meet any box
  double start = 0.0;
  double rate = 1.0;   ///< largest component of the direction in the tree's frame
  double slack = 0.0;  ///< rounding of t', absolute

  /// Limits of t as the box tests use them, rounded outwards.
  float upper(double t) const { return up((t - start) * rate + slack); }
  float lower(double t) const { return down((t - start) * rate - slack); }

  /// Six times a float's rounding: one goes into the conversion, one into the widening itself,
  /// and four are left. The slab test makes three (reciprocal, difference, product), relative to
  /// a distance that is at most the sum of two widened numbers, so it needs none of its own.
  static constexpr float kWider = 0x1.8p-22f;
  static float up(double x) {
    const auto f = static_cast<float>(std::min(std::max(x, -1e36), 1e36));
    return f + __builtin_fabsf(f) * kWider;
  }
  static float down(double x) { return -up(-x); }

  /// Origins further than this from the middle are moved along the ray to the boxes, for floats
  /// could not distinguish the boxes from there.
  static constexpr double kNear = 4.0;
  /// Direction components are at least this part of the largest: along a range of 8 such a ray
  /// drifts by 2^-59, less than any box is padded.
  static constexpr double kLeastComponent = 0x1p-62;

 protected:
  /// Moves the origin; `error` grows by what that and its distance cost.
  void approach(Vec3& origin, const Vec3& direction, double& error, bool has_far);
};

/// A ray as the box tests see it: in the tree's frame, direction scaled so that its largest
/// component is 1, everything rounded outwards. For the portable tests.
struct WideRay : WideLimits {
  float inverse[3];      ///< 1 / direction, finite
  float near_origin[3];  ///< rounded so that entries come early
  float far_origin[3];   ///< ... and exits late
  int entry[3];          ///< 0: the low plane is entered first, 1: the high one

  WideRay(const Ray& ray, const WideFrame& frame);
};

/// The same for AVX2: products origin * inverse, so that a plane costs one fused operation.
struct WideRayAvx2 : WideLimits {
  Float4 inverse, near_product, far_product;  ///< lane 3 means nothing
  int entry[3];

  LENTRAY_AVX2 WideRayAvx2(const Ray& ray, const WideFrame& frame) {
    const Long4 xyz{-1, -1, -1, 0};
    // Both loads stay within the ray: (o, dx) and (oz, d).
    const Double4 world_d = simd::shuffled<1, 2, 3, 0>(simd::double4_at(&ray.origin.z));
    const Double4 offset = simd::double4_at(&frame.offset.x);
    const Double4 away = simd::double4_at(&ray.origin.x) - offset;
    Double4 o = Double4(Long4(away * frame.scale) & xyz);
    const Double4 d = Double4(Long4(world_d * frame.scale) & xyz);
    const Double4 size_o = simd::abs(o), size_d = simd::abs(d);
    Double4 largest = simd::max(size_d, simd::shuffled<2, 3, 0, 1>(size_d));
    largest = simd::max(largest, simd::shuffled<1, 0, 3, 2>(largest));
    rate = largest[0];
    const bool are_finite = simd::signs(size_o + size_d < 1e300) == 15;  // no number is not less
    misses = !(rate > 0.0) || !are_finite;
    double error = frame.pad;
    if (simd::signs(size_o > kNear) != 0) {
      if (misses) return;
      alignas(32) double from[4], along[4];
      simd::store(from, o);
      simd::store(along, d);
      Vec3 moved{from[0], from[1], from[2]};
      approach(moved, Vec3{along[0], along[1], along[2]} / rate, error, frame.has_far);
      o = Double4{moved.x, moved.y, moved.z, 0.0};
    }
    const Double4 least = largest * kLeastComponent;
    const Double4 component = simd::with_signs(simd::max(size_d, least), d);
    inverse = simd::narrowed(largest / component);
    const Double4 rounded = simd::widened(inverse);
    const Double4 product = o * rounded;
    const Double4 around = simd::abs(rounded) * error;
    const Float4 wider = simd::float4(kWider);
    const Float4 high = simd::narrowed(product + around);
    const Float4 low = simd::narrowed(product - around);
    near_product = simd::fma(simd::abs(high), wider, high);
    far_product = simd::fnma(simd::abs(low), wider, low);
    const auto negative = static_cast<int>(simd::signs(inverse));
    entry[0] = negative & 1;
    entry[1] = negative >> 1 & 1;
    entry[2] = negative >> 2 & 1;
  }
  template <int kAxis>
  LENTRAY_AVX2 static Float8 all(Float4 v) {
    return simd::float8(v[kAxis]);
  }
};

/// Boxes tested by a traversal, or nothing at all.
struct CountBoxes {
  std::uint64_t boxes = 0;
  void add(const WideNode& node) { boxes += node.used; }
  void add(std::uint64_t more) { boxes += more; }
};
struct CountNothing {
  void add(const WideNode&) {}
  void add(std::uint64_t) {}
};

class WideBvh {
 public:
  struct Options {
    int pack = 1;       ///< parts a leaf tests in the time of one (SIMD)
    double cost = 1.0;  ///< of such a test, in node tests
    int max_leaf = 8;   ///< parts a leaf, at most 15
    /// If not empty: one kind a part; leaves are then of one kind each, with that kind's costs.
    std::span<const std::uint8_t> kinds;
    struct Kind {
      int pack = 1;
      double cost = 1.0;
      int max_leaf = 4;
    };
    std::span<const Kind> kind_costs;
  };
  struct Statistics {
    std::size_t nodes = 0, leaves = 0, parts = 0;
    int depth = 0;
  };

  WideBvh() = default;
  /// Boxes must be finite. Parts with an empty box are left out.
  explicit WideBvh(std::span<const Bounds> boxes) { build(boxes, Options{}); }
  WideBvh(std::span<const Bounds> boxes, const Options& options) { build(boxes, options); }
  /// The same of boxes that nobody needs any more: their memory serves while it is built.
  WideBvh(std::vector<Bounds>&& boxes, const Options& options) { build(boxes, options, &boxes); }

  /// order()[place] is the part (its index among the boxes given) at a place of a leaf. Callers
  /// may keep their parts in that order and use places directly.
  const std::vector<std::uint32_t>& order() const { return m_order; }
  /// Who has placed the parts and relabelled the leaves needs it no more.
  void drop_order() { m_order = std::vector<std::uint32_t>(); }
  const Bounds& bounds() const { return m_bounds; }
  bool empty() const { return m_nodes.empty(); }
  std::size_t memory() const;
  const Statistics& statistics() const { return m_statistics; }
  /// For walks of others (core/bundle): the root first.
  std::span<const WideNode> nodes() const { return m_nodes; }
  const WideFrame& frame() const { return m_frame; }
  /// The most children that a walk has still to visit.
  static constexpr int most_waiting() { return kStack; }

  /// Calls leaf(first, count, t_max) for the leaves the ray may meet, near ones first. The leaf
  /// tests the parts at places first .. first + count - 1, lowers t_max (double&) to what is
  /// still of interest, and returns true to end the search. Returns whether a leaf ended it.
  template <class Leaf>
  bool traverse(const Ray& ray, double t_min, double t_max, Leaf&& leaf) const {
    CountNothing nothing;
    return has_avx2() ? traverse_avx2<true>(ray, t_min, t_max, leaf, nothing)
                      : traverse_portable(ray, t_min, t_max, leaf, nothing);
  }
  /// Calls leaf(first, count) or leaf(code), true to end, for the leaves with a box that may hold the
  /// point.
  template <class Leaf>
  bool at_point(const Vec3& point, Leaf&& leaf) const;

  /// Replaces each leaf's code by code(first, count), below 2^31. Callers that do so use
  /// traverse_avx2 and traverse_portable and read the codes themselves.
  template <class Code>
  void relabel(Code&& code) {
    for (WideNode& node : m_nodes) {
      for (std::uint32_t i = 0; i < node.used; ++i) {
        std::uint32_t& child = node.child[i];
        if (child & WideNode::kLeaf)
          child = WideNode::kLeaf | code(first_of(child), count_of(child));
      }
    }
  }
  static std::uint32_t first_of(std::uint32_t code) {
    return code & ((1u << WideNode::kFirstBits) - 1);
  }
  static std::uint32_t count_of(std::uint32_t code) {
    return (code >> WideNode::kFirstBits) & WideNode::kMaxCount;
  }

  /// Calls visit(first, count) for every leaf, once.
  template <class Visit>
  void for_each_leaf(Visit&& visit) const {
    for (const WideNode& node : m_nodes) {
      for (std::uint32_t i = 0; i < node.used; ++i) {
        const std::uint32_t child = node.child[i];
        if (child & WideNode::kLeaf) visit(first_of(child), count_of(child));
      }
    }
  }

  /// The two ways of traverse(), for callers with leaves of their own for each; the leaf may also
  /// be one that takes its code: leaf(code, t_max). kOrdered: near children first; else as they come (any-hit searches).
  template <bool kOrdered, class Leaf, class Count>
  LENTRAY_AVX2 bool traverse_avx2(const Ray& ray, double t_min, double t_max, Leaf& leaf,
                                  Count& count) const;
  template <class Leaf, class Count>
  bool traverse_portable(const Ray& ray, double t_min, double t_max, Leaf& leaf,
                         Count& count) const;

 private:
  /// A child to visit, and where its box is entered.
  struct Entry {
    float t;
    std::uint32_t child;
  };
  static constexpr int kMaxDepth = 80;
  static constexpr int kStack = kMaxDepth * (WideNode::kWidth - 1) + WideNode::kWidth;

  /// Lets the list that `own` points to go when the boxes are not needed any more.
  void build(std::span<const Bounds> boxes, const Options& options,
             std::vector<Bounds>* own = nullptr);
  /// A bit for each of the node's boxes that the one from `low` to `high` touches.
  static unsigned touched_portable(const WideNode& node, const float low[3], const float high[3]);
  LENTRAY_AVX2 static unsigned touched_avx2(const WideNode& node, const float low[3],
                                            const float high[3]);
  template <class Leaf>
  static constexpr bool kTakesPlaces =
      std::is_invocable_v<Leaf&, std::uint32_t, std::uint32_t, double&>;
  static void sort_far_first(Entry* first, Entry* last) {
    for (Entry* i = first + 1; i < last; ++i) {
      const Entry e = *i;
      Entry* j = i;
      for (; j > first && j[-1].t < e.t; --j) *j = j[-1];
      *j = e;
    }
  }

  std::vector<WideNode> m_nodes;  ///< the root first
  std::vector<std::uint32_t> m_order;
  WideFrame m_frame;
  Bounds m_bounds;
  Statistics m_statistics;
};

template <bool kOrdered, class Leaf, class Count>
LENTRAY_AVX2 bool WideBvh::traverse_avx2(const Ray& world, double t_min, double t_max, Leaf& leaf,
                                         Count& count) const {
  if (m_nodes.empty()) return false;
  const WideRayAvx2 ray(world, m_frame);
  if (ray.misses) return false;
  const Float8 ix = ray.all<0>(ray.inverse), iy = ray.all<1>(ray.inverse),
               iz = ray.all<2>(ray.inverse);
  const Float8 nx = ray.all<0>(ray.near_product), ny = ray.all<1>(ray.near_product),
               nz = ray.all<2>(ray.near_product);
  const Float8 fx = ray.all<0>(ray.far_product), fy = ray.all<1>(ray.far_product),
               fz = ray.all<2>(ray.far_product);
  const int ex = ray.entry[0], ey = ray.entry[1], ez = ray.entry[2];
  const Float8 from = simd::float8(ray.lower(t_min));
  float to = ray.upper(t_max);
  Entry stack[kStack];
  int top = 0;
  std::uint32_t at = 0;
  alignas(32) float entered[WideNode::kWidth];
  for (;;) {
    if (at & WideNode::kLeaf) {
      const double before = t_max;
      // In line here: a leaf for AVX2 is only inlined into a function for AVX2.
      if constexpr (kTakesPlaces<Leaf>) {
        if (leaf(first_of(at), count_of(at), t_max)) return true;
      } else {
        if (leaf(at & ~WideNode::kLeaf, t_max)) return true;
      }
      if (t_max < before) to = ray.upper(t_max);
    } else {
      const WideNode& node = m_nodes[at];
      count.add(node);
      const auto& p = node.planes;
      const Float8 t1x = simd::fms(simd::float8_at(p[0][ex]), ix, nx);
      const Float8 t1y = simd::fms(simd::float8_at(p[1][ey]), iy, ny);
      const Float8 t1z = simd::fms(simd::float8_at(p[2][ez]), iz, nz);
      const Float8 t2x = simd::fms(simd::float8_at(p[0][ex ^ 1]), ix, fx);
      const Float8 t2y = simd::fms(simd::float8_at(p[1][ey ^ 1]), iy, fy);
      const Float8 t2z = simd::fms(simd::float8_at(p[2][ez ^ 1]), iz, fz);
      Float8 t1 = simd::max(simd::max(t1x, t1y), t1z);
      Float8 t2 = simd::min(simd::min(t2x, t2y), t2z);
      t1 = simd::max(t1, from);
      t2 = simd::min(t2, simd::float8(to));
      std::uint32_t hit = simd::signs(t1 <= t2);
      if (hit != 0) {
        const int first = std::countr_zero(hit);
        hit &= hit - 1;
        if (hit == 0) {
          at = node.child[first];
          continue;
        }
        simd::store(entered, t1);
        const int base = top;
        stack[top++] = {entered[first], node.child[first]};
        do {
          const int i = std::countr_zero(hit);
          hit &= hit - 1;
          stack[top++] = {entered[i], node.child[i]};
        } while (hit != 0);
        if constexpr (kOrdered) sort_far_first(stack + base, stack + top);
        at = stack[--top].child;
        continue;
      }
    }
    do {
      if (top == 0) return false;
      --top;
    } while (stack[top].t > to);
    at = stack[top].child;
  }
}

template <class Leaf, class Count>
bool WideBvh::traverse_portable(const Ray& world, double t_min, double t_max, Leaf& leaf,
                                Count& count) const {
  if (m_nodes.empty()) return false;
  const WideRay ray(world, m_frame);
  if (ray.misses) return false;
  const float from = ray.lower(t_min);
  float to = ray.upper(t_max);
  Entry stack[kStack];
  int top = 0;
  std::uint32_t at = 0;
  for (;;) {
    if (at & WideNode::kLeaf) {
      const double before = t_max;
      // In line here: a leaf for AVX2 is only inlined into a function for AVX2.
      if constexpr (kTakesPlaces<Leaf>) {
        if (leaf(first_of(at), count_of(at), t_max)) return true;
      } else {
        if (leaf(at & ~WideNode::kLeaf, t_max)) return true;
      }
      if (t_max < before) to = ray.upper(t_max);
    } else {
      const WideNode& node = m_nodes[at];
      count.add(node);
      float t1[WideNode::kWidth], t2[WideNode::kWidth];
      for (int i = 0; i < WideNode::kWidth; ++i) {
        t1[i] = from;
        t2[i] = to;
      }
      for (int a = 0; a < 3; ++a) {
        const float* enter = node.planes[a][ray.entry[a]];
        const float* leave = node.planes[a][ray.entry[a] ^ 1];
        for (int i = 0; i < WideNode::kWidth; ++i) {
          const float n = (enter[i] - ray.near_origin[a]) * ray.inverse[a];
          const float f = (leave[i] - ray.far_origin[a]) * ray.inverse[a];
          t1[i] = t1[i] > n ? t1[i] : n;
          t2[i] = t2[i] < f ? t2[i] : f;
        }
      }
      const int base = top;
      for (int i = 0; i < WideNode::kWidth; ++i) {
        if (t1[i] <= t2[i]) stack[top++] = {t1[i], node.child[i]};
      }
      sort_far_first(stack + base, stack + top);
    }
    do {
      if (top == 0) return false;
      --top;
    } while (stack[top].t > to);
    at = stack[top].child;
  }
}

template <class Leaf>
bool WideBvh::at_point(const Vec3& point, Leaf&& leaf) const {
  if (m_nodes.empty()) return false;
  const Vec3 p = m_frame.point(point);
  float low[3], high[3];
  for (int a = 0; a < 3; ++a) {
    low[a] = WideRay::down(p[a] - m_frame.pad);
    high[a] = WideRay::up(p[a] + m_frame.pad);
  }
  std::uint32_t stack[kStack];
  int top = 0;
  stack[top++] = 0;
  while (top != 0) {
    const std::uint32_t at = stack[--top];
    if (at & WideNode::kLeaf) {
      if constexpr (std::is_invocable_v<Leaf&, std::uint32_t, std::uint32_t>) {
        if (leaf(first_of(at), count_of(at))) return true;
      } else {
        if (leaf(at & ~WideNode::kLeaf)) return true;
      }
      continue;
    }
    const WideNode& node = m_nodes[at];
    unsigned in = has_avx2() ? touched_avx2(node, low, high) : touched_portable(node, low, high);
    while (in != 0) {
      const int i = std::bit_width(in) - 1;
      in ^= 1u << i;
      stack[top++] = node.child[i];
    }
  }
  return false;
}

}  // namespace lentray::core
