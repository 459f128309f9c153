#include "core/object/leaf.h"

#include <typeinfo>

#include "core/shape/plane.h"
#include "core/shape/poly.h"

namespace lentray::core {

Leaf::Leaf(std::unique_ptr<Shape> shape, const Transform& to_world) : m_shape(std::move(shape)) {
  if (!to_world.is_identity()) {
    if (auto moved = m_shape->baked(to_world)) {
      m_shape = std::move(moved);
    } else {
      m_moved.reset(new Moved{to_world, m_shape->bounds_in(to_world)});
    }
  }
  set_convexity(m_shape->traits().convexity);
  set_ball(m_moved ? smaller(transformed(m_shape->ball(), m_moved->transform),
                             ball_around(m_shape->bounds(), m_moved->transform))
                   : m_shape->ball());
}

void Leaf::search_within_clips() {
  auto* poly = dynamic_cast<Poly*>(m_shape.get());
  if (!poly) return;
  const Ball kept = within_clips(Ball());
  poly->keep_within(m_moved ? transformed(kept, m_moved->transform.inverse()) : kept);
}

Bounds Leaf::bounds() const { return within_clips(box()); }

Bounds Leaf::solid_bounds() const {
  const ShapeTraits traits = m_shape->traits();
  Bounds b;
  if (is_inverse() || traits.solid_is_unbounded) {
    b = Bounds::everything();
  } else if (traits.is_solid) {
    b = box();
  }
  return within_clips(b.is_empty() ? Bounds() : b);
}

Bounds Leaf::void_bounds() const {
  if (!is_inverse() || !clips().empty()) return Bounds::everything();
  return m_shape->traits().solid_is_unbounded ? Bounds::everything() : box();
}

Ball Leaf::solid_ball() const {
  const ShapeTraits traits = m_shape->traits();
  const bool is_bounded = !is_inverse() && traits.is_solid && !traits.solid_is_unbounded;
  return within_clips(is_bounded ? unclipped_ball() : Ball());
}

void Leaf::set_inverse(bool inverse) {
  if (m_shape->traits().is_solid) Object::set_inverse(inverse);
}

bool Leaf::shape_nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  if (!m_moved) return m_shape->nearest(ray, t_min, t_max, hit);
  return m_shape->nearest(to_shape(ray), t_min, t_max, hit);
}

bool Leaf::nearest(const Ray& ray, double t_min, double t_max, Hit& hit,
                   const RayQuery& query) const {
  if (ball().is_missed_by(ray)) return false;
  ShapeHit found;
  const bool is_there = !clips().empty() ? unclipped_nearest(ray, t_min, t_max, found, query)
                        : m_moved        ? m_shape->nearest(to_shape(ray), t_min, t_max, found)
                                         : m_shape->nearest(ray, t_min, t_max, found);
  if (!is_there) return false;
  hit.t = found.t;
  hit.leaf = this;
  hit.shape = found;
  return true;
}

/// Where the first crossing is clipped away all others are found at once, not one after the other.
bool Leaf::unclipped_nearest(const Ray& ray, double t_min, double t_max, ShapeHit& found,
                             const RayQuery& query) const {
  if (!m_shape->traits().finds_all_at_once) {
    if (!shape_nearest(ray, t_min, t_max, found)) return false;
    if (passes_clips(ray.at(found.t))) return true;
    t_min = found.t;
  }
  ShapeHits& all = query.lists.shape_hits;
  all.clear();
  m_shape->all(m_moved ? to_shape(ray) : ray, t_min, t_max, all);
  bool is_there = false;
  for (const ShapeHit& one : all) {
    if (!(one.t < t_max) || !passes_clips(ray.at(one.t))) continue;
    found = one;
    t_max = one.t;
    is_there = true;
  }
  return is_there;
}

bool Leaf::any(const Ray& ray, double t_min, double t_max, const RayQuery& query) const {
  if (ball().is_missed_by(ray)) return false;
  if (!clips().empty()) {
    Hit hit;
    return Leaf::nearest(ray, t_min, t_max, hit, query);
  }
  if (!m_moved) return m_shape->any(ray, t_min, t_max);
  return m_shape->any(to_shape(ray), t_min, t_max);
}

void Leaf::all(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits,
               const RayQuery& query) const {
  if (ball().is_missed_by(ray)) return;
  ShapeHits& list = query.lists.shape_hits;
  list.clear();
  m_shape->all(m_moved ? to_shape(ray) : ray, t_min, t_max, list);
  for (const ShapeHit& found : list) {
    if (!clips().empty() && !passes_clips(ray.at(found.t))) continue;
    hits.push_back({found.t, this, nullptr, found});
  }
}

bool Leaf::inside(const Vec3& p) const {
  if (!clips().empty() && !passes_clips(p)) return false;
  const Vec3 q = m_moved ? m_moved->transform.inverse_point(p) : p;
  return m_shape->holds(q, is_inverse());
}

Vec3 Leaf::normal(const Vec3& world_point, const ShapeHit& hit) const {
  if (m_moved) {
    const Vec3 n = m_moved->transform.normal(
        m_shape->normal(m_moved->transform.inverse_point(world_point), hit));
    return normalized(is_inverse() ? -n : n);
  }
  const Vec3 n = m_shape->normal(world_point, hit);
  return normalized(is_inverse() ? -n : n);
}

Vec2 Leaf::uv(const Vec3& world_point, const ShapeHit& hit) const {
  if (!m_shape->traits().has_uv || !m_moved) return m_shape->uv(world_point, hit);
  return m_shape->uv(m_moved->transform.inverse_point(world_point), hit);
}

const Shape* plain_shape(const Object& object) {
  if (typeid(object) != typeid(Leaf)) return nullptr;
  const auto& leaf = static_cast<const Leaf&>(object);
  return leaf.transform() || !leaf.clips().empty() ? nullptr : &leaf.shape();
}

const Plane* plain_plane(const Object& object) {
  return dynamic_cast<const Plane*>(plain_shape(object));
}

}  // namespace lentray::core
