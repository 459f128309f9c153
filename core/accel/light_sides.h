// A convex polygon of few corners in a plane, whose sides can be dropped one by one: those beside one that
// went are then longer, and meet beyond it. For volumes of light buffers, which have room for four.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "core/base/vec3.h"

namespace lentray::core {

class LightSides {
 public:
  static constexpr std::size_t kMost = 8;

  /// At least three corners, at most kMost, in turn.
  explicit LightSides(std::span<const Vec2> corners) : m_count(corners.size()) {
    for (std::size_t i = 0; i < m_count; ++i) m_sides[i] = {corners[i], i, next(i)};
    for (std::size_t i = 0; i < m_count; ++i) m_area += 0.5 * across(corners[i], corners[next(i)]);
    m_turn = m_area < 0.0 ? -1.0 : 1.0;
    m_area *= m_turn;
  }
  std::size_t count() const { return m_count; }
  double area() const { return m_area; }
  /// Numbers of the corners that a side was given between.
  std::size_t begin(std::size_t side) const { return m_sides[side].begin; }
  std::size_t end(std::size_t side) const { return m_sides[side].end; }

  /// Drops the side that adds the least area; false if none can be dropped.
  bool drop() {
    std::size_t best = m_count;
    double least = std::numeric_limits<double>::infinity();
    Vec2 meeting;
    for (std::size_t i = 0; i < m_count; ++i) {
      const Vec2 &a = m_sides[i].corner, &b = m_sides[next(i)].corner;
      const Vec2 own = from(a, b), before = from(m_sides[i > 0 ? i - 1 : m_count - 1].corner, a);
      const Vec2 after = from(b, m_sides[next(next(i))].corner);
      const double turn = m_turn * across(before, after);
      if (!(turn > 0.0)) continue;
      const double times = m_turn * across(own, after) / turn;
      const Vec2 to_meeting{before.u * times, before.v * times};
      const double added = 0.5 * std::fabs(across(own, to_meeting));
      if (!(added < least)) continue;
      least = added;
      best = i;
      meeting = {a.u + to_meeting.u, a.v + to_meeting.v};
    }
    if (best == m_count) return false;
    m_sides[next(best)].corner = meeting;
    for (std::size_t i = best; i + 1 < m_count; ++i) m_sides[i] = m_sides[i + 1];
    --m_count;
    m_area += least;
    return true;
  }

 private:
  struct Side {
    Vec2 corner;  ///< where it begins now
    std::size_t begin, end;
  };
  static Vec2 from(const Vec2& a, const Vec2& b) { return {b.u - a.u, b.v - a.v}; }
  static double across(const Vec2& a, const Vec2& b) { return a.u * b.v - a.v * b.u; }
  std::size_t next(std::size_t i) const { return i + 1 < m_count ? i + 1 : 0; }

  std::size_t m_count;
  double m_area = 0.0, m_turn = 1.0;
  Side m_sides[kMost];
};

}  // namespace lentray::core
