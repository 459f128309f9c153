// Which interiors a camera ray starts in. World space. One a thread: it remembers the answer for
// the last start, since most cameras start all rays at one point.
// Every solid counts, also one without an `interior` statement: stock has it so, and it changes
// the Fresnel term within nested objects.
#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "core/trace/interior_stack.h"

namespace lentray::core {

class StartInteriors {
 public:
  explicit StartInteriors(const Scene& scene) : m_scene(scene) {}

  const InteriorStack& at(const Vec3& start) {
    if (m_known && start == m_start) return m_inside;
    m_start = start;
    m_known = true;
    m_inside.clear();
    m_scene.containing(start, m_objects);
    for (const Object* object : m_objects) {
      m_inside.push(interior_of(object->attributes(), object));
    }
    return m_inside;
  }

 private:
  const Scene& m_scene;
  std::vector<const Object*> m_objects;
  Vec3 m_start;
  bool m_known = false;
  InteriorStack m_inside;
};

}  // namespace lentray::core
