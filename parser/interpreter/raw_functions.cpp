// Constants and pure functions read straight from the token list.
#include "parser/interpreter/interpreter.h"
#include "parser/interpreter/raw_expressions.h"

namespace lentray::parser {

// Of a name without subscripts.
bool RawExpressions::defined(double& x) {
  if (!m_at[1].is(Punct::kLeftParen) || m_at[2].kind != TokenKind::kIdentifier ||
      !m_at[3].is(Punct::kRightParen)) {
    return false;
  }
  Symbol* symbol = m_in.symbols.find(m_at[2].name);
  x = symbol && symbol->is_set();
  m_at += 4;
  return true;
}

// At the keyword, whose value is a float if it is read at all.
bool RawExpressions::float_function(double& x) {
  const Keyword word = m_at->keyword;
  if (m_in.expressions.keyword_float(word, x)) {
    ++m_at;
    return true;
  }
  if (word == Keyword::kDefined) return defined(x);
  // There is a next token: a list ends with kEnd.
  if (!m_at[1].is(Punct::kLeftParen) || ++m_depth > kDeepest) return false;
  m_at += 2;
  if (!float_value(word, x)) return false;
  --m_depth;
  return accept(Punct::kRightParen);
}

// Its bracket has been read.
bool RawExpressions::float_value(Keyword function, double& x) {
  double other = 0.0;
  const FunctionWord& word = function_word(function);
  switch (word.kind) {
    case FunctionKind::kOneFloat:
      if (!argument(x) || !is_defined(word.op, x)) return false;
      x = core::apply(word.op, x, 0.0);
      return true;
    case FunctionKind::kTwoFloats:
      if (!argument(x)) return false;
      accept(Punct::kComma);
      if (!argument(other) || !is_defined(word.op, x, other)) return false;
      x = core::apply(word.op, x, other);
      return true;
    case FunctionKind::kFold:
      if (!argument(x)) return false;
      while (accept(Punct::kComma)) {
        if (!argument(other)) return false;
        x = core::apply(word.op, x, other);
      }
      return true;
    default: break;
  }
  core::Vec3 p, q;
  switch (function) {
    case Keyword::kRand: {
      if (!argument(x)) return false;
      const auto stream = static_cast<std::size_t>(to_int(x));
      if (stream >= m_in.random.size()) return false;
      m_random.emplace_back(stream, m_in.random[stream]);
      x = next_random(m_in.random[stream]);
      return true;
    }
    case Keyword::kVlength:
      if (!vector(p)) return false;
      x = core::length(p);
      return true;
    case Keyword::kVdot:
      if (!vector(p)) return false;
      accept(Punct::kComma);
      if (!vector(q)) return false;
      x = core::dot(p, q);
      return true;
    default: return false;
  }
}

bool RawExpressions::vector_function(Number& n) {
  const Keyword word = m_at->keyword;
  if (!m_at[1].is(Punct::kLeftParen) || ++m_depth > kDeepest) return false;
  m_at += 2;
  core::Vec3 p, q;
  if (!vector(p)) return false;
  if (word == Keyword::kVnormalize) {
    if (p == core::Vec3{}) return false;
    p = normalised(p);
  } else {
    accept(Punct::kComma);
    if (!vector(q)) return false;
    double degrees = 0.0;
    if (word == Keyword::kVaxisRotate) {
      accept(Punct::kComma);
      if (!scalar(degrees)) return false;
    }
    p = word == Keyword::kVcross    ? core::cross(p, q)
        : word == Keyword::kVrotate ? rotated(p, q)
                                    : rotated_about(p, q, degrees);
  }
  n = Number::vector(p);
  --m_depth;
  return accept(Punct::kRightParen);
}

}  // namespace lentray::parser
