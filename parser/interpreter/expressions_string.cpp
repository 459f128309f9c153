// String expressions. Strings are bytes; what counts characters takes them for UTF-8.
#include <cmath>
#include <ctime>

#include "parser/base/text.h"
#include "parser/interpreter/interpreter.h"

namespace lentray::parser {

bool Expressions::at_string() {
  const Token& t = m_in.tokens.peek_operand();
  switch (t.kind) {
    case TokenKind::kString: return true;
    case TokenKind::kKeyword: return function_kind(t.keyword) == FunctionKind::kString;
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
  if (!path && read_raw_string(text)) return;
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
    m_in.fail(t.where,
              "a string has an escape that does not exist; known are \\a \\b \\f \\n \\r "
              "\\t \\v \\\\ \\\" \\' \\uXXXX");
  }
  const std::string* ascii = m_in.names.ascii_string(t.name);
  if (!ascii || m_in.utf8) return m_in.names.string(t.name);
  m_in.warn(t.where, "text that is not ASCII, replaced by spaces; charset utf8 keeps it");
  return *ascii;
}

// What a number is printed with: width (negative: zeros in front) and digits, as str() takes them.
NumberFormat Expressions::number_format() {
  m_in.tokens.comma();
  const double width = parse_float();
  m_in.tokens.comma();
  return number_format_of(width, parse_float());
}

// Of a string function, `(` consumed; its text is put behind `text`.
void Expressions::append_function(std::string& text, Keyword keyword, bool path) {
  TokenReader& tokens = m_in.tokens;
  const Location where = tokens.location();
  switch (keyword) {
    case Keyword::kStr: {
      const double value = parse_scalar_expression();
      append_fixed(text, number_format(), value);
      return;
    }
    case Keyword::kVstr: {
      const int count = vector_text_size(parse_float());
      tokens.comma();
      const Number n = parse_additive();
      tokens.comma();
      const std::string separator = one_string(path);
      const NumberFormat format = number_format();
      append_vector(text, n, count, separator, format);
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
      if (!is_character(code)) {
        m_in.fail(where, "chr() takes 0 to 65535, not " + std::to_string(code));
      }
      text += encode_character(static_cast<unsigned>(code));
      return;
    }
    case Keyword::kSubstr: {
      const std::string whole = one_string(path);
      tokens.comma();
      const double first = parse_float();
      tokens.comma();
      const double count = parse_float();
      if (!append_substring(text, whole, first, count)) {
        m_in.fail(where, "substr() of " + std::to_string(to_int(count)) + " characters from " +
                             std::to_string(to_int(first)) + " in a string of " +
                             std::to_string(count_characters(whole)));
      }
      return;
    }
    case Keyword::kStrupr:
    case Keyword::kStrlwr: {
      const std::size_t start = text.size();
      append_string(text, path);
      change_case(text, start, keyword == Keyword::kStrupr);
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
