// blob: where the fields of spheres and cylinders with round ends add up to a threshold. A field is
// strength (1 - (distance / radius)^2)^2, nothing beyond the radius. Space: object.
// Source: reference manual 3.7, "Blob"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <algorithm>
#include <vector>

#include "core/shape/blob_fields.h"
#include "core/shape/shape.h"

namespace lentray::core {

class Blob final : public Shape {
 public:
  Blob(double threshold, std::vector<BlobField> fields);

  ShapeTraits traits() const override { return {.name = "blob"}; }
  Bounds box(const Transform* move) const override { return move ? box_in(*move) : m_bounds; }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool holds(const Vec3& p, bool inverse) const override { return within(p) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;

  /// Calls visit(t) in order along the ray; stops when it returns false.
  template <class Visit>
  void crossings(const Ray& from_afar, double t_min, double t_max, Visit&& visit) const;

 private:
  friend struct PlainShapes;  // tests/unit/shape/plain_shapes.h
  bool within(const Vec3& p) const;
  Bounds box_in(const Transform& t) const;
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
  class Support;
  /// What a ray asks of a field: where it is a ball in the blob's space too, a point and a radius.
  struct Round {
    Vec3 centre;
    double scale = 0.0;  ///< 1 / radius^2; 0: it is none
  };
  void find_reaches(std::uint32_t field, const Ray& ray, double t_min, Reaches& out) const;
  bool may_hold(const Reach* const* active, std::size_t count, double from, double to) const;

  double m_threshold;
  BlobFields m_fields;
  std::vector<Round> m_rounds;  ///< one a field
  Bounds m_bounds;
};

}  // namespace lentray::core
