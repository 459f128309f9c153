// Colours: `rgb 1`, `rgbft <..>`, `srgb <..>`, `color red 1 green .5`, `Red*0.5 filter .2` ...
#include <algorithm>

#include "parser/base/gamma.h"
#include "parser/interpreter/interpreter.h"

namespace lentray::parser {

/// What is behind a keyword: r, g, b and as many more.
struct ColourWord {
  Keyword keyword;
  int size;
  bool is_srgb = false, has_transmit_alone = false;
};
namespace {

constexpr ColourWord kColourWords[] = {{Keyword::kRgb, 3},
                                       {Keyword::kRgbf, 4},
                                       {Keyword::kRgbt, 4, false, true},
                                       {Keyword::kRgbft, 5},
                                       {Keyword::kSrgb, 3, true},
                                       {Keyword::kSrgbf, 4, true},
                                       {Keyword::kSrgbt, 4, true, true},
                                       {Keyword::kSrgbft, 5, true}};

/// Null if it is none.
const ColourWord* colour_word(const Token& token) {
  const auto* found =
      std::ranges::find_if(kColourWords, [&](const ColourWord& w) { return token.is(w.keyword); });
  return found != std::end(kColourWords) ? found : nullptr;
}

int component(Keyword k) {
  switch (k) {
    case Keyword::kRed: return 0;
    case Keyword::kGreen: return 1;
    case Keyword::kBlue: return 2;
    case Keyword::kFilter:
    case Keyword::kAlpha: return 3;
    case Keyword::kTransmit: return 4;
    default: return -1;
  }
}

}  // namespace

bool Expressions::at_colour_keyword() {
  const Token& t = m_in.tokens.peek();
  return t.kind == TokenKind::kKeyword &&
         (t.keyword == Keyword::kColor || colour_word(t) || component(t.keyword) >= 0);
}

bool Expressions::at_colour() {
  if (at_colour_keyword()) return true;
  const Token& t = m_in.tokens.peek();
  if (t.is(Punct::kLess)) return true;
  if (t.kind != TokenKind::kIdentifier) return false;
  const Value* value = m_in.tokens.value();
  const Number* n = value ? std::get_if<Number>(value) : nullptr;
  return n && n->size >= 3;
}

// After rgb, rgbf ...
Number Expressions::colour_from(const ColourWord& word) {
  if (word.is_srgb && !m_in.working_gamma) {
    m_in.fail(m_in.tokens.peek().where, "sRGB colours need an assumed_gamma before them");
  }
  Location where;
  Number n;
  m_script.located(n, Precedence::kLogical, where);
  if (n.size > word.size) {
    m_in.warn(where, "more components than the colour keyword before them takes");
  }
  promote(n, word.size);
  for (std::size_t i = static_cast<std::size_t>(n.size); i < 5; ++i) n.v[i] = 0.0;
  n.size = 5;
  if (word.has_transmit_alone) {
    n.v[4] = n.v[3];
    n.v[3] = 0.0;
  }
  if (word.is_srgb) {
    const Gamma working = Gamma::of(*m_in.working_gamma);
    for (std::size_t i = 0; i < 3; ++i)
      n.v[i] = Gamma::srgb().recoded(static_cast<float>(n.v[i]), working);
  }
  return n;
}

// `filter .5 transmit .2` after a colour, or the whole of one.
void Expressions::trailing_components(Number& colour) {
  for (;;) {
    const Token& t = m_in.tokens.peek();
    const int i = t.kind == TokenKind::kKeyword ? component(t.keyword) : -1;
    if (i < 0) return;
    if (t.keyword == Keyword::kAlpha && m_in.version >= 155)
      m_in.warn(t.where, "alpha is filter now");
    m_in.tokens.skip();
    colour.v[static_cast<std::size_t>(i)] = parse_float();
  }
}

Number Expressions::parse_colour() {
  TokenReader& tokens = m_in.tokens;
  const bool announced = tokens.accept(Keyword::kColor);
  const Token first = tokens.peek_operand();
  Number colour;
  colour.size = 5;
  if (const ColourWord* word = colour_word(first)) {
    tokens.skip();
    colour = colour_from(*word);
  } else if (first.kind == TokenKind::kKeyword && component(first.keyword) >= 0) {
    // read below
  } else if (at_expression()) {
    colour = parse_expression();
    promote(colour, 5);
  } else if (!announced) {
    tokens.fail_expected("a colour");
  }
  trailing_components(colour);
  return stored(colour);
}

}  // namespace lentray::parser
