#include "core/scene/scene.h"

#include <utility>

#include "core/accel/hierarchy.h"
#include "core/scene/needs_finder.h"
#include "core/scene/solid_index.h"

namespace lentray::core {
namespace {

/// An unclipped union's surface is that of its parts, so that each part may stand alone in the
/// hierarchy. (A merge's is not: it has no surfaces inside.)
Csg* splittable(Object& object) {
  if (object.is_inverse() || !object.clips().empty() || !object.bounding().empty()) return nullptr;
  auto* csg = dynamic_cast<Csg*>(&object);
  return csg && csg->kind() == CsgKind::kUnion ? csg : nullptr;
}

struct Splitter {
  std::vector<std::unique_ptr<Object>> objects;
  std::vector<std::uint32_t> groups;  ///< which object of the source each came from

  void add(std::unique_ptr<Object> object, std::uint32_t group) {
    if (Csg* csg = splittable(*object)) {
      for (auto& child : csg->take_children()) add(std::move(child), group);
      return;
    }
    objects.push_back(std::move(object));
    groups.push_back(group);
  }
};

}  // namespace

Scene::Scene(SceneParts parts, const CompileOptions& options) : m_parts(std::move(parts)) {
  Splitter split;
  std::uint32_t group = 0;
  for (auto& object : m_parts.objects) split.add(std::move(object), group++);
  m_parts.objects = std::move(split.objects);
  for (auto& object : m_parts.objects) object->set_opaque(all_opaque(*object));
  m_needs = find_needs(m_parts);
  if (options.general_path) m_needs = everything_needed(std::move(m_needs), m_parts.settings);
  m_solids = std::make_unique<SolidIndex>(m_parts.objects, split.groups);
  m_hierarchy = std::make_unique<Hierarchy>(m_parts.objects, options.linear_search);
}

Scene::~Scene() = default;

void Scene::containing(const Vec3& p, std::vector<const Object*>& out) const {
  m_solids->containing(p, out);
}

}  // namespace lentray::core
