#include "parser/values/symbols.h"

#include <utility>

namespace lentray::parser {

void SymbolTable::pop_scope() {
  const std::size_t start = m_scopes.back();
  while (m_hidden.size() > start) {
    m_visible[m_hidden.back().name] = std::move(m_hidden.back().outer);
    m_hidden.pop_back();
  }
  m_scopes.pop_back();
}

Symbol& SymbolTable::declare_global(NameId name) {
  SymbolPtr& visible = slot(name);
  if (!visible) visible = make_symbol();
  return *visible;
}

Symbol& SymbolTable::declare_local(NameId name) {
  SymbolPtr& visible = slot(name);
  if (visible && visible->level == level()) return *visible;
  bind_local(name, make_symbol());
  return *m_visible[name];
}

// Seen from that scope, the symbol shown is what the first scope within hides, or the visible one.
Symbol& SymbolTable::declare_at(NameId name, std::uint32_t home) {
  if (home >= level()) return declare_local(name);
  SymbolPtr* shown = &slot(name);
  for (std::size_t i = m_scopes[home]; i < m_hidden.size(); ++i) {
    if (m_hidden[i].name != name) continue;
    shown = &m_hidden[i].outer;
    break;
  }
  if (*shown && (*shown)->level == home) return **shown;
  auto made = make_symbol();
  made->level = home;
  SymbolPtr hidden = std::exchange(*shown, made);
  if (home > 0) {
    m_hidden.insert(m_hidden.begin() + static_cast<std::ptrdiff_t>(m_scopes[home]),
                    {name, std::move(hidden)});
    for (std::size_t s = home; s < m_scopes.size(); ++s) ++m_scopes[s];
  }
  return *made;
}

void SymbolTable::bind_local(NameId name, SymbolPtr symbol) {
  SymbolPtr& visible = slot(name);
  if (symbol) symbol->level = level();
  if (level() > 0) {
    Hidden& hidden = m_hidden.emplace_back();
    hidden.name = name;
    hidden.outer = std::move(visible);
  }
  visible = std::move(symbol);
}

void SymbolTable::remove(NameId name) {
  SymbolPtr& visible = slot(name);
  if (!visible) return;
  const std::uint32_t home = visible->level;
  if (home == 0) {
    visible.reset();
    return;
  }
  const std::size_t start = m_scopes[home - 1];
  const std::size_t end = home < m_scopes.size() ? m_scopes[home] : m_hidden.size();
  for (std::size_t i = end; i-- > start;) {
    if (m_hidden[i].name != name) continue;
    visible = std::move(m_hidden[i].outer);
    m_hidden[i].outer.reset();
    // The entry stays for the scope's end: it must then restore what shows now.
    m_hidden[i].outer = visible;
    return;
  }
  visible.reset();
}

std::vector<NameId> SymbolTable::visible_names() const {
  std::vector<NameId> names;
  for (std::size_t i = 0; i < m_visible.size(); ++i) {
    if (m_visible[i]) names.push_back(static_cast<NameId>(i));
  }
  return names;
}

}  // namespace lentray::parser
