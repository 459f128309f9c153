#include "core/accel/wide_bvh.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace lentray::core {
void WideLimits::approach(Vec3& o, const Vec3& d, double& error) {
  const double far = std::max({std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)});
  error += far * 0x1p-48;
  const double reach = 1.125 + 2.0 * error;  // a little before the boxes
  double enter = -Bounds::kInf, leave = Bounds::kInf;
  for (int a = 0; a < 3; ++a) {
    if (std::fabs(d[a]) < kLeastComponent) {
      if (std::fabs(o[a]) > reach) misses = true;
      continue;
    }
    const double t1 = (-reach - o[a]) / d[a], t2 = (reach - o[a]) / d[a];
    enter = std::max(enter, std::min(t1, t2));
    leave = std::min(leave, std::max(t1, t2));
  }
  if (misses || !(enter <= leave)) {
    misses = true;
    return;
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
  if (std::max({std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)}) > kNear) approach(o, d, error);
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

struct Branch {
  Bounds box;
  std::uint32_t left = 0, right = 0;  ///< branches, if count is 0
  std::uint32_t first = 0, count = 0;
};

/// Top-down binary build by the surface-area heuristic over binned centres.
class BinaryBuilder {
 public:
  BinaryBuilder(std::span<const Bounds> boxes, const WideBvh::Options& options,
                std::vector<std::uint32_t>& order)
      : m_boxes(boxes), m_options(options), m_order(order), m_branches(2 * order.size() + 1) {}

  std::uint32_t run() { return split(0, static_cast<std::uint32_t>(m_order.size()), 0); }
  const Branch& operator[](std::uint32_t i) const { return m_branches[i]; }

 private:
  static constexpr int kBins = 32, kFewBins = 8;
  /// Few parts need few bins.
  static int bins_for(std::uint32_t count) { return count <= kFewBins ? kFewBins : kBins; }
  static constexpr double kNodeCost = 0.35;  // of one binary step: an 8-wide node does about three
  struct Bin {
    Bounds box;
    std::uint32_t count = 0;
    double cost = 0.0;
  };
  struct Split {
    double cost = Bounds::kInf;
    int axis = -1, bin = 0;
  };

  WideBvh::Options::Kind kind_of(std::uint32_t part) const {
    if (m_options.kinds.empty()) return {m_options.pack, m_options.cost, m_options.max_leaf};
    return m_options.kind_costs[m_options.kinds[part]];
  }
  std::uint8_t kind_index(std::uint32_t part) const {
    return m_options.kinds.empty() ? std::uint8_t{0} : m_options.kinds[part];
  }
  bool one_kind(std::uint32_t first, std::uint32_t count) const {
    const std::uint8_t kind = kind_index(m_order[first]);
    return std::all_of(m_order.begin() + first, m_order.begin() + first + count,
                       [&](std::uint32_t part) { return kind_index(part) == kind; });
  }

  std::uint32_t split(std::uint32_t first, std::uint32_t count, int depth);
  std::uint32_t leaf_cost_parts(std::uint32_t count, int pack) const {
    return (count + pack - 1) / pack;
  }
  template <int kUsed>
  Split best_split(std::uint32_t first, std::uint32_t count, const Bounds& centres) const;
  std::uint32_t divide(std::uint32_t first, std::uint32_t count, const Split& split,
                       const Bounds& centres);
  static int bin_of(double centre, double lo, double per_bin, int bins) {
    return std::clamp(static_cast<int>((centre - lo) * per_bin), 0, bins - 1);
  }

  std::span<const Bounds> m_boxes;
  const WideBvh::Options& m_options;
  std::vector<std::uint32_t>& m_order;
  std::vector<Branch> m_branches;
  std::atomic<std::uint32_t> m_used{0};
};

