// The elements of a blob, and which of them are near a point or a ray. Space: the one that the fields'
// `to_blob` leads to. Immutable once built; any number of threads.
// Source: reference manual 3.7, "Blob".
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <vector>

#include "core/base/bounds.h"
#include "core/base/transform.h"
#include "core/bvh/wide_bvh.h"
#include "core/numeric/box_ray.h"

namespace lentray::core {

/// One element in its own space: a sphere of that radius about the origin, or a cylinder along z
/// from 0 to `length`.
struct BlobField {
  double radius = 1.0, strength = 1.0;
  double length = 0.0;  ///< 0: a sphere
  Transform to_blob;
  /// Field at a point of the element's own space; 0 beyond its reach.
  double at(const Vec3& local) const;
};

class BlobFields {
 public:
  explicit BlobFields(std::vector<BlobField> fields);

  std::size_t size() const { return m_fields.size(); }
  const BlobField& operator[](std::size_t i) const { return m_fields[i]; }
  auto begin() const { return m_fields.begin(); }
  auto end() const { return m_fields.end(); }
  const Bounds& box(std::size_t i) const { return m_boxes[i]; }  ///< of a field, a little wider
  const Bounds& reach() const { return m_reach; }                ///< of all fields

  /// Calls visit(i) for the fields that the ray may reach beyond t_min, in any order.
  template <class Visit>
  void on_ray(const Ray& ray, double t_min, Visit&& visit) const;
  /// Calls visit(i) for those that the point may be in, in order.
  template <class Visit>
  void at_point(const Vec3& p, Visit&& visit) const;

 private:
  friend struct PlainShapes;  // tests/unit/shape/plain_shapes.h
  std::vector<BlobField> m_fields;
  std::vector<Bounds> m_boxes;  ///< of each field, a little wider
  WideBvh m_search;             ///< over them, where there are many
  Bounds m_reach;
};

template <class Visit>
void BlobFields::on_ray(const Ray& ray, double t_min, Visit&& visit) const {
  if (m_search.order().empty()) {
    const BoxRay box_ray(ray);
    for (std::uint32_t i = 0; i < m_fields.size(); ++i) {
      if (box_ray.meets(m_boxes[i], t_min, Bounds::kInf)) visit(i);
    }
    return;
  }
  const auto add = [&](std::uint32_t place, double&) {
    visit(m_search.order()[WideBvh::first_of(place)]);
    return false;
  };
  CountNothing nothing;
  if (has_avx2()) {
    m_search.traverse_avx2<false>(ray, t_min, Bounds::kInf, add, nothing);
  } else {
    m_search.traverse_portable(ray, t_min, Bounds::kInf, add, nothing);
  }
}

template <class Visit>
void BlobFields::at_point(const Vec3& p, Visit&& visit) const {
  if (m_search.order().empty()) {
    for (std::uint32_t i = 0; i < m_fields.size(); ++i) {
      if (m_boxes[i].contains(p)) visit(i);
    }
    return;
  }
  boost::container::small_vector<std::uint32_t, 48> found;
  m_search.at_point(p, [&](std::uint32_t first, std::uint32_t) {
    const std::uint32_t i = m_search.order()[first];
    if (m_boxes[i].contains(p)) found.push_back(i);
    return false;
  });
  std::sort(found.begin(), found.end());
  for (const std::uint32_t i : found) visit(i);
}

}  // namespace lentray::core
