#include "tools/common/scene_scanner.h"

#include <algorithm>
#include <cctype>

namespace lentray::tool {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

}  // namespace

std::string_view SceneScanner::next() {
  for (skip_comments(); sees("\""); skip_comments()) skip_string();
  m_begin = m_at;
  if (m_at >= m_text.size()) return {};
  if (!is_word(m_text[m_at])) return m_text.substr(m_at++, 1);
  while (m_at < m_text.size() && is_word(m_text[m_at])) ++m_at;
  return m_text.substr(m_begin, m_at - m_begin);
}

std::string_view SceneScanner::next_string() {
  skip_comments();
  if (!sees("\"")) return {};
  const std::size_t from = m_at + 1;
  skip_string();
  return m_text.substr(from, m_at - from - 1);
}

void SceneScanner::skip_comments() {
  while (m_at < m_text.size()) {
    if (std::isspace(static_cast<unsigned char>(m_text[m_at]))) {
      ++m_at;
    } else if (sees("//")) {
      m_at = std::min(m_text.find('\n', m_at), m_text.size());
    } else if (sees("/*")) {
      skip_block_comment();
    } else {
      return;
    }
  }
}

void SceneScanner::skip_block_comment() {
  for (int depth = 0; m_at < m_text.size(); ++m_at) {
    const int step = sees("/*") ? 1 : sees("*/") ? -1 : 0;
    if (step == 0) continue;
    ++m_at;
    depth += step;
    if (depth == 0) break;
  }
  m_at = std::min(m_at + 1, m_text.size());
}

void SceneScanner::skip_string() {
  for (++m_at; m_at < m_text.size() && m_text[m_at] != '"'; ++m_at) {
    if (m_text[m_at] == '\\') ++m_at;
  }
  m_at = std::min(m_at + 1, m_text.size());
}

}  // namespace lentray::tool