template <int kUsed>
BinaryBuilder::Split BinaryBuilder::best_split(std::uint32_t first, std::uint32_t count,
                                               const Bounds& centres) const {
  Bin bins[3][kUsed];
  const Vec3 size = centres.hi - centres.lo;
  double per_bin[3];
  for (int a = 0; a < 3; ++a) per_bin[a] = size[a] > 0.0 ? kUsed / size[a] : 0.0;
  double weight = 0.0;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const std::uint32_t part = m_order[i];
    const Bounds& box = m_boxes[part];
    const Vec3 centre = box.centre();
    const auto kind = kind_of(part);
    const double cost = kind.cost / kind.pack;
    weight += cost;
    for (int a = 0; a < 3; ++a) {
      if (!(per_bin[a] > 0.0 && std::isfinite(per_bin[a]))) continue;
      Bin& bin = bins[a][bin_of(centre[a], centres.lo[a], per_bin[a], kUsed)];
      bin.box.include(box);
      ++bin.count;
      bin.cost += cost;
    }
  }
  // Cost of one started pack of parts on average: small sides pay for whole packs.
  const int pack = kind_of(m_order[first]).pack;
  const double pack_cost = weight / count * pack;
  Split best;
  for (int a = 0; a < 3; ++a) {
    if (!(per_bin[a] > 0.0 && std::isfinite(per_bin[a]))) continue;
    double right_cost[kUsed];
    Bounds box;
    std::uint32_t n = 0;
    for (int b = kUsed - 1; b > 0; --b) {
      box.include(bins[a][b].box);
      n += bins[a][b].count;
      right_cost[b] = n == 0 ? Bounds::kInf : box.surface() * leaf_cost_parts(n, pack) * pack_cost;
    }
    box = Bounds{};
    n = 0;
    for (int b = 1; b < kUsed; ++b) {
      box.include(bins[a][b - 1].box);
      n += bins[a][b - 1].count;
      if (n == 0) continue;
      const double cost =
          box.surface() * leaf_cost_parts(n, pack) * pack_cost + right_cost[b];
      if (cost < best.cost) best = {cost, a, b};
    }
  }
  return best;
}

/// Orders the parts so that the left side comes first; returns how many that are.
std::uint32_t BinaryBuilder::divide(std::uint32_t first, std::uint32_t count, const Split& split,
                                    const Bounds& centres) {
  const auto begin = m_order.begin() + first, end = begin + count;
  if (split.axis >= 0) {
    const double lo = centres.lo[split.axis];
    const int bins = bins_for(count);
    const double per_bin = bins / (centres.hi[split.axis] - lo);
    const auto middle = std::stable_partition(begin, end, [&](std::uint32_t part) {
      return bin_of(m_boxes[part].centre()[split.axis], lo, per_bin, bins) < split.bin;
    });
    if (middle != begin && middle != end) return static_cast<std::uint32_t>(middle - begin);
  }
  return count / 2;  // all centres alike
}

std::uint32_t BinaryBuilder::split(std::uint32_t first, std::uint32_t count, int depth) {
  const std::uint32_t self = m_used.fetch_add(1);
  Branch& branch = m_branches[self];
  Bounds centres;
  for (std::uint32_t i = first; i < first + count; ++i) {
    branch.box.include(m_boxes[m_order[i]]);
    centres.include(m_boxes[m_order[i]].centre());
  }
  const auto kind = kind_of(m_order[first]);
  const bool alike = one_kind(first, count);
  const bool fits = alike && count <= static_cast<std::uint32_t>(kind.max_leaf);
  if (count == 1) {
    branch.first = first;
    branch.count = count;
    return self;
  }
  std::uint32_t left = 0;
  // Splits by area lean to one side at worst one part at a time; halving bounds the depth.
  Split best;
  if (depth < 40) {
    best = bins_for(count) == kFewBins ? best_split<kFewBins>(first, count, centres)
                                       : best_split<kBins>(first, count, centres);
  }
  if (fits) {
    const double area = branch.box.surface();
    const double as_leaf = leaf_cost_parts(count, kind.pack) * kind.cost * area;
    if (!(best.cost + kNodeCost * area < as_leaf)) {
      branch.first = first;
      branch.count = count;
      return self;
    }
  }
  if (!alike && count <= 4) {
    // A few parts of different kinds: a leaf a kind.
    const std::uint8_t index = kind_index(m_order[first]);
    const auto begin = m_order.begin() + first;
    left = static_cast<std::uint32_t>(
        std::stable_partition(begin, begin + count,
                              [&](std::uint32_t part) { return kind_index(part) == index; }) -
        begin);
  } else {
    left = divide(first, count, best, centres);
  }
#ifdef __SANITIZE_THREAD__
  // What oneTBB's library synchronises inside is not seen: every branch would be reported.
  constexpr std::uint32_t kParallel = ~0u;
#else
  constexpr std::uint32_t kParallel = 4096;
#endif
  const auto do_left = [&] { branch.left = split(first, left, depth + 1); };
  const auto do_right = [&] { branch.right = split(first + left, count - left, depth + 1); };
  if (count > kParallel) {
    tbb::parallel_invoke(do_left, do_right);
  } else {
    do_left();
    do_right();
  }
  return self;
}

