// blob: where the fields of spheres and cylinders with round ends add up to a threshold. A field is
// strength (1 - (distance / radius)^2)^2, nothing beyond the radius. Space: object.
// Source: reference manual 3.7, "Blob"; compared with stock by image.shapes.
#pragma once

#include <algorithm>
#include <vector>

#include "core/bvh/wide_bvh.h"
#include "core/shape/shape.h"

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

class Blob final : public Shape {
 public:
  Blob(double threshold, std::vector<BlobField> fields);

  ShapeTraits traits() const override { return {.name = "blob"}; }
  Bounds bounds() const override { return m_bounds; }
  /// Searched for in a few hundred cells.
  Bounds bounds_in(const Transform& t) const override;
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool inside(const Vec3& p) const override;
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  void drop_shortcuts() override;

 private:
  /// Where along a ray a field holds: its distance there is a quadratic of t.
  struct Reach {
    double from, to;
    double q2, q1, q0;  ///< (distance / radius)^2 = q2 t2 + q1 t + q0
    double strength;
    std::uint32_t field;

    double share(double t) const { return q0 + t * (q1 + t * q2); }
    /// The least of it between two points.
    double least(double a, double b) const {
      const double turn = q2 > 0.0 ? std::clamp(-0.5 * q1 / q2, a, b) : q1 > 0.0 ? a : b;
      return share(turn);
    }
  };
  class Reaches;
  /// What a ray asks of a field: where it is a ball in the blob's space too, a point and a radius.
  struct Round {
    Vec3 centre;
    double scale = 0.0;  ///< 1 / radius^2; 0: it is none
  };
  /// Calls visit(i) for the fields that the ray may reach beyond t_min, in any order.
  template <class Visit>
  void for_fields(const Ray& ray, double t_min, Visit&& visit) const;
  /// Calls visit(field) for those that the point may be in, in order.
  template <class Visit>
  void for_fields(const Vec3& p, Visit&& visit) const;
  bool may_hold(const Vec3& centre, const Vec3& half) const;
  void find_reaches(std::uint32_t field, const Ray& ray, double t_min, Reaches& out) const;
  bool may_hold(const Reach* const* active, std::size_t count, double from, double to) const;
  /// Calls visit(t) in order along the ray; stops when it returns false.
  template <class Visit>
  void crossings(const Ray& from_afar, double t_min, double t_max, Visit&& visit) const;

  double m_threshold;
  std::vector<BlobField> m_fields;
  std::vector<Round> m_rounds;  ///< one a field
  std::vector<double>
      m_scales;  ///< how much longer at most than in the blob's a length is in a field's space
  std::vector<Bounds> m_boxes;  ///< of each field, a little wider
  WideBvh m_search;             ///< over them, where there are many
  Bounds m_reach;               ///< of all fields
  Bounds m_bounds;
};

}  // namespace lentray::core
