#include "parser/tokens/keywords.h"

#include <array>
#include <unordered_map>

namespace lentray::parser {
namespace {

constexpr std::string_view kSpellings[] = {
    "",
#define LENTRAY_KEYWORD(name, spelling) spelling,
#include "parser/tokens/keywords.def"
#undef LENTRAY_KEYWORD
};

constexpr KeywordAlias kAliases[] = {
    {"colour", Keyword::kColor},          {"colour_map", Keyword::kColorMap},
    {"fade_colour", Keyword::kFadeColor}, {"quick_colour", Keyword::kQuickColor},
    {"use_colour", Keyword::kUseColor},
};

constexpr std::string_view kPuncts[] = {
    "",  "{", "}", "(", ")", "[", "]", "<", ">", "<=", ">=", "!=", "=", "+", "-",  "*", "/",
    ",", ";", ":", ".", "?", "!", "&", "|", "%", "^",  "$",  "@",  "~", "'", "\\", "`", "#",
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

bool starts_operand(Keyword k) {
  switch (k) {
#define LENTRAY_FLOAT_FUNCTION(name, arity, in_functions, undefined, value) case Keyword::name:
#include "core/function/float_functions.def"
#undef LENTRAY_FLOAT_FUNCTION
    case Keyword::kAsc:
    case Keyword::kClock:
    case Keyword::kClockOn:
    case Keyword::kDefined:
    case Keyword::kDimensionSize:
    case Keyword::kDimensions:
    case Keyword::kFalse:
    case Keyword::kFileExists:
    case Keyword::kInside:
    case Keyword::kMaxExtent:
    case Keyword::kMinExtent:
    case Keyword::kNo:
    case Keyword::kNow:
    case Keyword::kOff:
    case Keyword::kOn:
    case Keyword::kPi:
    case Keyword::kRand:
    case Keyword::kSeed:
    case Keyword::kSelect:
    case Keyword::kStrcmp:
    case Keyword::kStrlen:
    case Keyword::kT:
    case Keyword::kTrace:
    case Keyword::kTrue:
    case Keyword::kU:
    case Keyword::kV:
    case Keyword::kVal:
    case Keyword::kVaxisRotate:
    case Keyword::kVcross:
    case Keyword::kVdot:
    case Keyword::kVersion:
    case Keyword::kVlength:
    case Keyword::kVnormalize:
    case Keyword::kVrotate:
    case Keyword::kVturbulence:
    case Keyword::kX:
    case Keyword::kY:
    case Keyword::kYes:
    case Keyword::kZ: return true;
    default: return false;
  }
}

std::span<const KeywordAlias> keyword_aliases() { return kAliases; }

}  // namespace lentray::parser
