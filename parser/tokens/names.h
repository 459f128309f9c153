// Interned names and string literals of a scene. Two names are the same if their ids are; ids up
// to reserved() are reserved words. One thread; texts stay valid as long as the table.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parser/tokens/token.h"

namespace lentray::parser {

class NameTable {
 public:
  NameTable();

  NameId intern(std::string_view name);
  std::string_view text(NameId id) const { return m_texts[id]; }
  /// The reserved word a name is, or kNone.
  Keyword keyword(NameId id) const {
    return id < m_keywords.size() ? m_keywords[id] : Keyword::kNone;
  }
  std::size_t size() const { return m_texts.size(); }

  /// String literals: `raw` is what stands between the quotes (file names take it so), `cooked`
  /// has the escapes replaced, `ascii` is that with a space for each byte that is not ASCII.
  NameId add_string(std::string raw, std::string cooked, std::string ascii = {});
  const std::string& raw_string(NameId id) const {
    const Literal& literal = m_strings[id];
    return literal.other ? literal.other->raw : literal.cooked;
  }
  const std::string& string(NameId id) const { return m_strings[id].cooked; }
  /// The same, if nothing in it is to be replaced by ASCII; else null.
  const std::string* ascii_alone(NameId id) const {
    const Literal& literal = m_strings[id];
    return literal.other && !literal.other->ascii.empty() ? nullptr : &literal.cooked;
  }
  /// Null if the literal is ASCII as it stands.
  const std::string* ascii_string(NameId id) const {
    const Literal& literal = m_strings[id];
    return literal.other && !literal.other->ascii.empty() ? &literal.other->ascii : nullptr;
  }

 private:
  struct Variants {
    std::string raw, ascii;
  };
  struct Literal {
    std::string cooked;
    std::unique_ptr<const Variants> other;  ///< null: raw is the same, and ASCII
  };
  std::deque<std::string> m_texts;
  std::unordered_map<std::string_view, NameId> m_ids;
  std::vector<Keyword> m_keywords;  // by name id, the reserved words only
  std::deque<Literal> m_strings;
};

}  // namespace lentray::parser
