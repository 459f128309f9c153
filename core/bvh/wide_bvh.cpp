#include "core/bvh/wide_bvh.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "core/bvh/wide_collapse.h"

namespace lentray::core {
void WideLimits::approach(Vec3& o, const Vec3& d, double& error, bool has_far) {
  const double far = std::max({std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)});
  error += far * 0x1p-48;
  const double reach = 1.125 + 2.0 * error;  // a little before the boxes
  double enter = -Bounds::kInf, leave = Bounds::kInf;
  bool passes = false;  // by the middle, perhaps towards far boxes
  for (int a = 0; a < 3; ++a) {
    if (std::fabs(d[a]) < kLeastComponent) {
      if (std::fabs(o[a]) > reach) passes = true;
      continue;
    }
    const double t1 = (-reach - o[a]) / d[a], t2 = (reach - o[a]) / d[a];
    enter = std::max(enter, std::min(t1, t2));
    leave = std::min(leave, std::max(t1, t2));
  }
  if (passes || !(enter <= leave)) {
    misses = !has_far;
    if (misses) return;
    enter = -dot(o, d) / dot(d, d);
  }
  o += d * enter;
  start = enter / rate;
  slack = 4.0 * error;
}

WideRay::WideRay(const Ray& ray, const WideFrame& frame) {
  Vec3 o = frame.point(ray.origin);
  Vec3 d = ray.direction * frame.scale;
  rate = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  const double sum = std::fabs(o.x) + std::fabs(o.y) + std::fabs(o.z) + std::fabs(d.x) +
                     std::fabs(d.y) + std::fabs(d.z);
  misses = !(rate > 0.0 && sum < 1e300);  // no number is not less
  if (misses) return;
  d /= rate;
  double error = frame.pad;
  if (std::max({std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)}) > kNear) {
    approach(o, d, error, frame.has_far);
  }
  if (misses) return;
  for (int a = 0; a < 3; ++a) {
    const double component = std::copysign(std::max(std::fabs(d[a]), kLeastComponent), d[a]);
    inverse[a] = static_cast<float>(1.0 / component);
    entry[a] = component < 0.0 ? 1 : 0;
    const float above = up(o[a] + error), below = down(o[a] - error);
    near_origin[a] = entry[a] ? below : above;
    far_origin[a] = entry[a] ? above : below;
  }
}

namespace {

/// A part while the tree is built: its box, whose lanes 3 hold the part's index and kind.
struct Item {
  FloatBox box;

  static constexpr std::uint32_t kNumber = 0x40000000u;  // makes a plain float of 27 bits
  std::uint32_t part() const { return lane3(box.low) & ~kNumber; }
  std::uint32_t kind() const { return lane3(box.high) & ~kNumber; }
  static std::uint32_t lane3(Float4 v) { return static_cast<std::uint32_t>(Int4(v)[3]); }
};

/// Rounded outwards.
Item item_of(const Bounds& bounds, const WideFrame& frame, std::uint32_t part, std::uint32_t kind) {
  const Vec3 lo = frame.point(bounds.lo), hi = frame.point(bounds.hi);
  const auto low = [&](double v) { return -WideLimits::down(v - frame.pad); };
  const auto high = [&](double v) { return WideLimits::up(v + frame.pad); };
  Item item;
  item.box.low =
      Float4{low(lo.x), low(lo.y), low(lo.z), std::bit_cast<float>(Item::kNumber | part)};
  item.box.high =
      Float4{high(hi.x), high(hi.y), high(hi.z), std::bit_cast<float>(Item::kNumber | kind)};
  return item;
}

/// An array that is not touched before it is used.
template <class T>
class Untouched {
 public:
  explicit Untouched(std::size_t n) : m_data(static_cast<T*>(::operator new(n * sizeof(T)))) {}
  T& operator[](std::size_t i) { return m_data.get()[i]; }
  const T& operator[](std::size_t i) const { return m_data.get()[i]; }

