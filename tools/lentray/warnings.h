// The warnings of a run: each is said once, however many frames have it, and as soon as it is safe to: those of a
// scene before it is rendered. One thread.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tools/lentray/message_form.h"

namespace lentray::tool {

class Warnings {
 public:
  /// Level 0: none is said.
  Warnings(const MessageForm& form, int level) : m_form(form), m_level(level) {}
  /// About a place in the scene, with its heading.
  void add(const std::string& text) { m_waiting.push_back(text); }
  /// About anything else.
  void tell(const std::string& text) { add(m_form.warning(text)); }
  /// Says what was added since the last call.
  void say();

 private:
  const MessageForm& m_form;
  const int m_level;
  std::vector<std::string> m_waiting;
  std::set<std::string> m_said;
};

}  // namespace lentray::tool
