// The directions in which light is gathered: a cycle of cosine-weighted ones about a surface's normal, of
// which each gather takes the next. World space, unit.
// Not thread-safe: a cycle has a place.
// Source: Halton, Numerische Mathematik 2, 1960 (bases 2 and 3); Malley's way from a disc to the
// hemisphere; the order and the frame are those that replay stock's samples (tests/unit/irradiance/irradiance_test.cpp).
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/vec3.h"

namespace lentray::core {

/// `count` directions about the y axis.
std::vector<Vec3> cosine_weighted_directions(std::size_t count);

/// Where a cycle stands. A cheap value: the directions are shared.
class DirectionCycle {
 public:
  explicit DirectionCycle(std::shared_ptr<const std::vector<Vec3>> directions)
      : m_directions(std::move(directions)) {}
  std::size_t length() const { return m_directions->size(); }
  void begin_at(std::size_t place) { m_next = place % length(); }
  std::size_t place() const { return m_next; }
  const Vec3& next() {
    const Vec3& direction = (*m_directions)[m_next];
    if (++m_next == length()) m_next = 0;
    return direction;
  }

 private:
  std::shared_ptr<const std::vector<Vec3>> m_directions;
  std::size_t m_next = 0;
};

/// The half of all directions about a normal.
class Hemisphere {
 public:
  explicit Hemisphere(const Vec3& normal);
  /// One about the y axis, turned. Where the normal is near that axis the direction stays as it is.
  Vec3 turned(const Vec3& direction) const;

 private:
  Vec3 m_x, m_normal, m_z;
};

/// The directions of one gather. About a perturbed normal, those that lie behind the surface itself are
/// passed over; where they are too many, the rest are about the surface's own normal.
class GatherDirections {
 public:
  /// `normal`: `surface_normal`, or that of a layer. `rays`: how many are wanted.
  GatherDirections(DirectionCycle& cycle, const Vec3& surface_normal, const Vec3& normal,
                   unsigned rays);
  /// False: there are no more.
  bool next(Vec3& direction);
  /// Whether they are about the surface's own normal by now.
  bool about_surface() const { return m_about_surface; }

 private:
  DirectionCycle& m_cycle;
  const Vec3 m_surface_normal;
  bool m_about_surface;
  Hemisphere m_hemisphere;
  std::size_t m_left = 0;  ///< directions that may still be tried
};

}  // namespace lentray::core
