#include "core/render/start_interiors.h"

namespace lentray::core {
namespace {

constexpr std::size_t kGroupSize = 64;

}  // namespace

StartInteriors::StartInteriors(const Scene& scene) {
  for (const auto& object : scene.objects()) {
    if (m_groups.empty() || m_candidates.size() - m_groups.back().first == kGroupSize) {
      m_groups.push_back({{}, m_candidates.size(), m_candidates.size()});
    }
    m_candidates.push_back({object->bounds(), object.get()});
    m_groups.back().bounds.include(m_candidates.back().bounds);
    m_groups.back().last = m_candidates.size();
  }
}

const InteriorStack& StartInteriors::at(const Vec3& start) {
  if (m_known && start == m_start) return m_inside;
  m_start = start;
  m_known = true;
  m_inside.clear();
  for (const Group& group : m_groups) {
    if (!group.bounds.contains(start)) continue;
    for (std::size_t i = group.first; i < group.last; ++i) {
      const Candidate& candidate = m_candidates[i];
      if (candidate.bounds.contains(start) && candidate.object->inside(start)) {
        m_inside.push(interior_of(candidate.object->attributes(), candidate.object));
      }
    }
  }
  return m_inside;
}

}  // namespace lentray::core
