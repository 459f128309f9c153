// Tokens: what the lexer makes of a source text. Small and trivially copyable; names and strings
// are ids into the NameTable of the interpreter, so comparing names compares ints.
// Keyword and Punct are closed sets; the reserved words live in one table file, keywords.def.
#pragma once

#include <cstdint>

#include "parser/source/source.h"

namespace lentray::parser {

/// Reserved words of POV-Ray 3.7: k + the word in CamelCase, kLightSource for light_source.
/// Words with two spellings have one keyword: kColor (colour too), kColorMap, kGray ...
enum class Keyword : std::uint16_t {
  kNone,
#define LENTRAY_KEYWORD(name, spelling) name,
#include "parser/tokens/keywords.def"
#undef LENTRAY_KEYWORD
  kEndOfKeywords
};

enum class Punct : std::uint8_t {
  kNone,
  kLeftCurly,     // {
  kRightCurly,    // }
  kLeftParen,     // (
  kRightParen,    // )
  kLeftSquare,    // [
  kRightSquare,   // ]
  kLess,          // <
  kGreater,       // >
  kLessEqual,     // <=
  kGreaterEqual,  // >=
  kNotEqual,      // !=
  kEqual,         // =
  kPlus,          // +
  kMinus,         // -
  kStar,          // *
  kSlash,         // /
  kComma,         // ,
  kSemicolon,     // ;
  kColon,         // :
  kDot,           // .
  kQuestion,      // ?
  kExclamation,   // !
  kAmpersand,     // &
  kBar,           // |
  kPercent,       // %
  kCaret,         // ^
  kDollar,        // $
  kAt,            // @
  kTilde,         // ~
  kApostrophe,    // '
  kBackslash,     // a backslash
  kBackquote,     // `
  kHash,          // # with no directive behind it
};

enum class TokenKind : std::uint8_t {
  kEnd,         ///< end of the scene
  kKeyword,     ///< keyword, name
  kPunct,       ///< punct
  kIdentifier,  ///< name
  kNumber,      ///< number
  kString,      ///< name: id of its text
  kDirective,   ///< # and its word, keyword; only inside the token stream
  kBad,         ///< what no token starts with, or an unterminated string; fails when it is read
};

using NameId = std::uint32_t;

struct Token {
  TokenKind kind : 7 = TokenKind::kEnd;
  /// Nothing has to happen when it is read, whatever it means: a number, a string, most punctuation
  /// and words. Set by the lexer.
  bool passive : 1 = false;
  Punct punct = Punct::kNone;
  Keyword keyword = Keyword::kNone;
  NameId name = 0;
  union {
    double number = 0.0;
    /// Directives: index of the token that ends this part (the next #else, #case, #end ...).
    std::uint64_t jump;
  };
  Location where;

  bool is(Keyword k) const { return kind == TokenKind::kKeyword && keyword == k; }
  bool is(Punct p) const { return kind == TokenKind::kPunct && punct == p; }
  /// A `<` that stands for a whole vector, or for the numbers of a matrix (TokenList::components).
  static constexpr NameId kMostOfVector = 5, kOfMatrix = 12;  ///< components
  bool is_literal_vector() const { return is(Punct::kLess) && name > 0 && name <= kMostOfVector; }
  bool is_literal_matrix() const { return is(Punct::kLess) && name == kOfMatrix; }
};
static_assert(sizeof(Token) == 24, "scenes have millions of them");

}  // namespace lentray::parser
