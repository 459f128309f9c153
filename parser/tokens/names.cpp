#include "parser/tokens/names.h"

#include "parser/tokens/keywords.h"

namespace lentray::parser {

NameTable::NameTable() {
  const auto reserve = [&](std::string_view word, Keyword keyword) {
    intern(word);
    m_keywords.push_back(keyword);
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(Keyword::kEndOfKeywords); ++i) {
    const Keyword keyword = static_cast<Keyword>(i);
    reserve(spelling(keyword), keyword);  // the empty name first: id 0
  }
  for (const KeywordAlias& alias : keyword_aliases()) reserve(alias.word, alias.keyword);
}

NameId NameTable::intern(std::string_view name) {
  const auto found = m_ids.find(name);
  if (found != m_ids.end()) return found->second;
  const NameId id = static_cast<NameId>(m_texts.size());
  m_texts.emplace_back(name);
  m_ids.emplace(m_texts.back(), id);
  return id;
}

NameId NameTable::add_string(std::string raw, std::string cooked, std::string ascii) {
  const bool plain = ascii.empty() && raw == cooked;
  m_strings.push_back({std::move(cooked), plain ? nullptr
                                                : std::make_unique<const Variants>(
                                                      Variants{std::move(raw), std::move(ascii)})});
  return static_cast<NameId>(m_strings.size() - 1);
}

}  // namespace lentray::parser
