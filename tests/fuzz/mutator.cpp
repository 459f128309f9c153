#include "tests/fuzz/mutator.h"

#include <algorithm>
#include <cctype>

#include "parser/tokens/keywords.h"

namespace lentray::test {
namespace {

using parser::Keyword;
using parser::Punct;

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t end_of_string(std::string_view text, std::size_t i) {
  for (++i; i < text.size() && text[i] != '"'; ++i) {
    if (text[i] == '\\') ++i;
  }
  return std::min(i + 1, text.size());
}

// A #, the space behind it and its word are one piece; so is a number with its point and exponent.
std::size_t end_of_piece(std::string_view text, std::size_t i) {
  const char c = text[i];
  if (c == '"') return end_of_string(text, i);
  const bool number = is_digit(c) || (c == '.' && i + 1 < text.size() && is_digit(text[i + 1]));
  ++i;
  if (c == '#') {
    while (i < text.size() && text[i] == ' ') ++i;
  }
  if (c != '#' && !is_word(c) && !number) return i;
  while (i < text.size() && (is_word(text[i]) || (number && text[i] == '.'))) ++i;
  return i;
}

// Beginnings and ends of what nests, and what has gone wrong elsewhere.
constexpr const char* kPhrases[] = {"#declare A_ =",
                                    "#local A_ =",
                                    "#macro M_ ( A_ )",
                                    "M_ ( A_ )",
                                    "#end",
                                    "#while ( 1 )",
                                    "#for ( I_ , 0 , 9 )",
                                    "#if ( 0 )",
                                    "#else",
                                    "#switch ( 1 ) #case ( 1 )",
                                    "#break",
                                    "array [ 2 ]",
                                    "array [ 2 ] { 1 , 2 }",
                                    "A_ [ 0 ]",
                                    "A_",
                                    "function { x + y }",
                                    "function ( a_ ) { a_ * 2 }",
                                    "spline { 0 , x 1 , y }",
                                    "#include \"colors.inc\"",
                                    "#fopen F_ \"f\" write",
                                    "#fopen F_ \"f\" read",
                                    "#write ( F_ , A_ )",
                                    "#read ( F_ , A_ )",
                                    "#fclose F_",
                                    "#undef A_",
                                    "#ifdef ( A_ )",
                                    "sphere { 0 , 1 }",
                                    "box { -1 , 1 }",
                                    "union { sphere { 0 , 1 } box { -1 , 1 } }",
                                    "object { A_ }",
                                    "texture { pigment { rgb 1 } }",
                                    "pigment { gradient x color_map { [ 0 rgb 1 ] [ 1 rgb 0 ] } }",
                                    "normal { bumps 1 }",
                                    "finish { phong 1 }",
                                    "interior { ior 1.5 }",
                                    "media { emission 1 }",
                                    "rotate x * 90",
                                    "scale 0",
                                    "translate y",
                                    "matrix < 1 , 0 , 0 , 0 , 1 , 0 , 0 , 0 , 1 , 0 , 0 , 0 >",
                                    "transform { inverse }",
                                    "rand ( seed ( 1 ) )",
                                    "concat ( \"a\" , str ( 1 , 0 , 0 ) )",
                                    "substr ( \"abc\" , 1 , 2 )",
                                    "trace ( A_ , x , y )",
                                    "inside ( A_ , 0 )",
                                    "min_extent ( A_ )",
                                    "#version 3.7 ;",
                                    "#version 2.0 ;",
                                    "#default { pigment { rgb 1 } }",
                                    "light_source { 0 , 1 }",
                                    "camera { location x look_at 0 }",
                                    "global_settings { assumed_gamma 1 }",
                                    "clipped_by { A_ }"};

constexpr const char* kNumbers[] = {
    "0",      "1",      "-1",         "2",          "0.5",         "3",          "4",
    "5",      "8",      "100",        "1e10",       "-1e10",       "1e-10",      "1e308",
    "-1e308", "1e-320", "2147483647", "2147483648", "-2147483649", "4294967296", "1e20",
    "(1/0)",  "(0/0)",  "65535",      "1e5"};

std::string joined(const std::vector<std::string>& pieces, std::size_t most) {
  std::string text;
  for (const std::string& piece : pieces) {
    if (text.size() + piece.size() + 1 > most) break;
    text += piece;
    text += piece == ";" || piece == "}" ? '\n' : ' ';
  }
  return text;
}

std::vector<std::string> copies(const std::vector<std::string_view>& pieces) {
  return {pieces.begin(), pieces.end()};
}

}  // namespace

std::vector<std::string_view> pieces_of(std::string_view text) {
  std::vector<std::string_view> pieces;
  for (std::size_t i = 0; i < text.size();) {
    if (std::isspace(static_cast<unsigned char>(text[i]))) {
      ++i;
      continue;
    }
    const std::size_t end = end_of_piece(text, i);
    pieces.push_back(text.substr(i, end - i));
    i = end;
  }
  return pieces;
}

Mutator::Range Mutator::some(const Pieces& pieces, std::size_t most) {
  const std::size_t begin = pick(pieces.size());
  return {begin, std::min(pieces.size(), begin + 1 + pick(most))};
}

// From a { to its }, with the word before it.
Mutator::Range Mutator::block(const Pieces& pieces) {
  const std::size_t start = pick(pieces.size());
  for (std::size_t n = 0; n < pieces.size(); ++n) {
    const std::size_t begin = (start + n) % pieces.size();
    if (pieces[begin] != "{") continue;
    std::size_t end = begin;
    for (int depth = 0; end < pieces.size(); ++end) {
      if (pieces[end] == "{") ++depth;
      if (pieces[end] == "}" && --depth == 0) break;
    }
    return {begin > 0 ? begin - 1 : 0, std::min(end + 1, pieces.size())};
  }
  return some(pieces, 8);
}

std::string Mutator::word() {
  const auto count = static_cast<std::size_t>(Keyword::kEndOfKeywords);
  return std::string(parser::spelling(static_cast<Keyword>(1 + pick(count - 1))));
}

std::string Mutator::number() { return kNumbers[pick(std::size(kNumbers))]; }

std::string Mutator::new_piece(const Pieces& pieces) {
  switch (pick(6)) {
    case 0: return word();
    case 1: return number();
    case 2:
      return std::string(
          parser::spelling(static_cast<Punct>(1 + pick(static_cast<std::size_t>(Punct::kHash)))));
    case 3: return kPhrases[pick(std::size(kPhrases))];
    case 4: return "#" + word();
    default: return pieces.empty() ? word() : pieces[pick(pieces.size())];
  }
}

void Mutator::insert(Pieces& pieces, std::size_t at, const Pieces& what) {
  pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(at), what.begin(), what.end());
}

