#include "core/object/gated.h"

#include <utility>

namespace lentray::core {

Gated::Gated(std::unique_ptr<Object> content, Regions gates)
    : m_content(std::move(content)), m_gates(std::move(gates)) {
  set_attributes(m_content->attributes());
  take_after_content();
}

void Gated::take_after_content() {
  Object::set_inverse(m_content->is_inverse());
  set_lies_in_parts(m_content->lies_in_parts());
  Ball ball = m_content->ball();
  for (const auto& gate : m_gates) ball = smaller(ball, gate->solid_ball());
  set_ball(ball);
}

void Gated::set_inverse(bool inverse) {
  m_content->set_inverse(inverse);
  take_after_content();
}

Bounds Gated::bounds() const {
  const Bounds b = m_content->bounds();
  if (b.is_empty() || b.is_finite()) return b;
  Bounds common = Bounds::everything();
  for (const auto& gate : m_gates) {
    Bounds box = gate->solid_bounds();
    box.include(gate->bounds());
    common.intersect(box);
  }
  if (common.is_empty()) return Bounds();
  return common.is_finite() ? common : b;
}

bool Gated::lets_pass(const Ray& ray, const RayQuery& query) const {
  if (ball().is_missed_by(ray)) return false;
  for (const auto& gate : m_gates) {
    // Most rays that come here meet it.
    if (!gate->any(ray, 0.0, Bounds::kInf, query) && !gate->inside(ray.origin)) return false;
  }
  return true;
}

bool Gated::nearest(const Ray& ray, double t_min, double t_max, Hit& hit,
                    const RayQuery& query) const {
  return lets_pass(ray, query) && m_content->nearest(ray, t_min, t_max, hit, query);
}

void Gated::all(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits,
                const RayQuery& query) const {
  if (lets_pass(ray, query)) m_content->all(ray, t_min, t_max, hits, query);
}

bool Gated::any(const Ray& ray, double t_min, double t_max, const RayQuery& query) const {
  return lets_pass(ray, query) && m_content->any(ray, t_min, t_max, query);
}

Object& ungated(Object& object) {
  auto* gated = dynamic_cast<Gated*>(&object);
  return gated ? gated->content() : object;
}

}  // namespace lentray::core
