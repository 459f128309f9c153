#include "tools/lentray/warnings.h"

namespace lentray::tool {

void Warnings::say() {
  for (const std::string& text : m_waiting) {
    if (m_level == 0 || !m_said.insert(text).second) continue;
    m_form.texts().write(parser::Stream::kWarning, text.ends_with('\n') ? text : text + "\n");
  }
  m_waiting.clear();
}

}  // namespace lentray::tool