void Mutator::change(Pieces& pieces) {
  if (pieces.empty()) return pieces.push_back(kPhrases[pick(std::size(kPhrases))]);
  const auto at = [&](std::size_t i) { return pieces.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto part = [&](const Range& r) { return Pieces(at(r.begin), at(r.end)); };
  switch (pick(11)) {
    case 0: {
      const Range r = some(pieces, 1 + pick(8));
      pieces.erase(at(r.begin), at(r.end));
      return;
    }
    case 1: {
      const Range r = block(pieces);
      pieces.erase(at(r.begin), at(r.end));
      return;
    }
    case 2: return insert(pieces, pick(pieces.size()), part(some(pieces, 1 + pick(16))));
    case 3: return insert(pieces, pick(pieces.size()), part(block(pieces)));
    case 4: {  // one block in the place of another
      const Pieces copy = part(block(pieces));
      const Range r = block(pieces);
      pieces.erase(at(r.begin), at(r.end));
      return insert(pieces, r.begin, copy);
    }
    case 5: return std::swap(pieces[pick(pieces.size())], pieces[pick(pieces.size())]);
    case 6:
    case 7: {  // another number
      const std::size_t start = pick(pieces.size());
      for (std::size_t n = 0; n < pieces.size(); ++n) {
        std::string& piece = pieces[(start + n) % pieces.size()];
        if (piece.empty() || !is_digit(piece[0])) continue;
        piece = number();
        return;
      }
      return;
    }
    case 8: pieces[pick(pieces.size())] = new_piece(pieces); return;
    case 9: return insert(pieces, pick(pieces.size()), {kPhrases[pick(std::size(kPhrases))]});
    default: return insert(pieces, pick(pieces.size() + 1), {new_piece(pieces)});
  }
}

std::string Mutator::mutate(std::string_view text, std::size_t most) {
  Pieces pieces = copies(pieces_of(text));
  for (std::size_t i = 0, n = 1 + pick(4); i < n; ++i) change(pieces);
  return joined(pieces, most);
}

std::string Mutator::cross(std::string_view a, std::string_view b, std::size_t most) {
  Pieces pieces = copies(pieces_of(a));
  const Pieces other = copies(pieces_of(b));
  if (other.empty()) return joined(pieces, most);
  const Range r = pick(2) ? block(other) : some(other, 60);
  insert(pieces, pick(pieces.size() + 1),
         {other.begin() + static_cast<std::ptrdiff_t>(r.begin),
          other.begin() + static_cast<std::ptrdiff_t>(r.end)});
  return joined(pieces, most);
}

}  // namespace lentray::test
