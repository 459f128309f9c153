// Up to 64 rays that run side by side, as a tile of a picture or a column of a lens sheet has them: they are
// searched together (core/bundle/bundle_walk.h). World space, directions of one length or nearly so.
// Rays are kept one by one and as arrays of their numbers; groups of eight neighbours are told apart.
// A plain value. One thread.
#pragma once

#include "core/base/ray.h"

namespace lentray::core {

class RayBundle {
 public:
  static constexpr int kMost = 64, kGroup = 8, kGroups = kMost / kGroup;

  void clear() { m_count = 0; }
  /// At most kMost rays, with finite numbers.
  void add(const Ray& ray) { put(m_count++, ray); }
  int count() const { return m_count; }
  int groups() const { return (m_count + kGroup - 1) / kGroup; }
  /// Once all rays are there, at least one: fills the last group up with copies of the last ray.
  void fill_up() {
    const int end = groups() * kGroup;
    for (int i = m_count; i < end; ++i) put(i, m_rays[m_count - 1]);
    const double *x = m_direction[0], *y = m_direction[1], *z = m_direction[2];
    for (int i = 0; i < end; ++i) m_inverse_dd[i] = 1.0 / (x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
  }

  const Ray& ray(int i) const { return m_rays[i]; }
  /// Of ray 0 on; they lie at multiples of 32 bytes.
  const double* origin(int axis) const { return m_origin[axis]; }
  const double* direction(int axis) const { return m_direction[axis]; }
  const double* inverse_dd() const { return m_inverse_dd; }  ///< 1 / dot(direction, direction)

 private:
  void put(int i, const Ray& ray) {
    m_rays[i] = ray;
    for (int a = 0; a < 3; ++a) {
      m_origin[a][i] = ray.origin[a];
      m_direction[a][i] = ray.direction[a];
    }
  }

  alignas(32) double m_origin[3][kMost] = {}, m_direction[3][kMost] = {}, m_inverse_dd[kMost] = {};
  Ray m_rays[kMost];
  int m_count = 0;
};

}  // namespace lentray::core
