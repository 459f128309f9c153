// Strings read straight from the token list.
#include "parser/base/text.h"
#include "parser/interpreter/interpreter.h"
#include "parser/interpreter/raw_expressions.h"

namespace lentray::parser {

bool RawExpressions::read_whole(const TokenList& list, const Token*& first, std::string& text,
                                Punct end) {
  if (m_failed_string.within(first)) return false;
  m_list = &list;
  m_at = first;
  m_depth = 0;
  m_operands_left = kMostOperands;
  const std::size_t before = text.size();
  // What follows a string can be no part of it, so it may be anything.
  if (string(text) && (end == Punct::kNone || is(end))) {
    if (!m_random.empty()) m_random.clear();
    first = m_at;
    return true;
  }
  m_failed_string = {first, m_at};
  text.resize(before);
  undo_random();
  return false;
}

bool RawExpressions::string(std::string& text) {
  switch (m_at->kind) {
    case TokenKind::kString: return string_literal(text);
    case TokenKind::kIdentifier: return string_identifier(text);
    case TokenKind::kKeyword: break;
    default: return false;
  }
  const Keyword function = m_at->keyword;
  if (!m_at[1].is(Punct::kLeftParen) || ++m_depth > kDeepest) return false;
  m_at += 2;
  if (!string_function(function, text)) return false;
  --m_depth;
  return accept(Punct::kRightParen);
}

// What is wrong or replaced in it is the grammar's to say.
bool RawExpressions::string_literal(std::string& text) {
  const std::string* plain = m_names.ascii_alone(m_at->name);
  if (!plain || m_at->keyword == Keyword::kError) return false;
  text += *plain;
  ++m_at;
  return true;
}

bool RawExpressions::string_identifier(std::string& text) {
  const Value* value = identifier_value();
  const std::string* held = value ? std::get_if<std::string>(value) : nullptr;
  if (held) text += *held;
  return held;
}

// A string that must not stand behind another yet.
bool RawExpressions::part_of_string(std::string& text) {
  text.clear();
  return string(text);
}

bool RawExpressions::number_format(NumberFormat& format) {
  double width = 0.0, digits = 0.0;
  accept(Punct::kComma);
  if (!scalar(width)) return false;
  accept(Punct::kComma);
  if (!scalar(digits)) return false;
  format = number_format_of(width, digits);
  return true;
}

// vstr: its bracket has been read.
bool RawExpressions::vector_text(std::string& text) {
  double wanted = 0.0;
  Number n;
  if (!scalar(wanted)) return false;
  const int count = vector_text_size(wanted);
  accept(Punct::kComma);
  if (!lone_operand(n) && !additive(n)) return false;
  accept(Punct::kComma);
  std::string separator;
  NumberFormat format;
  if (!part_of_string(separator) || !number_format(format)) return false;
  append_vector(text, n, count, separator, format);
  return true;
}

// Its bracket has been read.
bool RawExpressions::string_function(Keyword function, std::string& text) {
  double x = 0.0, y = 0.0;
  NumberFormat format;
  switch (function) {
    case Keyword::kStr:
      if (!argument(x) || !number_format(format)) return false;
      append_fixed(text, format, x);
      return true;
    case Keyword::kVstr: return vector_text(text);
    case Keyword::kConcat:
      if (!string(text)) return false;
      while (!is(Punct::kRightParen)) {
        accept(Punct::kComma);
        if (!string(text) || text.size() > m_in.options.limits.string_bytes) return false;
      }
      return true;
    case Keyword::kChr:
      if (!argument(x) || !is_character(x)) return false;
      text += encode_character(static_cast<unsigned>(x));
      return true;
    case Keyword::kSubstr: {
      std::string whole;
      if (!part_of_string(whole)) return false;
      accept(Punct::kComma);
      if (!scalar(x)) return false;
      accept(Punct::kComma);
      return scalar(y) && append_substring(text, whole, x, y);
    }
    case Keyword::kStrupr:
    case Keyword::kStrlwr: {
      const std::size_t start = text.size();
      if (!string(text)) return false;
      change_case(text, start, function == Keyword::kStrupr);
      return true;
    }
    default: return false;
  }
}

}  // namespace lentray::parser
