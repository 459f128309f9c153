// An outline swept through space: prism { ... } along y (straight or towards a point), and the
// glyphs of text { ... } along z. Space: object.
// Source: reference manual 3.7, "Prism", "Text"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <memory>

#include "core/shape/outline.h"
#include "core/shape/shape.h"

namespace lentray::core {

class Prism final : public Shape {
 public:
  enum class Sweep {
    kAlongY,  ///< u, v are x, z
    kConic,   ///< the same, scaled by y: full size at y = 1, a point at y = 0
    kAlongZ   ///< u, v are x, y
  };
  /// `name` lives as long as the program. `open` leaves the caps out.
  Prism(std::string_view name, std::shared_ptr<const Outline> outline, Sweep sweep, double from,
        double to, bool open);

  /// Its normals may point inwards, so that a convex solid is not of Convexity::kConvex.
  ShapeTraits traits() const override { return {.name = m_name}; }
  bool is_convex_solid() const { return m_convex; }
  Bounds box(const Transform* move) const override { return move ? box_in(*move) : own_box(); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool any(const Ray& ray, double t_min, double t_max) const override;
  bool holds(const Vec3& p, bool inverse) const override { return within(p) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;

 private:
  friend struct PlainShapes;  // tests/unit/shape/plain_shapes.h
  bool within(const Vec3& p) const;
  Bounds own_box() const;
  Bounds box_in(const Transform& t) const;
  /// Components along u, v and the sweep.
  Vec3 swept(const Vec3& p) const { return m_sweep == Sweep::kAlongZ ? p : Vec3{p.x, p.z, p.y}; }
  /// Of a place at that height, on the outline.
  bool on_outline(double& u, double& v, double height) const;
  bool contains(double u, double v, double height) const;
  /// The part of a ray between the caps and t_min and t_max.
  struct Passage {
    double caps[2];  ///< where the ray's line meets their planes; along them no numbers
    PlaneWay way;    ///< of the part, over the outline: where walls may be met
  };
  bool passes(const Ray& ray, const Vec3& origin, const Vec3& direction, double t_min, double t_max,
              Passage& passage) const;
  bool is_on_cap(std::uint32_t cap, const Vec3& origin, const Vec3& direction,
                 const Passage& passage) const;
  /// What visit() answers: crossings(), or where `first` first_crossings().
  template <bool first, class Visit>
  void walls(const Vec3& origin, const Vec3& direction, const Passage& passage,
             Visit&& visit) const;

  std::string_view m_name;
  std::shared_ptr<const Outline> m_outline;
  Sweep m_sweep;
  double m_from, m_to;
  double m_farther;  ///< not less than both, of either sign
  bool m_open, m_convex;
  Bounds m_reach;  ///< a little more than bounds()
};

}  // namespace lentray::core
