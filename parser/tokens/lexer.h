// Turns a source text into tokens, once. Comments nest; strings may span lines; a directive is one
// token (# and its word) that knows where its part ends, so that skipping is a jump.
// What is wrong in a text (an unknown character, an open string) becomes a kBad token and fails
// only if it is read: the text between #if (0) and #end may be anything.
// Source: reference manual 3.7, "Language Basics"; strings as measured on stock.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "parser/tokens/names.h"
#include "parser/tokens/token.h"

namespace lentray::parser {

/// The tokens of one text. Shared by everything that replays parts of it (macros, loops).
struct TokenList {
  std::uint32_t file = 0;
  /// The last one is a kEnd that belongs to no text: whoever looks ahead stops there.
  std::vector<Token> tokens;
  std::size_t size() const { return tokens.size() - 1; }
  const Token* begin() const { return tokens.data(); }
  const Token* end() const { return tokens.data() + size(); }
  /// Of vectors of literal numbers where `<` can only begin one, of which data are made, and of `matrix`: it
  /// is the only token, `jump` says where its components stand here and `name` how many there are.
  std::vector<double> components;
};

std::shared_ptr<const TokenList> tokenise(std::uint32_t file, std::string_view text,
                                          NameTable& names);

/// What TokenPieces::plain() found.
enum class PlainValue : std::uint8_t { kNone, kNumber, kString };

/// The same in pieces, so that of a long text few tokens are held at a time: a piece ends with the text, or
/// behind a comma or `}` that stands in no vector, parentheses, brackets, conditional, loop or macro.
class TokenPieces {
 public:
  TokenPieces(std::uint32_t file, std::string_view text, NameTable& names);
  ~TokenPieces();
  /// Makes the next piece, of at least so many tokens if the text has them; false, and the list is empty, if
  /// nothing is left. The list before is used again unless somebody else holds it.
  bool next(std::size_t least);
  const std::shared_ptr<TokenList>& list() const { return m_list; }
  /// What stands behind the piece at hand, if it is a number, or a string that means what it says,
  /// and a comma: read without being made tokens. The string is of the text. Nothing is read, and
  /// kNone returned, if anything else stands there.
  PlainValue plain(double& number, std::string_view& string);

 private:
  std::shared_ptr<TokenList> m_list;
  std::unique_ptr<class Lexer> m_lexer;
};

}  // namespace lentray::parser
