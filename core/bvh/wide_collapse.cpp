#include "core/bvh/wide_collapse.h"

#include <algorithm>

namespace lentray::core {
namespace {

void set_box(WideNode& node, int slot, const FloatBox& box) {
  alignas(16) float low[4], high[4];
  simd::store(low, box.low);
  simd::store(high, box.high);
  for (int a = 0; a < 3; ++a) {
    node.planes[a][0][slot] = -low[a];
    node.planes[a][1][slot] = high[a];
  }
}

void set_empty(WideNode& node, int slot) {
  for (int a = 0; a < 3; ++a) {
    node.planes[a][0][slot] = 64.0f;
    node.planes[a][1][slot] = -64.0f;
  }
}

}  // namespace

WideCollapse::WideCollapse(std::span<const Branch> tree) : m_tree(tree), m_plans(tree.size()) {
  for (std::size_t i = tree.size(); i-- > 0;) {
    if (!tree[i].is_leaf()) m_plans[i] = planned(tree[i]);
  }
}

/// Leaves cost nothing: they are the same whatever is above them.
WideCollapse::Plan WideCollapse::planned(const Branch& branch) const {
  const Plan &left = m_plans[branch.left()], &right = m_plans[branch.right()];
  const int left_width = std::min(left.width(), kMost - 1),
            right_width = std::min(right.width(), kMost - 1),
            width = std::min(left_width + right_width, kMost);
  Plan plan;
  plan.set_width(width);
  float open[kMost + 1];  // by slots, without a node of its own
  for (int slots = 2; slots <= width; ++slots) {
    const int most = std::min(slots - 1, left_width);
    int best = std::max(1, slots - right_width);
    float least = left.cost[best - 1] + right.cost[slots - best - 1];
    for (int lefts = best + 1; lefts <= most; ++lefts) {
      const float cost = left.cost[lefts - 1] + right.cost[slots - lefts - 1];
      if (!(cost < least)) continue;
      least = cost;
      best = lefts;
    }
    open[slots] = least;
    plan.set_left(slots, best);
  }
  const float own = branch.box().surface() + open[width];
  plan.cost[0] = own;
  for (int slots = 2; slots <= std::min(width, kMost - 1); ++slots) {
    plan.cost[slots - 1] = std::min(own, open[slots]);
    if (!(own < open[slots])) plan.set_opens(slots);
  }
  return plan;
}

void WideCollapse::fill(std::uint32_t branch, int slots, Slots& out) const {
  const Branch& b = m_tree[branch];
  if (b.is_leaf() || !m_plans[branch].opens(slots)) {
    out.branch[out.used++] = branch;
    return;
  }
  const int lefts = m_plans[branch].left(slots);
  fill(b.left(), lefts, out);
  fill(b.right(), slots - lefts, out);
}

WideCollapse::Slots WideCollapse::slots_of(std::uint32_t root) const {
  Slots out;
  const Branch& b = m_tree[root];
  if (b.is_leaf()) {
    out.branch[out.used++] = root;
    return out;
  }
  const int lefts = m_plans[root].left(kMost);
  fill(b.left(), lefts, out);
  fill(b.right(), kMost - lefts, out);
  return out;
}

void WideCollapse::count(std::uint32_t root, int depth, WideBvh::Statistics& statistics) const {
  ++statistics.nodes;
  statistics.depth = std::max(statistics.depth, depth);
  const Slots slots = slots_of(root);
  for (int i = 0; i < slots.used; ++i) {
    if (m_tree[slots.branch[i]].is_leaf()) {
      ++statistics.leaves;
    } else {
      count(slots.branch[i], depth + 1, statistics);
    }
  }
}

std::uint32_t WideCollapse::emit(std::uint32_t root, std::vector<WideNode>& nodes) const {
  const auto self = static_cast<std::uint32_t>(nodes.size());
  const Slots slots = slots_of(root);
  WideNode& node = nodes.emplace_back();  // stays where it is: there is room for all
  node.used = static_cast<std::uint32_t>(slots.used);
  for (int i = 0; i < kMost; ++i) {
    node.child[i] = WideNode::kLeaf;
    if (i >= slots.used) {
      set_empty(node, i);
      continue;
    }
    const Branch& b = m_tree[slots.branch[i]];
    set_box(node, i, b.box());
    node.child[i] = b.is_leaf() ? WideNode::kLeaf | b.count() << WideNode::kFirstBits | b.first()
                                : emit(slots.branch[i], nodes);
  }
  return self;
}

void WideCollapse::make(std::uint32_t root, std::vector<WideNode>& nodes,
                        WideBvh::Statistics& statistics) {
  count(root, 1, statistics);
  nodes.reserve(statistics.nodes);
  emit(root, nodes);
}

}  // namespace lentray::core
