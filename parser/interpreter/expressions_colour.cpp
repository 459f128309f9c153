// Colours: `rgb 1`, `rgbft <..>`, `srgb <..>`, `color red 1 green .5`, `Red*0.5 filter .2` ...
#include "parser/base/gamma.h"
#include "parser/interpreter/interpreter.h"

namespace lentray::parser {
namespace {

bool is_vector_keyword(Keyword k) {
  switch (k) {
    case Keyword::kRgb:
    case Keyword::kRgbf:
    case Keyword::kRgbt:
    case Keyword::kRgbft:
    case Keyword::kSrgb:
    case Keyword::kSrgbf:
    case Keyword::kSrgbt:
    case Keyword::kSrgbft: return true;
    default: return false;
  }
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
         (t.keyword == Keyword::kColor || is_vector_keyword(t.keyword) ||
          component(t.keyword) >= 0);
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
Number Expressions::colour_from(Keyword keyword) {
  const bool filter = keyword == Keyword::kRgbf || keyword == Keyword::kSrgbf;
  const bool transmit = keyword == Keyword::kRgbt || keyword == Keyword::kSrgbt;
  const bool both = keyword == Keyword::kRgbft || keyword == Keyword::kSrgbft;
  const bool srgb = keyword == Keyword::kSrgb || keyword == Keyword::kSrgbf ||
                    keyword == Keyword::kSrgbt || keyword == Keyword::kSrgbft;
  const int size = both ? 5 : filter || transmit ? 4 : 3;
  if (srgb && !m_in.working_gamma) {
    m_in.fail(m_in.tokens.peek().where, "sRGB colours need an assumed_gamma before them");
  }
  Location where;
  Number n;
  m_script.located(n, Precedence::kLogical, where);
  if (n.size > size) {
    m_in.warn(where, "more components than the colour keyword before them takes");
  }
  promote(n, size);
  for (std::size_t i = static_cast<std::size_t>(n.size); i < 5; ++i) n.v[i] = 0.0;
  n.size = 5;
  if (transmit) {
    n.v[4] = n.v[3];
    n.v[3] = 0.0;
  }
  if (srgb) {
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
  if (first.kind == TokenKind::kKeyword && is_vector_keyword(first.keyword)) {
    tokens.skip();
    colour = colour_from(first.keyword);
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
