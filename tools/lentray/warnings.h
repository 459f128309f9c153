// The warnings of a run: each is said once, however many frames have it, and as soon as it is safe to: those of a
// scene before it is rendered. One thread.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tools/lentray/text_streams.h"

namespace lentray::tool {

class Warnings {
 public:
  /// Level 0: none is said.
  Warnings(TextStreams& texts, int level) : m_texts(texts), m_level(level) {}
  void add(const std::string& text) { m_waiting.push_back(text); }
  /// Says what was added since the last call.
  void say();

 private:
  TextStreams& m_texts;
  const int m_level;
  std::vector<std::string> m_waiting;
  std::set<std::string> m_said;
};

}  // namespace lentray::tool
