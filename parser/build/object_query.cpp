#include "parser/build/object_query.h"

#include <algorithm>

#include "parser/build/object_builder.h"

namespace lentray::parser {
namespace {

constexpr double kHuge = 1e10;         ///< where stock's bounding boxes end
constexpr double kMinDistance = 1e-4;  ///< trace() does not see what is nearer

}  // namespace

ObjectQuery::ObjectQuery(const ObjectDesc& object) {
  CompiledSlot& slot = object.compiled;
  if (!slot.tried) {
    NotYet missing;
    slot.object = ObjectBuilder(missing).geometry(object);
    slot.is_whole = missing.empty();
    slot.tried = true;
  }
  m_object = slot.object;
  m_is_whole = slot.is_whole;
}

bool ObjectQuery::inside(const core::Vec3& point) const { return m_object && m_object->inside(point); }

bool ObjectQuery::trace(const core::Vec3& origin, const core::Vec3& direction, core::Vec3& point,
                        core::Vec3& normal) const {
  point = normal = core::Vec3{};
  const core::Ray ray{origin, normalized(direction)};
  if (!m_object || ray.direction == core::Vec3{}) return false;
  core::Hit hit;
  core::HitArena arena;
  if (!m_object->nearest(ray, kMinDistance, core::Bounds::kInf, hit, arena)) return false;
  point = ray.at(hit.t);
  normal = hit.leaf->normal(point, hit.shape);
  return true;
}

void ObjectQuery::extent(core::Vec3& lo, core::Vec3& hi) const {
  lo = hi = core::Vec3{};
  if (!m_object) return;
  core::Bounds bounds = m_object->bounds();
  for (const auto& clip : m_object->clips()) bounds.intersect(clip->bounds());
  if (bounds.is_empty()) return;
  for (int axis = 0; axis < 3; ++axis) {
    lo[axis] = std::max(bounds.lo[axis], -kHuge);
    hi[axis] = std::min(bounds.hi[axis], kHuge);
  }
}

}  // namespace lentray::parser
