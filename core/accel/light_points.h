// Points of surfaces whose lights are asked for together, and what a light's buffer says of them. World space.
// Plain values; one a thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/accel/light_buffer.h"
#include "core/base/vec3.h"

namespace lentray::core {

/// Up to 64 points. Once all are there, fill_up() completes the last four.
class LightPoints {
 public:
  static constexpr int kMost = 64, kLanes = 4;

  void clear() { m_count = 0; }
  /// `normal`: of the surface, towards the ray that looks. `front`: lights that are behind a plane across it are not
  /// asked for; null vector: none is behind. `unmet`: a convex object that the rays to lights do not hit which rise
  /// from the surface by more than `slope`, the least cosine to the normal; or null.
  void add(const Vec3& point, const Vec3& normal, const Vec3& front, const Object* unmet,
           double slope) {
    put(m_count, point, normal, unmet, slope);
    for (int a = 0; a < 3; ++a) m_front[a][m_count] = front[a];
    m_asks[static_cast<std::size_t>(m_count++)] = 1;
  }
  /// A place that asks for nothing.
  void add_none() { put_none(m_count++); }
  void fill_up() {
    for (int i = m_count; i % kLanes != 0; ++i) put_none(i);
  }
  int count() const { return m_count; }

  const double* point(int axis) const { return m_point[axis]; }
  const double* normal(int axis) const { return m_normal[axis]; }
  const double* front(int axis) const { return m_front[axis]; }
  Vec3 point_at(std::size_t i) const { return {m_point[0][i], m_point[1][i], m_point[2][i]}; }
  const double* slope2() const { return m_slope2; }
  const Object* unmet(int i) const { return m_unmet[static_cast<std::size_t>(i)]; }
  /// Of the points from i on, the first lowest.
  unsigned who_asks(int i) const {
    const std::uint8_t* asks = m_asks.data() + i;
    return asks[0] + 2u * asks[1] + 4u * asks[2] + 8u * asks[3];
  }

 private:
  void put(int i, const Vec3& point, const Vec3& normal, const Object* unmet, double slope) {
    for (int a = 0; a < 3; ++a) {
      m_point[a][i] = point[a];
      m_normal[a][i] = normal[a];
    }
    m_slope2[i] = slope * slope;
    m_unmet[static_cast<std::size_t>(i)] = unmet;
  }

  void put_none(int i) {
    put(i, {}, {}, nullptr, 0.0);
    m_asks[static_cast<std::size_t>(i)] = 0;
  }

  alignas(32) double m_point[3][kMost] = {}, m_normal[3][kMost] = {}, m_front[3][kMost] = {};
  alignas(32) double m_slope2[kMost] = {};
  std::array<const Object*, kMost> m_unmet{};
  std::array<std::uint8_t, kMost> m_asks{};
  int m_count = 0;
};

/// Of one light at those points.
struct LightAnswers {
  enum Answer : int {
    kUnknown,   ///< to be asked for alone
    kBehind,    ///< the light's position is behind the surface; the ray is not known
    kClear,     ///< nothing is in the way
    kFiltered,  ///< nothing opaque is in the way; what filters the light is to be asked for
    kForeseen,  ///< dark, as LightBuffer::Answer::foreseen
    kBlocked,   ///< dark
  };
  static constexpr bool has_ray(Answer answer) { return answer >= kClear; }
  static constexpr bool is_dark(Answer answer) { return answer >= kForeseen; }

  Answer at(std::size_t i) const { return static_cast<Answer>(answer[i]); }
  Vec3 direction_at(std::size_t i) const {
    return {direction[0][i], direction[1][i], direction[2][i]};
  }
  alignas(32) double direction[3][LightPoints::kMost], distance[LightPoints::kMost];
  alignas(16) int answer[LightPoints::kMost];              ///< an Answer each
  std::uint64_t unknown, filtered;                         ///< the bits of places with that answer
  std::array<LightBuffer::Spot, LightPoints::kMost> spot;  ///< where the answer is kFiltered
};

}  // namespace lentray::core
