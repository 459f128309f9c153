// String expressions. Strings are bytes; what counts characters takes them for UTF-8.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include "parser/interpreter.h"
#include "parser/text.h"

namespace lentray::parser {

bool Expressions::at_string() {
  const Token& t = m_in.tokens.peek_operand();
  switch (t.kind) {
    case TokenKind::kString: return true;
    case TokenKind::kKeyword:
      switch (t.keyword) {
        case Keyword::kStr: case Keyword::kVstr: case Keyword::kConcat: case Keyword::kChr:
        case Keyword::kDatetime: case Keyword::kSubstr: case Keyword::kStrupr:
        case Keyword::kStrlwr: return true;
        default: return false;
      }
    case TokenKind::kIdentifier: {
      const Value* value = m_in.tokens.value();
      return value && std::holds_alternative<std::string>(*value);
    }
    default: return false;
  }
}

std::string Expressions::parse_string() { return one_string(false); }
std::string Expressions::parse_path() { return one_string(true); }

std::string Expressions::one_string(bool path) {
  std::string text;
  append_string(text, path);
  return text;
}

void Expressions::append_string(std::string& text, bool path) {
  m_in.guard_stack();
  TokenReader& tokens = m_in.tokens;
  const Token t = tokens.peek_operand();
  if (t.kind == TokenKind::kString) {
    tokens.skip();
    text += path ? m_in.names.raw_string(t.name) : literal(t);
    return;
  }
  if (!at_string()) tokens.fail_expected("a string");
  if (t.kind == TokenKind::kIdentifier) {
    text += std::get<std::string>(*tokens.value());
    tokens.skip();
    return;
  }
  tokens.skip();
  tokens.expect(Punct::kLeftParen);
  append_function(text, t.keyword, path);
  tokens.expect(Punct::kRightParen);
}

const std::string& Expressions::literal(const Token& t) {
  if (t.keyword == Keyword::kError) {
    m_in.fail(t.where, "a string has an escape that does not exist; known are \\a \\b \\f \\n \\r "
                       "\\t \\v \\\\ \\\" \\' \\uXXXX");
  }
  const std::string* ascii = m_in.names.ascii_string(t.name);
  if (!ascii || m_in.utf8) return m_in.names.string(t.name);
  m_in.warn(t.where, "text that is not ASCII, replaced by spaces; charset utf8 keeps it");
  return *ascii;
}

// What a number is printed with: width (negative: zeros in front) and digits, as str() takes them.
Expressions::NumberFormat Expressions::number_format() {
  m_in.tokens.comma();
  // Longer than any text they are printed into is as good as longest.
  constexpr double kLongest = 1000.0;
  const int width = to_int(std::clamp(parse_float(), -kLongest, kLongest));
  m_in.tokens.comma();
  const int digits = to_int(std::clamp(parse_float(), -1.0, kLongest));
  constexpr int kUsual = 6;
  return {std::abs(width), digits < 0 ? kUsual : digits, width < 0};
}

// As printf's %f. Numbers too long for the buffer come in exponents (%g), as in stock.
void Expressions::append_number(std::string& text, const NumberFormat& format, double value) {
  char digits[256];
  constexpr int kLongest = 200;
  const auto width = static_cast<std::size_t>(format.width);
  const auto append = [&](std::string_view number) {
    const std::size_t missing = width > number.size() ? width - number.size() : 0;
    if (missing > 0 && format.zeros && number[0] == '-') {
      text += '-';
      number.remove_prefix(1);
    }
    if (missing > 0) text.append(missing, format.zeros ? '0' : ' ');
    text += number;
  };
  if (format.width < kLongest && format.digits < kLongest) {
    std::string whole;
    if (append_whole(whole, value)) {
      if (format.digits > 0) {
        whole.append(1, '.').append(static_cast<std::size_t>(format.digits), '0');
      }
      return append(whole);
    }
  }
  if (std::isfinite(value) && width < sizeof digits) {
    const auto end = std::to_chars(digits, digits + sizeof digits - 1, value,
                                   std::chars_format::fixed, format.digits);
    if (end.ec == std::errc()) {
      return append({digits, static_cast<std::size_t>(end.ptr - digits)});
    }
  }
  const auto print = [&](char kind) {
    const std::string how = std::string(format.zeros ? "%0*.*" : "%*.*") + kind;
    return std::snprintf(digits, sizeof digits, how.c_str(), format.width, format.digits, value);
  };
  const int length = print('f');
  if (length < 0 || length >= static_cast<int>(sizeof digits)) print('g');
  text += digits;
}

// Of a string function, `(` consumed; its text is put behind `text`.
void Expressions::append_function(std::string& text, Keyword keyword, bool path) {
  TokenReader& tokens = m_in.tokens;
  const Location where = tokens.location();
  switch (keyword) {
    case Keyword::kStr: {
      const double value = parse_scalar_expression();
      append_number(text, number_format(), value);
      return;
    }
    case Keyword::kVstr: {
      const int count = std::clamp(to_int(parse_float()), 2, 5);
      tokens.comma();
      const Number n = parse_additive();
      tokens.comma();
      const std::string separator = one_string(path);
      const NumberFormat format = number_format();
      for (int i = 0; i < count; ++i) {
        const double value = i < n.size ? n.v[static_cast<std::size_t>(i)] : 0.0;
        if (i) text += separator;
        append_number(text, format, value);
      }
      return;
    }
    case Keyword::kConcat: {
      append_string(text, path);
      while (!tokens.at(Punct::kRightParen)) {
        tokens.comma();
        append_string(text, path);
        if (text.size() > m_in.options.limits.string_bytes) {
          m_in.fail(where, "concat() makes a string of " + std::to_string(text.size()) +
                               " bytes, the limit is " +
                               std::to_string(m_in.options.limits.string_bytes));
        }
      }
      return;
    }
    case Keyword::kChr: {
      const double code = parse_scalar_expression();
      if (!(code >= 0.0 && code < 65536.0)) {
        m_in.fail(where, "chr() takes 0 to 65535, not " + std::to_string(code));
      }
      text += encode_character(static_cast<unsigned>(code));
      return;
    }
    case Keyword::kSubstr: {
      const std::string whole = one_string(path);
      tokens.comma();
      const double first = std::trunc(parse_float());
      tokens.comma();
      const double count = std::trunc(parse_float());
      const std::size_t length = count_characters(whole);
      if (!(first >= 1.0 && count >= 0.0 && first + count - 1.0 <= static_cast<double>(length))) {
        m_in.fail(where, "substr() of " + std::to_string(to_int(count)) + " characters from " +
                             std::to_string(to_int(first)) + " in a string of " +
                             std::to_string(length));
      }
      text += substring(whole, static_cast<std::size_t>(first - 1), static_cast<std::size_t>(count));
      return;
    }
    case Keyword::kStrupr: case Keyword::kStrlwr: {
      const std::size_t start = text.size();
      append_string(text, path);
      for (std::size_t i = start; i < text.size(); ++i) {
        char& c = text[i];
        if (keyword == Keyword::kStrupr && c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
        if (keyword == Keyword::kStrlwr && c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
      }
      return;
    }
    default: {  // datetime (days since 2000 [, format])
      const double days = parse_scalar_expression();
      std::string format = "%Y-%m-%d %H:%M:%SZ";
      if (tokens.accept(Punct::kComma)) format = one_string(path);
      // Beyond these no year can be named.
      constexpr double kLast = 1e16;
      const double seconds = days * 86400.0 + 946684800.5;
      const auto time = static_cast<std::time_t>(seconds > -kLast && seconds < kLast ? seconds : 0);
      std::tm parts{};
      gmtime_r(&time, &parts);
      char date[256];
      if (format.empty() || std::strftime(date, sizeof date, format.c_str(), &parts) == 0) {
        m_in.fail(where, "datetime() cannot use the format \"" + format + "\"");
      }
      text += date;
    }
  }
}

}  // namespace lentray::parser
