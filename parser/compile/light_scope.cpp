#include "parser/compile/light_scope.h"

#include <cstddef>

namespace lentray::parser {

bool LightScope::global() const {
  bool global = true;
  for (const LightScope* scope = this; scope; scope = scope->m_around) {
    if (scope->m_light) return true;
    if (scope->m_group) global = scope->m_global;
  }
  return global;
}

std::vector<std::uint32_t> LightScope::local() const {
  std::vector<const LightScope*> way;  // innermost first
  for (const LightScope* scope = this; scope; scope = scope->m_around) way.push_back(scope);
  std::vector<bool> has_list(way.size(), false);
  std::vector<std::uint32_t> all;
  for (std::size_t group = 0; group < way.size(); ++group) {
    const std::vector<std::uint32_t>& lights = way[group]->m_lights;
    if (lights.empty()) continue;
    bool arrives = true;
    for (std::size_t inner = group; arrives && inner-- > 0;) {
      arrives = !has_list[inner];
      has_list[inner] = true;
    }
    if (arrives) all.insert(all.end(), lights.begin(), lights.end());
    has_list[group] = !way[group]->m_copied;
  }
  return all;
}

}  // namespace lentray::parser
