#include "core/object/leaf.h"

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

void Leaf::clips_have_changed() {
  Ball kept;
  for (const auto& clip : clips()) kept = smaller(kept, clip->solid_ball());
  m_shape->keep_within(m_moved ? transformed(kept, m_moved->transform.inverse()) : kept);
}

Bounds Leaf::bounds() const { return limited(box()); }

Bounds Leaf::solid_bounds() const {
  if (const Bounds* gate = solid_gate()) return *gate;
  const ShapeTraits traits = m_shape->traits();
  Bounds b;
  if (is_inverse() || traits.solid_is_unbounded) {
    b = Bounds::everything();
  } else if (traits.is_solid) {
    b = box();
  }
  for (const auto& clip : clips()) {
    if (!clip->is_gated()) b.intersect(clip->solid_bounds());
  }
  return b.is_empty() ? Bounds() : b;
}

Bounds Leaf::void_bounds() const {
  if (!is_inverse() || !clips().empty()) return Bounds::everything();
  return m_shape->traits().solid_is_unbounded ? Bounds::everything() : box();
}

Ball Leaf::solid_ball() const {
  const ShapeTraits traits = m_shape->traits();
  Ball ball;
  if (!is_inverse() && traits.is_solid && !traits.solid_is_unbounded) ball = first_ball();
  for (const auto& clip : clips()) ball = smaller(ball, clip->solid_ball());
  return ball;
}

void Leaf::set_inverse(bool inverse) {
  const ShapeTraits traits = m_shape->traits();
  if (traits.is_solid) {
    Object::set_inverse(inverse);
    set_turns_normal(inverse && traits.inverse_turns_normal);
  } else if (inverse && traits.inverse_turns_normal) {
    // is_inverse() stays false, so that every inversion asks for true.
    set_turns_normal(!turns_normal());
  }
}

bool Leaf::shape_nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  if (!m_moved) return m_shape->nearest(ray, t_min, t_max, hit);
  return m_shape->nearest(to_shape(ray), t_min, t_max, hit);
}

bool Leaf::nearest(const Ray& ray, double t_min, double t_max, Hit& hit,
                   const RayQuery& query) const {
  if (ball().is_missed_by(ray)) return false;
  if (!gates().empty() && !passes_gates(ray, query)) return false;
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
  ShapeHits& all = query.arena.shape_hits;
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
  if (!clips().empty() || !gates().empty()) {
    Hit hit;
    return Leaf::nearest(ray, t_min, t_max, hit, query);
  }
  if (!m_moved) return m_shape->any(ray, t_min, t_max);
  return m_shape->any(to_shape(ray), t_min, t_max);
}

template <class Ask>
void Leaf::gather(const Ray& ray, std::vector<Hit>& hits, const RayQuery& query, Ask&& ask) const {
  if (ball().is_missed_by(ray)) return;
  if (!gates().empty() && !passes_gates(ray, query)) return;
  ShapeHits& list = query.arena.shape_hits;
  list.clear();
  ask(m_moved ? to_shape(ray) : ray, list);
  for (const ShapeHit& found : list) {
    if (!clips().empty() && !passes_clips(ray.at(found.t))) continue;
    hits.push_back({found.t, this, nullptr, found});
  }
}

void Leaf::all(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits,
               const RayQuery& query) const {
  gather(ray, hits, query,
         [&](const Ray& in_shape, ShapeHits& list) { m_shape->all(in_shape, t_min, t_max, list); });
}

void Leaf::all_alone(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits,
                     const RayQuery& query) const {
  gather(ray, hits, query, [&](const Ray& in_shape, ShapeHits& list) {
    if (!m_shape->traits().tells_first_alone) return m_shape->all(in_shape, t_min, t_max, list);
    ShapeHit first;
    if (m_shape->nearest(in_shape, t_min, t_max, first)) list.push_back(first);
  });
}

bool Leaf::inside(const Vec3& p) const {
  if (!clips().empty() && !passes_clips(p)) return false;
  const Vec3 q = m_moved ? m_moved->transform.inverse_point(p) : p;
  return is_inverse() ? m_shape->outside(q) : m_shape->inside(q);
}

Vec3 Leaf::normal(const Vec3& world_point, const ShapeHit& hit) const {
  if (m_moved) {
    const Vec3 n = m_moved->transform.normal(
        m_shape->normal(m_moved->transform.inverse_point(world_point), hit));
    return normalized(turns_normal() ? -n : n);
  }
  const Vec3 n = m_shape->normal(world_point, hit);
  return normalized(turns_normal() ? -n : n);
}

Vec2 Leaf::uv(const Vec3& world_point, const ShapeHit& hit) const {
  if (!m_shape->traits().has_uv || !m_moved) return m_shape->uv(world_point, hit);
  return m_shape->uv(m_moved->transform.inverse_point(world_point), hit);
}

}  // namespace lentray::core
