// The reserved words: spelling <-> Keyword. Stateless; safe from any thread.
// Source: the words POV-Ray 3.7.0.10 refuses to #declare (each one tried), see keywords.def.
#pragma once

#include <span>
#include <string_view>

#include "parser/tokens/token.h"

namespace lentray::parser {

/// The word as it is written ("light_source"); "" for kNone.
std::string_view spelling(Keyword keyword);
/// The punctuation as it is written.
std::string_view spelling(Punct punct);

/// The keyword of a word, other spellings (colour, grey ...) included; kNone if it is not reserved.
Keyword find_keyword(std::string_view word);

/// A number, a vector or a function that gives one begins with it.
bool starts_operand(Keyword keyword);

/// A second spelling of a keyword.
struct KeywordAlias {
  std::string_view word;
  Keyword keyword;
};
std::span<const KeywordAlias> keyword_aliases();

}  // namespace lentray::parser
