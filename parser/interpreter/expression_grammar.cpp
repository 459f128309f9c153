#include "parser/interpreter/expression_grammar.h"

#include <algorithm>
#include <ctime>

#include "parser/base/text.h"
#include "parser/interpreter/plain_tokens.h"
#include "parser/interpreter/script_tokens.h"
#include "parser/tokens/keywords.h"
#include "parser/values/arithmetic.h"
#include "parser/values/float_functions.h"

namespace lentray::parser {

template <typename Tokens>
bool ExpressionGrammar<Tokens>::read(Number& n, Precedence least) {
  return m_tokens.quick(n, least) || (least == Precedence::kLogical ? choice(n) : binary(n, least));
}

template <typename Tokens>
bool ExpressionGrammar<Tokens>::located(Number& n, Precedence least, Location& where) {
  return m_tokens.quick(n, least, where) ||
         (least == Precedence::kLogical ? choice(n) : binary(n, least));
}

template <typename Tokens>
bool ExpressionGrammar<Tokens>::scalar(double& x, Precedence least) {
  if (m_tokens.quick(x, least)) return true;
  Number n;
  Location where;
  if (!located(n, least, where)) return false;
  if (n.size > 1) return m_tokens.fail(where, "expected a float but found a vector or colour");
  x = n.v[0];
  return true;
}

template <typename Tokens>
bool ExpressionGrammar<Tokens>::vector(core::Vec3& v) {
  Number n;
  Location where;
  if (!located(n, Precedence::kSum, where)) return false;
  if (n.size > 3) {
    return m_tokens.fail(where, "expected a vector of 3 components but found one of " +
                                    std::to_string(n.size) + (n.size == 5 ? " (a colour)" : ""));
  }
  v = to_vector(n);
  return true;
}

template <typename Tokens>
bool ExpressionGrammar<Tokens>::choice(Number& n) {
  const Location where = m_tokens.peek_operand().where;
  if (!binary(n, Precedence::kLogical)) return false;
  return !m_tokens.accept(Punct::kQuestion) || chosen(n, where);
}

// Behind `condition ?`.
template <typename Tokens>
bool ExpressionGrammar<Tokens>::chosen(Number& n, const Location& where) {
  if (n.size != 1) return m_tokens.fail(where, "the condition of ?: must be a float");
  Number yes, no;
  if (!m_tokens.enter() || !read(yes, Precedence::kLogical) || !m_tokens.expect(Punct::kColon) ||
      !read(no, Precedence::kLogical)) {
    return false;
  }
  m_tokens.leave();
  n = is_true(n.v[0]) ? yes : no;
  return true;
}

// An operand and the operators behind it. A comparison of strings is an operand of logical ones.
template <typename Tokens>
bool ExpressionGrammar<Tokens>::binary(Number& left, Precedence least) {
  if (least < Precedence::kComparison && m_tokens.at_string()) {
    if (!string_comparison(left.v[0])) return false;
    const Precedence next = m_tokens.precedence();
    return next != Precedence::kLogical || operators(left, next, least);
  }
  if (!next_operand(left)) return false;
  const Precedence next = m_tokens.precedence();
  return next < least || operators(left, next, least);
}

// At an operator that binds as closely as `next` says. None behind it that binds closer than one before.
template <typename Tokens>
bool ExpressionGrammar<Tokens>::operators(Number& left, Precedence next, Precedence least) {
  for (Precedence here = next; next >= least && next <= here;) {
    here = next;
    const Punct op = m_tokens.peek().punct;
    m_tokens.skip();
    Number right;
    if (here == Precedence::kLogical ? !binary(right, closer(here)) : !next_operand(right))
      return false;
    next = m_tokens.precedence();
    if (next > here && here != Precedence::kLogical) {
      if (!operators(right, next, closer(here))) return false;
      next = m_tokens.precedence();
    }
    if (!operate(op, left, right) && !m_tokens.warn(m_tokens.location(), "division by zero"))
      return false;
  }
  return true;
}

template <typename Tokens>
bool ExpressionGrammar<Tokens>::string_comparison(double& x) {
  std::string left, right;
  if (!string(left)) return false;
  const Token op = m_tokens.next();
  if (precedence(op) != Precedence::kComparison) {
    return m_tokens.fail(op.where, "expected a comparison (<, <=, =, !=, >=, >) after a string");
  }
  if (!string(right)) return false;
  x = left.compare(right);
  operate(op.punct, x, 0.0);
  return true;
}

template <typename Tokens>
bool ExpressionGrammar<Tokens>::operand(Number& n) {
  return next_operand(n);
}

template <typename Tokens>
bool ExpressionGrammar<Tokens>::next_operand(Number& n) {
  const Token& token = m_tokens.peek_operand();
  if (token.kind == TokenKind::kNumber) {
    n.v[0] = token.number;
    m_tokens.skip();
  } else if (token.kind == TokenKind::kIdentifier ? !m_tokens.identifier(n) : !primary(n)) {
    return false;
  }
  return !m_tokens.at(Punct::kDot) || member(n);
}

template <typename Tokens>
bool ExpressionGrammar<Tokens>::primary(Number& n) {
  if (!m_tokens.enter()) return false;
  const Token& token = m_tokens.peek_operand();
  bool read = false;
  switch (token.kind) {
    case TokenKind::kNumber:
      n.v[0] = token.number;
      m_tokens.skip();
      read = true;
      break;
    case TokenKind::kIdentifier: read = m_tokens.identifier(n); break;
    case TokenKind::kKeyword: read = keyword(n); break;
    case TokenKind::kPunct: read = prefixed(n, token.punct); break;
    default: read = m_tokens.fail_expected("a number, vector or identifier of one"); break;
  }
  m_tokens.leave();
  return read;
}

// At a bracket or a sign.
template <typename Tokens>
bool ExpressionGrammar<Tokens>::prefixed(Number& n, Punct sign) {
  if (sign == Punct::kLess) return vector_literal(n);
  const bool known = sign == Punct::kLeftParen || sign == Punct::kPlus || sign == Punct::kMinus ||
                     sign == Punct::kExclamation;
  if (!known) return m_tokens.fail_expected("a number, vector or identifier of one");
  m_tokens.skip();
  if (sign == Punct::kPlus) return primary(n);
  if (sign == Punct::kLeftParen) {
    if (!read(n, Precedence::kLogical)) return false;
    n.keeps_rest = false;
    return close();
  }
  if (!operand(n)) return false;
  if (sign == Punct::kMinus)
    negate(n);
  else
    logical_not(n);
  return true;
}

template <typename Tokens>
bool ExpressionGrammar<Tokens>::vector_literal(Number& n) {
  if (m_tokens.literal_vector(n)) return true;
  m_tokens.skip();
  m_tokens.open_vector();
  std::size_t size = 0;
  for (; !m_tokens.at(Punct::kGreater); comma()) {
    if (size == n.v.size()) return m_tokens.fail_expected("'>' after the 5 components of a vector");
    if (!scalar(n.v[size++])) return false;
  }
  if (size < 2) return m_tokens.fail_expected("at least 2 components in a vector");
  n.size = static_cast<int>(size);
  m_tokens.close_vector();
  m_tokens.skip();
  return true;
}

// .x .y .z .t .u .v and the names of colour components.
template <typename Tokens>
bool ExpressionGrammar<Tokens>::member(Number& n) {
  m_tokens.skip();
  const Token name = m_tokens.next();
  if (name.is(Keyword::kGray)) {
    if (n.size < 2) return m_tokens.fail(name.where, ".gray of a float");
    // The weights of stock.
    n = Number::scalar(0.297 * n.v[0] + 0.589 * n.v[1] + 0.114 * n.v[2]);
    return true;
  }
  const int i = name.kind == TokenKind::kKeyword ? component_of(name.keyword) : -1;
  if (i < 0) {
    return m_tokens.fail(name.where,
                         "expected x, y, z, t, u, v or a colour component after '.' but found " +
                             m_tokens.describe(name));
  }
  if (i >= n.size) {
    return m_tokens.fail(name.where, "." + std::string(m_tokens.name(name)) +
                                         " of something with " + std::to_string(n.size) +
                                         (n.size == 1 ? " component" : " components"));
  }
  take_component(n, i);
  return true;
}

// ---- what keywords stand for --------------------------------------------------------------------

template <typename Tokens>
bool ExpressionGrammar<Tokens>::keyword(Number& n) {
  const Keyword word = m_tokens.peek_operand().keyword;
  if (!starts_operand(word)) return m_tokens.fail_expected("a number, vector or identifier of one");
  m_tokens.skip();
  switch (function_kind(word)) {
    case FunctionKind::kOneFloat:
    case FunctionKind::kTwoFloats:
    case FunctionKind::kFold: return float_function(word, n);
    case FunctionKind::kUnitVector: return unit_vector(word, n);
    case FunctionKind::kVector: return vector_function(word, n);
    default: return m_tokens.keyword_float(word, n.v[0]) || function(word, n);
  }
}

// What to continue with, if at all.
template <typename Tokens>
bool ExpressionGrammar<Tokens>::outside_domain(Keyword function, double& x, const Location& where) {
  const std::string name(spelling(function));
  if (function == Keyword::kAcos || function == Keyword::kAsin) {
    x = std::clamp(x, -1.0, 1.0);
    return m_tokens.warn(where, "domain error in " + name);
  }
  return m_tokens.fail(where,
                       name + (function == Keyword::kSqrt ? " of the negative number " : " of ") +
                           std::to_string(x));
}

// Functions of floats alone; like those below, the keyword has been read.
template <typename Tokens>
bool ExpressionGrammar<Tokens>::float_function(Keyword word, Number& n) {
  const Location where = m_tokens.location();
  const FunctionWord& of = function_word(word);
  double& a = n.v[0];
  double b = 0.0;
  if (!open() || !argument(a)) return false;
  switch (of.kind) {
    case FunctionKind::kOneFloat:
      if (!close() || (!is_defined(of.op, a) && !outside_domain(word, a, where))) return false;
      a = core::apply(of.op, a, 0.0);
      return true;
    case FunctionKind::kTwoFloats:
      if (!comma() || !argument(b) || !close()) return false;
      if (!is_defined(of.op, a, b))
        return m_tokens.fail(where, std::string(spelling(word)) + "(0, 0) is not defined");
      a = core::apply(of.op, a, b);
      return true;
    default:
      while (m_tokens.accept(Punct::kComma)) {
        if (!argument(b)) return false;
        a = core::apply(of.op, a, b);
      }
      return close();
  }
}

template <typename Tokens>
bool ExpressionGrammar<Tokens>::vector_function(Keyword word, Number& n) {
  const Location where = m_tokens.location();
  core::Vec3 a, b, unnormalised;
  double degrees = 0.0;
  if (!open()) return false;
  switch (word) {
    case Keyword::kVcross:
    case Keyword::kVrotate:
      if (!two_vectors(a, b)) return false;
      a = word == Keyword::kVcross ? core::cross(a, b) : rotated(a, b);
      break;
    case Keyword::kVaxisRotate:
      if (!two_vectors(a, b) || !comma() || !scalar(degrees)) return false;
      a = rotated_about(a, b, degrees);
      break;
    default:
      if (!vector(a)) return false;
      unnormalised = a;
      a = normalised(a);
  }
  n = Number::vector(a);
  if (!close()) return false;
  return word != Keyword::kVnormalize || unnormalised != core::Vec3{} || m_tokens.old_dialect() ||
         m_tokens.warn(where, "vnormalize() of a vector of length zero");
}

template <typename Tokens>
bool ExpressionGrammar<Tokens>::function(Keyword word, Number& n) {
  double& x = n.v[0];
  core::Vec3 a, b;
  switch (word) {
    case Keyword::kSelect: {
      double negative = 0.0, zero = 0.0, positive = 0.0;
      if (!open() || !argument(x) || !comma() || !argument(negative) || !comma() || !argument(zero))
        return false;
      positive = zero;
      if (m_tokens.accept(Punct::kComma) && !argument(positive)) return false;
      x = x < 0.0 ? negative : x == 0.0 ? zero : positive;
      return close();
    }
    case Keyword::kRand: return open() && argument(x) && close() && m_tokens.random(x, x);
    case Keyword::kVlength:
      if (!open() || !vector(a)) return false;
      x = core::length(a);
      return close();
    case Keyword::kVdot:
      if (!open() || !two_vectors(a, b)) return false;
      x = core::dot(a, b);
      return close();
    case Keyword::kVal:
    case Keyword::kAsc:
    case Keyword::kStrlen:
    case Keyword::kStrcmp: return open() && text_measure(word, x) && close();
    default: return m_tokens.function(word, n);
  }
}

// Numbers that strings stand for. The bracket has been read.
template <typename Tokens>
bool ExpressionGrammar<Tokens>::text_measure(Keyword word, double& x) {
  std::string text, other;
  if (!string(text)) return false;
  switch (word) {
    case Keyword::kVal: x = std::strtod(text.c_str(), nullptr); return true;
    case Keyword::kAsc: x = first_character(text); return true;
    case Keyword::kStrlen: x = static_cast<double>(count_characters(text)); return true;
    default:
      if (!comma() || !string(other)) return false;
      x = character_difference(text, other);
      return true;
  }
}

// ---- strings ------------------------------------------------------------------------------------

template <typename Tokens>
bool ExpressionGrammar<Tokens>::string(std::string& text, bool path) {
  if (!path && m_tokens.quick(text)) return true;
  const Token& token = m_tokens.peek_operand();
  if (token.kind == TokenKind::kString) return m_tokens.literal(text, path);
  if (token.kind == TokenKind::kIdentifier) return m_tokens.identifier(text);
  const Keyword word = token.keyword;
  if (token.kind != TokenKind::kKeyword || function_kind(word) != FunctionKind::kString)
    return m_tokens.fail_expected("a string");
  if (!m_tokens.enter()) return false;
  m_tokens.skip();
  if (!open() || !string_function(word, text, path)) return false;
  m_tokens.leave();
  return close();
}

// What a number is printed with: width (negative: zeros in front) and digits, as str() takes them.
template <typename Tokens>
bool ExpressionGrammar<Tokens>::number_format(NumberFormat& format) {
  double width = 0.0, digits = 0.0;
  if (!comma() || !scalar(width) || !comma() || !scalar(digits)) return false;
  format = number_format_of(width, digits);
  return true;
}

// Its bracket has been read.
template <typename Tokens>
bool ExpressionGrammar<Tokens>::string_function(Keyword word, std::string& text, bool path) {
  const Location where = m_tokens.location();
  double x = 0.0, y = 0.0;
  NumberFormat format;
  switch (word) {
    case Keyword::kStr:
      if (!argument(x) || !number_format(format)) return false;
      append_fixed(text, format, x);
      return true;
    case Keyword::kVstr: {
      Number n;
      std::string part;
      if (!scalar(x) || !comma() || !read(n, Precedence::kSum) || !comma() || !string(part, path) ||
          !number_format(format)) {
        return false;
      }
      append_vector(text, n, vector_text_size(x), part, format);
      return true;
    }
    case Keyword::kConcat:
      if (!string(text, path)) return false;
      while (!m_tokens.at(Punct::kRightParen)) {
        if (!comma() || !string(text, path)) return false;
        if (text.size() > m_tokens.most_bytes()) {
          return m_tokens.fail(where, "concat() makes a string of " + std::to_string(text.size()) +
                                          " bytes, the limit is " +
                                          std::to_string(m_tokens.most_bytes()));
        }
      }
      return true;
    case Keyword::kChr:
      if (!argument(x)) return false;
      if (!is_character(x))
        return m_tokens.fail(where, "chr() takes 0 to 65535, not " + std::to_string(x));
      text += encode_character(static_cast<unsigned>(x));
      return true;
    case Keyword::kSubstr: {
      std::string part;
      if (!string(part, path) || !comma() || !scalar(x) || !comma() || !scalar(y)) return false;
      return append_substring(text, part, x, y) ||
             m_tokens.fail(where, "substr() of " + std::to_string(core::to_int(y)) +
                                      " characters from " + std::to_string(core::to_int(x)) +
                                      " in a string of " + std::to_string(count_characters(part)));
    }
    case Keyword::kStrupr:
    case Keyword::kStrlwr: {
      const std::size_t start = text.size();
      if (!string(text, path)) return false;
      change_case(text, start, word == Keyword::kStrupr);
      return true;
    }
    default: {  // datetime (days since 2000 [, format])
      if (!argument(x)) return false;
      std::string pattern;
      if (!m_tokens.accept(Punct::kComma))
        pattern = "%Y-%m-%d %H:%M:%SZ";
      else if (!string(pattern, path))
        return false;
      // Beyond these no year can be named.
      constexpr double kLast = 1e16;
      const double seconds = x * 86400.0 + 946684800.5;
      const auto time = static_cast<std::time_t>(seconds > -kLast && seconds < kLast ? seconds : 0);
      std::tm parts{};
      gmtime_r(&time, &parts);
      char date[256];
      if (pattern.empty() || std::strftime(date, sizeof date, pattern.c_str(), &parts) == 0)
        return m_tokens.fail(where, "datetime() cannot use the format \"" + pattern + "\"");
      text += date;
      return true;
    }
  }
}

template class ExpressionGrammar<PlainTokens>;
template class ExpressionGrammar<ScriptTokens>;

}  // namespace lentray::parser
