// Boxes in a plane, and which of them a straight way over it may touch: eight at a time. In floats: none
// that is touched is left out, some that are not are named.
// Plane coordinates (u, v). Immutable once filled; any number of threads.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/processor.h"
#include "core/base/vec3.h"

namespace lentray::core {

struct PlaneBox {
  Vec2 lo, hi;
};

/// A straight way over the plane, of finite numbers; unknown: any way.
struct PlaneWay {
  Vec2 begin{}, end{};
  double slack = 0.0;  ///< how far it may be off in u or v
  bool is_known = false;
};

class PlaneBoxes {
 public:
  /// `around` holds them all. `are_known`: false makes every way touch each.
  void fill(const std::vector<PlaneBox>& boxes, const PlaneBox& around, bool are_known);
  /// Calls take(number of the box), until that answers false. `portable`: without AVX2 where there is any.
  template <class Take>
  void along(const PlaneWay& way, Take&& take, bool portable = false) const;

 private:
  static constexpr std::size_t kLanes = 8, kSet = 64;
  /// Middles and half widths, in shares of the box around.
  struct alignas(32) Eight {
    float u[kLanes], v[kLanes], du[kLanes], dv[kLanes];
  };
  /// A way in the same numbers, wider by what it may be off.
  struct Line {
    Line(const PlaneWay& way, const Vec2& lo, const Vec2& share);
    float middle[2], half[2];  ///< the box of the way
    float across[2];
    float reach;  ///< how far along `across` it may be off
  };
  static std::vector<Eight> eights(const std::vector<PlaneBox>& boxes, const Vec2& lo,
                                   const Vec2& share);
  /// A bit for each of up to kSet boxes that the line may touch.
  static std::uint64_t touched(const Line& line, const Eight* first, std::size_t count,
                               bool portable) {
    return !portable && has_avx2() ? touched_avx2(line, first, count)
                                   : touched_portable(line, first, count);
  }
  static std::uint64_t touched_portable(const Line& line, const Eight* first, std::size_t count);
  LENTRAY_AVX2 static std::uint64_t touched_avx2(const Line& line, const Eight* first,
                                                 std::size_t count);

  Vec2 m_lo, m_share;  ///< of the box around; a share of 0 knows nothing
  std::vector<Eight> m_boxes;
  std::vector<Eight> m_sets;  ///< the boxes of kSet each, where there are more
};

template <class Take>
void PlaneBoxes::along(const PlaneWay& way, Take&& take, bool portable) const {
  constexpr std::size_t kEights = kSet / kLanes;  // of a set
  const Line line(way, m_lo, m_share);
  const auto look = [&](std::size_t set) {
    const std::size_t first = set * kEights, count = std::min(m_boxes.size() - first, kEights);
    std::uint64_t boxes = touched(line, m_boxes.data() + first, count, portable);
    for (; boxes != 0; boxes &= boxes - 1) {
      if (!take(set * kSet + static_cast<std::size_t>(std::countr_zero(boxes)))) return false;
    }
    return true;
  };
  if (m_sets.empty()) {
    look(0);
    return;
  }
  for (std::size_t i = 0; i < m_sets.size(); ++i) {
    for (std::uint64_t sets = touched(line, &m_sets[i], 1, portable); sets != 0; sets &= sets - 1) {
      if (!look(i * kLanes + static_cast<std::size_t>(std::countr_zero(sets)))) return;
    }
  }
}

}  // namespace lentray::core
