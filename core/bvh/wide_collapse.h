// Gathers the branches of a binary tree into nodes of eight: those of least surface in all, so that rays come to as few
// as may be. Internal to core/bvh; one thread.
// Source: Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", 2017.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/bvh/binary_tree.h"
#include "core/bvh/wide_bvh.h"

namespace lentray::core {

class WideCollapse {
 public:
  /// Branches come before those below them.
  explicit WideCollapse(std::span<const Branch> tree);
  void make(std::uint32_t root, std::vector<WideNode>& nodes, WideBvh::Statistics& statistics);

 private:
  static constexpr int kMost = WideNode::kWidth;
  /// What a branch costs if it takes up to 1 .. 7 slots of the node above. In more slots than one it may do without a
  /// node of its own. As it is at first: a leaf's.
  class Plan {
   public:
    float cost[kMost - 1] = {};  ///< up to the width

    /// Slots of which it has a use, up to 8: more are as good as these.
    int width() const { return 1 + static_cast<int>(m_bits >> 28 & 7); }
    /// Of 1 .. 7 slots: whether it does without.
    bool opens(int slots) const { return (m_bits >> (20 + std::min(slots, width())) & 1) != 0; }
    /// Of 2 .. 8 slots: how many of them its left side gets.
    int left(int slots) const {
      return static_cast<int>(m_bits >> 3 * (std::min(slots, width()) - 2) & 7);
    }
    void set_width(int width) { m_bits |= static_cast<std::uint32_t>(width - 1) << 28; }
    void set_opens(int slots) { m_bits |= 1u << (20 + slots); }
    void set_left(int slots, int lefts) {
      m_bits |= static_cast<std::uint32_t>(lefts) << 3 * (slots - 2);
    }

   private:
    std::uint32_t m_bits = 0;
  };
  struct Slots {
    std::uint32_t branch[kMost];
    int used = 0;
  };
  Plan planned(const Branch& branch) const;
  void fill(std::uint32_t branch, int slots, Slots& out) const;
  Slots slots_of(std::uint32_t root) const;
  void count(std::uint32_t root, int depth, WideBvh::Statistics& statistics) const;
  std::uint32_t emit(std::uint32_t root, std::vector<WideNode>& nodes) const;

  std::span<const Branch> m_tree;
  std::vector<Plan> m_plans;  ///< one a branch
};

}  // namespace lentray::core