 private:
  struct Free {
    void operator()(T* data) const { ::operator delete(data); }
  };
  static_assert(std::is_trivially_destructible_v<T>);
  std::unique_ptr<T, Free> m_data;
};

/// Top-down binary build by the surface-area heuristic over binned centres, of samples where parts
/// are many.
class BinaryBuilder {
 public:
  BinaryBuilder(std::span<const Bounds> boxes, const std::vector<std::uint32_t>& parts,
                const WideFrame& frame, const WideBvh::Options& options);

  std::uint32_t run() { return split(0, m_count, 0, m_all, m_alike); }
  std::span<const Branch> branches() const { return {&m_branches[0], m_used}; }
  std::uint32_t part_at(std::uint32_t place) const { return m_items[place].part(); }
  /// When nobody asks for part_at() any more.
  void drop_items() { m_items = Untouched<Item>(0); }

 private:
  /// Few parts need few bins.
  static int bins_for(std::uint32_t count) { return count <= 8 ? 4 : count <= 32 ? 8 : 16; }
  // Of one binary step. An 8-wide node does about three, in the time of one test; the rest is that nodes are
  // made and fetched.
  static constexpr double kNodeCost = 0.4;
  static constexpr std::uint32_t kMostSampled = 2048;
  struct Bin {
    FloatBox box;
    std::uint32_t count = 0;
  };
  /// Of some parts: their box, and that of twice their middles.
  struct Extent {
    FloatBox box, middles;
    void include(const Item& item) {
      box.include(item.box);
      const Float4 middle = item.box.middle();
      middles.include({Float4{} - middle, middle});
    }
  };
  /// bin_of: (middle - start) * per_bin, below 0 and above the bins too by rounding.
  struct Bins {
    Float4 start, per_bin;
    bool any = false;  ///< else all middles are alike
    Bins(const FloatBox& middles, int bins);
    Float4 of(const Item& item) const { return (item.box.middle() - start) * per_bin; }
  };
  struct Split {
    double cost = Bounds::kInf;
    int axis = -1, bin = 0;
  };

  WideBvh::Options::Kind kind_of(const Item& item) const {
    if (m_options.kinds.empty()) return {m_options.pack, m_options.cost, m_options.max_leaf};
    return m_options.kind_costs[item.kind()];
  }
  bool one_kind(std::uint32_t first, std::uint32_t count) const {
    const std::uint32_t kind = m_items[first].kind();
    for (std::uint32_t i = first + 1; i < first + count; ++i) {
      if (m_items[i].kind() != kind) return false;
    }
    return true;
  }

  std::uint32_t split(std::uint32_t first, std::uint32_t count, int depth, const Extent& extent,
                      bool alike);
  static double leaf_cost_parts(std::uint32_t count, int pack) {
    return static_cast<double>((count + static_cast<std::uint32_t>(pack) - 1) /
                               static_cast<std::uint32_t>(pack));
  }
  Split best_split(std::uint32_t first, std::uint32_t count, const FloatBox& middles,
                   bool alike) const {
    switch (bins_for(count)) {
      case 4: return best_split<4>(first, count, middles, alike);
      case 8: return best_split<8>(first, count, middles, alike);
      default: return best_split<16>(first, count, middles, alike);
    }
  }
  template <int kUsed>
  Split best_split(std::uint32_t first, std::uint32_t count, const FloatBox& middles,
                   bool alike) const;
  template <class IsLeft>
  std::uint32_t divide(std::uint32_t first, std::uint32_t count, Extent& left, Extent& right,
                       IsLeft&& is_left);
  std::uint32_t divide(std::uint32_t first, std::uint32_t count, const Split& split,
                       const FloatBox& middles, Extent& left, Extent& right);

