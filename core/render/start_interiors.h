// Which interiors a camera ray starts in. World space. One a thread: it remembers the answer for
// the last start, since most cameras start all rays at one point.
// Every solid counts, also one without an `interior` statement: stock has it so, and it changes
// the Fresnel term within nested objects.
#pragma once

#include <vector>

#include "core/base/bounds.h"
#include "core/render/interior_stack.h"
#include "core/scene/scene.h"

namespace lentray::core {

class StartInteriors {
 public:
  explicit StartInteriors(const Scene& scene);
  const InteriorStack& at(const Vec3& start);

 private:
  struct Group {
    Bounds bounds;
    std::size_t first = 0, last = 0;  ///< of m_candidates
  };
  struct Candidate {
    Bounds bounds;
    const Object* object = nullptr;
  };
  std::vector<Candidate> m_candidates;
  std::vector<Group> m_groups;
  Vec3 m_start;
  bool m_known = false;
  InteriorStack m_inside;
};

}  // namespace lentray::core
