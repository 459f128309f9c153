#include "core/object/hit.h"

namespace lentray::core {

std::vector<Hit>& HitLists::acquire() {
  if (m_used == m_lists.size()) m_lists.push_back(std::make_unique<std::vector<Hit>>());
  std::vector<Hit>& list = *m_lists[m_used++];
  list.clear();
  return list;
}

}  // namespace lentray::core
