// Steps over a scene's text token by token, as far as needed to find words, strings and braces. Comments nest.
// Errors: none. The text must outlive it.
#pragma once

#include <cstddef>
#include <string_view>

namespace lentray::tool {

class SceneScanner {
 public:
  explicit SceneScanner(std::string_view text) : m_text(text) {}

  /// The next word or single character outside comments and strings; empty at the end.
  std::string_view next();
  /// The text of a string that comes next, behind comments; nothing if something else does.
  std::string_view next_string();

  std::size_t begin() const { return m_begin; }  ///< of the last token
  std::size_t end() const { return m_at; }

 private:
  bool sees(std::string_view what) const { return m_text.substr(m_at).starts_with(what); }
  void skip_comments();
  void skip_block_comment();
  void skip_string();

  std::string_view m_text;
  std::size_t m_at = 0, m_begin = 0;
};

}  // namespace lentray::tool
