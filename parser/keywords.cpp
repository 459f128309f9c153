#include "parser/keywords.h"

#include <array>
#include <unordered_map>

namespace lentray::parser {
namespace {

constexpr std::string_view kSpellings[] = {
    "",
#define LENTRAY_KEYWORD(name, spelling) spelling,
#include "parser/keywords.def"
#undef LENTRAY_KEYWORD
};

constexpr KeywordAlias kAliases[] = {
    {"colour", Keyword::kColor},
    {"colour_map", Keyword::kColorMap},
    {"fade_colour", Keyword::kFadeColor},
    {"quick_colour", Keyword::kQuickColor},
    {"use_colour", Keyword::kUseColor},
};

constexpr std::string_view kPuncts[] = {
    "", "{", "}", "(", ")", "[", "]", "<", ">", "<=", ">=", "!=", "=", "+", "-", "*", "/", ",",
    ";", ":", ".", "?", "!", "&", "|", "%", "^", "$", "@", "~", "'", "\\", "`", "#",
};

using Table = std::unordered_map<std::string_view, Keyword>;

Table make_table() {
  Table table;
  for (std::size_t i = 1; i < std::size(kSpellings); ++i) {
    table.emplace(kSpellings[i], static_cast<Keyword>(i));
  }
  for (const KeywordAlias& alias : kAliases) table.emplace(alias.word, alias.keyword);
  return table;
}

}  // namespace

std::string_view spelling(Keyword keyword) { return kSpellings[static_cast<std::size_t>(keyword)]; }

std::string_view spelling(Punct punct) { return kPuncts[static_cast<std::size_t>(punct)]; }

Keyword find_keyword(std::string_view word) {
  static const Table table = make_table();
  const auto found = table.find(word);
  return found == table.end() ? Keyword::kNone : found->second;
}

std::span<const KeywordAlias> keyword_aliases() { return kAliases; }

}  // namespace lentray::parser
