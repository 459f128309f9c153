#include "tests/compat/include_names.h"

#include <algorithm>
#include <cctype>

namespace lentray::test {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The text with comments blanked and strings emptied.
std::string bare(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view two = text.substr(i, 2);
    if (two == "//") {
      i = std::min(text.find('\n', i), text.size() - 1);
      out += '\n';
    } else if (two == "/*") {
      int depth = 1;  // comments nest
      for (++i; depth > 0 && ++i < text.size();) {
        const std::string_view here = text.substr(i, 2);
        if (here == "/*")
          ++depth, ++i;
        else if (here == "*/")
          --depth, ++i;
      }
      out += ' ';
    } else if (text[i] == '"') {
      while (++i < text.size() && text[i] != '"') i += text[i] == '\\' ? 1 : 0;
      out += "\"\"";
    } else {
      out += text[i];
    }
  }
  return out;
}

/// Words and single other characters of a bare text, one after the other.
class Words {
 public:
  explicit Words(std::string_view text) : m_text(text) {}
  std::string next() {
    while (m_at < m_text.size() && std::isspace(static_cast<unsigned char>(m_text[m_at]))) ++m_at;
    const std::size_t begin = m_at;
    while (m_at < m_text.size() && is_word(m_text[m_at])) ++m_at;
    if (m_at == begin && m_at < m_text.size()) ++m_at;
    return std::string(m_text.substr(begin, m_at - begin));
  }

 private:
  std::string_view m_text;
  std::size_t m_at = 0;
};

void add(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// The name that a #declare sets; `deprecated once "why", Name` is one, too.
std::string declared(Words& words) {
  std::string name = words.next();
  if (name == "deprecated") name = words.next();
  if (name == "once") name = words.next();
  while (name == "\"" || name == ",") name = words.next();
  return name;
}

}  // namespace

IncludeNames declared_names(std::string_view sdl) {
  IncludeNames out;
  const std::string text = bare(sdl);
  Words words(text);
  std::vector<bool> blocks;  // true: of a macro
  for (std::string word = words.next(); !word.empty(); word = words.next()) {
    if (word != "#") continue;
    word = words.next();
    if (word == "declare") {
      add(out.identifiers, declared(words));
    } else if (word == "undef") {
      // A macro that the file takes back is a name that must not be there.
      const std::string name = words.next();
      const bool inner = std::find(blocks.begin(), blocks.end(), true) != blocks.end();
      if (!inner && std::erase(out.macros, name) > 0) add(out.identifiers, name);
    } else if (word == "macro") {
      const bool inner = std::find(blocks.begin(), blocks.end(), true) != blocks.end();
      const std::string name = words.next();
      if (!inner) add(out.macros, name);
      blocks.push_back(true);
    } else if (word == "if" || word == "ifdef" || word == "ifndef" || word == "while" ||
               word == "for" || word == "switch") {
      blocks.push_back(false);
    } else if (word == "end" && !blocks.empty()) {
      blocks.pop_back();
    }
  }
  return out;
}

bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_word(text[at - 1])) && (end == text.size() || !is_word(text[end])))
      return true;
  }
  return false;
}

}  // namespace lentray::test
