// A shape placed in the world. Space: world; the shape keeps one of its own where it cannot be moved.
// Immutable while rendering; scratch memory comes from the caller's HitLists.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/base/transform.h"
#include "core/object/object.h"
#include "core/shape/shape.h"

namespace lentray::core {

class Plane;

/// A shape in the world.
class Leaf final : public Object {
 public:
  /// The shape is baked into world space where it can be; otherwise the transform is kept.
  Leaf(std::unique_ptr<Shape> shape, const Transform& to_world);
  std::string_view name() const override { return m_shape->name(); }
  Bounds bounds() const override;
  Bounds solid_bounds() const override;
  Bounds void_bounds() const override;
  Ball solid_ball() const override;
  bool nearest(const Ray&, double t_min, double t_max, Hit&, const RayQuery&) const override;
  void all(const Ray&, double t_min, double t_max, std::vector<Hit>&,
           const RayQuery&) const override;
  bool any(const Ray&, double t_min, double t_max, const RayQuery&) const override;
  bool inside(const Vec3& p) const override;
  void leaves(std::vector<const Leaf*>& out) const override { out.push_back(this); }

  const Shape& shape() const { return *m_shape; }
  /// Null: the shape is in world space.
  const Transform* transform() const { return m_moved ? &m_moved->transform : nullptr; }
  /// Unit shading normal at a hit of this leaf, world space.
  Vec3 normal(const Vec3& world_point, const ShapeHit& hit) const;
  Vec2 uv(const Vec3& world_point, const ShapeHit& hit) const;
  void set_inverse(bool inverse) override;
  /// Once the clips are set: a polynomial need not look for crossings beyond them. Nothing of other shapes.
  void search_within_clips();

 private:
  bool shape_nearest(const Ray&, double t_min, double t_max, ShapeHit&) const;
  bool unclipped_nearest(const Ray&, double t_min, double t_max, ShapeHit&, const RayQuery&) const;
  /// The direction keeps its length, so that t is the same in both spaces.
  Ray to_shape(const Ray& ray) const {
    const Transform& t = m_moved->transform;
    return {t.inverse_point(ray.origin), t.inverse_vector(ray.direction)};
  }
  /// Of the shape, in the world.
  Bounds box() const { return m_moved ? m_moved->box : m_shape->bounds(); }

  /// Apart: most are baked, and it is large.
  struct Moved {
    Transform transform;
    Bounds box;  ///< of the shape, in the world
  };
  std::unique_ptr<Shape> m_shape;
  std::unique_ptr<const Moved> m_moved;  ///< null: the shape is in world space
};

/// The object's shape if it has no transform, clip or gate; else null.
const Shape* plain_shape(const Object& object);
/// The same of planes alone.
const Plane* plain_plane(const Object& object);

}  // namespace lentray::core