/// Gathers the binary tree into nodes of eight, the largest branches opened first.
class WideCollapser {
 public:
  WideCollapser(const BinaryBuilder& tree, const WideFrame& frame, std::vector<WideNode>& nodes,
                WideBvh::Statistics& statistics)
      : m_tree(tree), m_frame(frame), m_nodes(nodes), m_statistics(statistics) {}

  std::uint32_t emit(std::uint32_t root, int depth);

 private:
  void set_box(WideNode& node, int slot, const Bounds& box) const;

  const BinaryBuilder& m_tree;
  const WideFrame& m_frame;
  std::vector<WideNode>& m_nodes;
  WideBvh::Statistics& m_statistics;
};

void WideCollapser::set_box(WideNode& node, int slot, const Bounds& box) const {
  const Vec3 lo = m_frame.point(box.lo), hi = m_frame.point(box.hi);
  for (int a = 0; a < 3; ++a) {
    node.planes[a][0][slot] = WideLimits::down(lo[a] - m_frame.pad);
    node.planes[a][1][slot] = WideLimits::up(hi[a] + m_frame.pad);
  }
}

std::uint32_t WideCollapser::emit(std::uint32_t root, int depth) {
  std::uint32_t children[WideNode::kWidth];
  int used = 0;
  if (m_tree[root].count > 0) {
    children[used++] = root;
  } else {
    children[used++] = m_tree[root].left;
    children[used++] = m_tree[root].right;
  }
  while (used < WideNode::kWidth) {
    int largest = -1;
    double area = -1.0;
    for (int i = 0; i < used; ++i) {
      const Branch& b = m_tree[children[i]];
      if (b.count == 0 && b.box.surface() > area) {
        largest = i;
        area = b.box.surface();
      }
    }
    if (largest < 0) break;
    const Branch& open = m_tree[children[largest]];
    children[largest] = open.left;
    children[used++] = open.right;
  }
  const auto self = static_cast<std::uint32_t>(m_nodes.size());
  WideNode node;
  node.used = static_cast<std::uint32_t>(used);
  for (int i = 0; i < WideNode::kWidth; ++i) {
    node.child[i] = WideNode::kLeaf;
    for (int a = 0; a < 3; ++a) {
      node.planes[a][0][i] = 64.0f;
      node.planes[a][1][i] = -64.0f;
    }
    if (i < used) set_box(node, i, m_tree[children[i]].box);
  }
  m_nodes.push_back(node);
  m_statistics.depth = std::max(m_statistics.depth, depth);
  for (int i = 0; i < used; ++i) {
    const Branch& b = m_tree[children[i]];
    std::uint32_t child = 0;
    if (b.count > 0) {
      child = WideNode::kLeaf | b.count << WideNode::kFirstBits | b.first;
      ++m_statistics.leaves;
    } else {
      child = emit(children[i], depth + 1);
    }
    m_nodes[self].child[i] = child;
  }
  return self;
}

WideFrame frame_of(const Bounds& all) {
  WideFrame frame;
  frame.offset = all.lo * 0.5 + all.hi * 0.5;
  const Vec3 half = all.hi * 0.5 - all.lo * 0.5;
  const double size = std::max({half.x, half.y, half.z, 1e-290});
  int exponent = 0;
  std::frexp(size, &exponent);  // size < 2^exponent
  frame.scale = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  const double far = std::max({std::fabs(frame.offset.x), std::fabs(frame.offset.y),
                               std::fabs(frame.offset.z)});
  frame.pad = 0x1p-46 + far * frame.scale * 0x1p-48;
  return frame;
}

}  // namespace

void WideBvh::build(std::span<const Bounds> boxes, const Options& options) {
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
  m_frame = frame_of(m_bounds);
  BinaryBuilder builder(boxes, options, m_order);
  const std::uint32_t root = builder.run();
  WideCollapser(builder, m_frame, m_nodes, m_statistics).emit(root, 1);
  m_nodes.shrink_to_fit();
  m_statistics.nodes = m_nodes.size();
  m_statistics.parts = m_order.size();
}

void WideBvh::open_boxes() {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  for (WideNode& node : m_nodes) {
    for (auto& [low, high] : node.planes) {
      std::fill_n(low, node.used, -kInf);
      std::fill_n(high, node.used, kInf);
    }
  }
}

std::size_t WideBvh::memory() const {
  return m_nodes.capacity() * sizeof(WideNode) + m_order.capacity() * sizeof(std::uint32_t);
}

}  // namespace lentray::core
