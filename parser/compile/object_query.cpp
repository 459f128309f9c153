#include "parser/compile/object_query.h"

#include "core/object/leaf.h"
#include "parser/compile/object_builder.h"

namespace lentray::parser {
namespace {

constexpr double kMinDistance = 1e-4;  ///< trace() does not see what is nearer

}  // namespace

ObjectQuery::ObjectQuery(const ObjectDesc& object) {
  CompiledSlot& slot = object.compiled;
  if (!slot.made) {
    NotYet missing;
    CompiledSlot::Compiled made;
    auto whole = ObjectBuilder(missing).geometry(object);
    if (whole && core::is_seen_afar(*whole)) made.farthest = core::Bounds::kInf;
    made.object = std::move(whole);
    slot.made = std::make_shared<const CompiledSlot::Compiled>(std::move(made));
  }
  m_object = slot.made->object;
  m_farthest = slot.made->farthest;
}

bool ObjectQuery::inside(const core::Vec3& point) const {
  return m_object && m_object->inside(point);
}

bool ObjectQuery::trace(const core::Vec3& origin, const core::Vec3& direction, core::Vec3& point,
                        core::Vec3& normal) const {
  point = normal = core::Vec3{};
  const core::Ray ray{origin, normalized(direction)};
  if (!m_object || ray.direction == core::Vec3{}) return false;
  core::Hit hit;
  core::HitLists lists;
  if (!m_object->nearest(ray, kMinDistance, m_farthest, hit, {lists, core::RayKind::kShadow}))
    return false;
  point = ray.at(hit.t);
  normal = hit.leaf->normal(point, hit.shape);
  return true;
}

}  // namespace lentray::parser