  const WideBvh::Options& m_options;
  std::uint32_t m_count;
  Untouched<Item> m_items;
  Untouched<Branch> m_branches;
  Extent m_all;
  bool m_alike = true;
  std::atomic<std::uint32_t> m_used{0};
};

BinaryBuilder::BinaryBuilder(std::span<const Bounds> boxes, const std::vector<std::uint32_t>& parts,
                             const WideFrame& frame, const WideBvh::Options& options)
    : m_options(options), m_count(static_cast<std::uint32_t>(parts.size())), m_items(parts.size()),
      m_branches(2 * parts.size()) {
  for (std::uint32_t i = 0; i < m_count; ++i) {
    const std::uint32_t part = parts[i], kind = options.kinds.empty() ? 0u : options.kinds[part];
    m_items[i] = item_of(boxes[part], frame, part, kind);
    m_all.include(m_items[i]);
  }
  m_alike = options.kinds.empty() || one_kind(0, m_count);
}

BinaryBuilder::Bins::Bins(const FloatBox& middles, int bins) : start(Float4{} - middles.low) {
  alignas(16) float size[4], rate[4] = {};
  simd::store(size, middles.high + middles.low);
  for (int a = 0; a < 3; ++a) {
    const float per = static_cast<float>(bins) / size[a];
    if (!(size[a] > 0.0f && std::isfinite(per))) continue;
    rate[a] = per;
    any = true;
  }
  per_bin = simd::float4_at(rate);
}

template <int kUsed>
BinaryBuilder::Split BinaryBuilder::best_split(std::uint32_t first, std::uint32_t count,
                                               const FloatBox& middles, bool alike) const {
  const Bins place(middles, kUsed);
  Split best;
  if (!place.any) return best;
  Bin bins[3][kUsed];
  double weight = 0.0;
  const Float4 last = simd::float4(kUsed - 1);
  const std::uint32_t step = std::max(1u, count / kMostSampled), end = first + count;
  for (std::uint32_t i = first; i < end; i += step) {
    const Item& item = m_items[i];
    const Int4 at = simd::truncated(simd::max(simd::min(place.of(item), last), Float4{}));
    const auto add = [&](Bin& bin) {
      bin.box.include(item.box);
      ++bin.count;
    };
    add(bins[0][at[0]]);
    add(bins[1][at[1]]);
    add(bins[2][at[2]]);
    if (alike) continue;
    const auto kind = kind_of(item);
    weight += kind.cost / kind.pack;
  }
  // Cost of one started pack of parts on average: small sides pay for whole packs.
  const auto kind = kind_of(m_items[first]);
  const int pack = step > 1 ? 1 : kind.pack;
  const double packs_a_part = 1.0 / pack, started = packs_a_part * (pack - 1) + 1e-9;
  const auto packs = [&](std::uint32_t n) {  // leaf_cost_parts without its division
    return static_cast<double>(static_cast<std::int32_t>(n * packs_a_part + started));
  };
  const std::uint32_t sampled = (count + step - 1) / step;
  const double pack_cost = (alike ? kind.cost / kind.pack : weight / sampled) * pack * step;
  for (int a = 0; a < 3; ++a) {
    double right_cost[kUsed];
    FloatBox box;
    std::uint32_t n = 0;
    for (int b = kUsed - 1; b > 0; --b) {
      box.include(bins[a][b].box);
      n += bins[a][b].count;
      right_cost[b] = n == 0 ? Bounds::kInf : box.surface() * packs(n) * pack_cost;
    }
    box = FloatBox{};
    n = 0;
    for (int b = 1; b < kUsed; ++b) {
      box.include(bins[a][b - 1].box);
      n += bins[a][b - 1].count;
      if (n == 0) continue;
      const double cost = box.surface() * packs(n) * pack_cost + right_cost[b];
      if (cost < best.cost) best = {cost, a, b};
    }
  }
  return best;
}

template <class IsLeft>
std::uint32_t BinaryBuilder::divide(std::uint32_t first, std::uint32_t count, Extent& left,
                                    Extent& right, IsLeft&& is_left) {
  std::uint32_t from = first, to = first + count;
  while (from < to) {
    const Item item = m_items[from];
    if (is_left(item)) {
      left.include(item);
      ++from;
    } else {
      right.include(item);
      --to;
      m_items[from] = m_items[to];
      m_items[to] = item;
    }
  }
  return from - first;
}

/// Orders the parts so that the left side comes first; returns how many that are.
std::uint32_t BinaryBuilder::divide(std::uint32_t first, std::uint32_t count, const Split& split,
                                    const FloatBox& middles, Extent& left, Extent& right) {
  if (split.axis >= 0) {
    const Bins place(middles, bins_for(count));
    const Float4 limit = simd::float4(static_cast<float>(split.bin));
    const unsigned axis = 1u << split.axis;
    const std::uint32_t n = divide(first, count, left, right, [&](const Item& item) {
      return (simd::signs(place.of(item) < limit) & axis) != 0;
    });
    if (n != 0 && n != count) return n;
    left = right = Extent{};
  }
  const std::uint32_t n = count / 2;  // all middles alike
  for (std::uint32_t i = 0; i < count; ++i) (i < n ? left : right).include(m_items[first + i]);
  return n;
}

std::uint32_t BinaryBuilder::split(std::uint32_t first, std::uint32_t count, int depth,
                                   const Extent& extent, bool alike) {
  const std::uint32_t self = m_used.fetch_add(1);
  Branch& branch = m_branches[self];
  branch.set_box(extent.box);
  branch.set_leaf(first, count);
  if (count == 1) return self;
  alike = alike || one_kind(first, count);
  const auto kind = kind_of(m_items[first]);
  // Splits by area lean to one side at worst one part at a time; halving bounds the depth.
  Split best;
  if (depth < 40) best = best_split(first, count, extent.middles, alike);
  if (alike && count <= static_cast<std::uint32_t>(kind.max_leaf)) {
    const double area = extent.box.surface();
    const double as_leaf = leaf_cost_parts(count, kind.pack) * kind.cost * area;
    if (!(best.cost + kNodeCost * area < as_leaf)) return self;
  }
  Extent left, right;
  std::uint32_t lefts;
  if (!alike && count <= 4) {
    // A few parts of different kinds: a leaf a kind.
    const std::uint32_t index = m_items[first].kind();
    lefts =
        divide(first, count, left, right, [&](const Item& item) { return item.kind() == index; });
  } else {
    lefts = divide(first, count, best, extent.middles, left, right);
  }
#ifdef __SANITIZE_THREAD__
  // What oneTBB's library synchronises inside is not seen: every branch would be reported.
  constexpr std::uint32_t kParallel = ~0u;
#else
  constexpr std::uint32_t kParallel = 4096;
#endif
  const auto do_left = [&] { branch.set_left(split(first, lefts, depth + 1, left, alike)); };
  const auto do_right = [&] {
    branch.set_right(split(first + lefts, count - lefts, depth + 1, right, alike));
  };
  if (count > kParallel) {
    tbb::parallel_invoke(do_left, do_right);
  } else {
    do_left();
    do_right();
  }
  return self;
}

double reach_from(const Vec3& middle, const Bounds& box) {
  double reach = 0.0;
  for (int a = 0; a < 3; ++a) {
    reach = std::max({reach, std::fabs(box.lo[a] - middle[a]), std::fabs(box.hi[a] - middle[a])});
  }
  return reach;
}

/// The bounds of all boxes but of a few that reach much farther than the rest.
Bounds bulk_of(std::span<const Bounds> boxes, const std::vector<std::uint32_t>& parts,
               const Bounds& all) {
  constexpr std::size_t kFewest = 16, kMostSampled = 1024;
  constexpr double kMuchFarther = 1024.0;
  if (parts.size() < kFewest) return all;
  const std::size_t step = std::max<std::size_t>(1, parts.size() / kMostSampled);
  const auto quantile = [&](double part, auto&& value_of) {
    std::vector<double> values;
    for (std::size_t i = 0; i < parts.size(); i += step)
      values.push_back(value_of(boxes[parts[i]]));
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  Vec3 middle;
  for (int a = 0; a < 3; ++a) {
    middle[a] = quantile(0.5, [a](const Bounds& b) { return b.lo[a] * 0.5 + b.hi[a] * 0.5; });
  }
  const double limit =
      kMuchFarther * quantile(0.9, [&](const Bounds& b) { return reach_from(middle, b); });
  if (!(reach_from(middle, all) > limit)) return all;
  Bounds bulk;
  for (const std::uint32_t part : parts) {
    if (reach_from(middle, boxes[part]) <= limit) bulk.include(boxes[part]);
  }
  return bulk;
}

/// `bulk`: of the boxes that the frame is made for, among `all`.
WideFrame frame_of(const Bounds& bulk, const Bounds& all) {
  WideFrame frame;
  frame.has_far = !(bulk.lo == all.lo && bulk.hi == all.hi);
  frame.offset = bulk.lo * 0.5 + bulk.hi * 0.5;
  const Vec3 half = bulk.hi * 0.5 - bulk.lo * 0.5;
  const double size = std::max({half.x, half.y, half.z, 1e-290});
  int exponent = 0;
  std::frexp(size, &exponent);  // size < 2^exponent
  frame.scale = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  const double far =
      std::max({std::fabs(frame.offset.x), std::fabs(frame.offset.y), std::fabs(frame.offset.z)});
  frame.pad = 0x1p-46 + far * frame.scale * 0x1p-48;
  return frame;
}

}  // namespace

void WideBvh::build(std::span<const Bounds> boxes, const Options& options,
                    std::vector<Bounds>* own) {
  m_order.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].is_empty()) continue;
    m_order.push_back(static_cast<std::uint32_t>(i));
    m_bounds.include(boxes[i]);
  }
  if (m_order.empty()) return;
  if (m_order.size() >> WideNode::kFirstBits != 0) {
    throw std::length_error("more parts than a bounding hierarchy holds");
  }
  m_frame = frame_of(bulk_of(boxes, m_order, m_bounds), m_bounds);
  BinaryBuilder builder(boxes, m_order, m_frame, options);
  if (own) *own = std::vector<Bounds>();  // `= {}` would keep the memory
  const std::uint32_t root = builder.run();
  for (std::uint32_t i = 0; i < m_order.size(); ++i) m_order[i] = builder.part_at(i);
  builder.drop_items();  // the memory serves what is made next
  WideCollapse(builder.branches()).make(root, m_nodes, m_statistics);
  m_statistics.parts = m_order.size();
}

unsigned WideBvh::touched_portable(const WideNode& node, const float low[3], const float high[3]) {
  unsigned touched = 0;
  for (int i = 0; i < WideNode::kWidth; ++i) {
    bool in = true;
    for (int a = 0; a < 3; ++a) {
      in = in && node.planes[a][0][i] <= high[a] && node.planes[a][1][i] >= low[a];
    }
    touched |= static_cast<unsigned>(in) << i;
  }
  return touched;
}

LENTRAY_AVX2 unsigned WideBvh::touched_avx2(const WideNode& node, const float low[3],
                                            const float high[3]) {
  auto in = simd::float8_at(node.planes[0][0]) <= simd::float8(high[0]);
  in &= simd::float8_at(node.planes[0][1]) >= simd::float8(low[0]);
  for (int a = 1; a < 3; ++a) {
    in &= simd::float8_at(node.planes[a][0]) <= simd::float8(high[a]);
    in &= simd::float8_at(node.planes[a][1]) >= simd::float8(low[a]);
  }
  return simd::signs(in);
}

std::size_t WideBvh::memory() const {
  return m_nodes.capacity() * sizeof(WideNode) + m_order.capacity() * sizeof(std::uint32_t);
}

}  // namespace lentray::core
