// Which interiors a camera ray starts in. World space. One a thread: it remembers the answer for
// the last start, since most cameras start all rays at one point.
// Every solid counts, also one without an `interior` statement: it changes
// the Fresnel term within nested objects.
#pragma once

#include <vector>

#include "core/accel/hierarchy.h"
#include "core/scene/scene.h"
#include "core/trace/interior_table.h"

namespace lentray::core {

class StartInteriors {
 public:
  explicit StartInteriors(const Scene& scene) : m_scene(scene) {}

  InteriorsId at(const Vec3& start, InteriorTable& table) {
    if (!m_known || !(start == m_start)) find(start);
    InteriorsId inside = InteriorsId::kOpen;
    for (const InteriorEntry& entry : m_entries) inside = table.push(inside, entry);
    return inside;
  }

 private:
  void find(const Vec3& start) {
    m_start = start;
    m_known = true;
    m_entries.clear();
    m_scene.hierarchy().containing(start, m_objects);
    for (const Object* object : m_objects) {
      m_entries.push_back(interior_of(object->attributes(), object));
    }
  }

  const Scene& m_scene;
  std::vector<const Object*> m_objects;
  Vec3 m_start;
  bool m_known = false;
  std::vector<InteriorEntry> m_entries;
};

}  // namespace lentray::core
