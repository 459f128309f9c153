// The float functions and constants of the language.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "parser/base/text.h"
#include "parser/interpreter/interpreter.h"
#include "parser/tokens/keywords.h"

namespace lentray::parser {

bool Expressions::keyword_float(Keyword keyword, double& value) {
  switch (keyword) {
    case Keyword::kPi: value = std::numbers::pi; return true;
    case Keyword::kTrue:
    case Keyword::kYes:
    case Keyword::kOn: value = 1.0; return true;
    case Keyword::kFalse:
    case Keyword::kNo:
    case Keyword::kOff: value = 0.0; return true;
    case Keyword::kClock:
      m_in.reads.clock = true;
      value = m_in.options.frame.clock;
      return true;
    case Keyword::kClockOn:
      m_in.reads.clock = true;
      value = m_in.options.frame.clock_on ? 1.0 : 0.0;
      return true;
    case Keyword::kVersion: value = m_in.version / 100.0; return true;
    case Keyword::kNow: {
      // Days since the year 2000 began.
      constexpr double kSecondsTo2000 = 946684800.0;
      const auto since = std::chrono::system_clock::now().time_since_epoch();
      value = (std::chrono::duration<double>(since).count() - kSecondsTo2000) / 86400.0;
      return true;
    }
    default: return false;
  }
}

double Expressions::float_argument() {
  m_in.tokens.expect(Punct::kLeftParen);
  const double x = parse_scalar_expression();
  m_in.tokens.expect(Punct::kRightParen);
  return x;
}

std::array<double, 2> Expressions::two_floats() {
  m_in.tokens.expect(Punct::kLeftParen);
  const double a = parse_scalar_expression();
  m_in.tokens.comma();
  const double b = parse_scalar_expression();
  m_in.tokens.expect(Punct::kRightParen);
  return {a, b};
}

double Expressions::folded(core::FunctionOp op) {
  m_in.tokens.expect(Punct::kLeftParen);
  double x = parse_scalar_expression();
  while (m_in.tokens.accept(Punct::kComma)) x = core::apply(op, x, parse_scalar_expression());
  m_in.tokens.expect(Punct::kRightParen);
  return x;
}

double Expressions::select() {
  m_in.tokens.expect(Punct::kLeftParen);
  const double x = parse_scalar_expression();
  m_in.tokens.comma();
  const double negative = parse_scalar_expression();
  m_in.tokens.comma();
  const double zero = parse_scalar_expression();
  const bool three = m_in.tokens.accept(Punct::kComma);
  const double positive = three ? parse_scalar_expression() : zero;
  m_in.tokens.expect(Punct::kRightParen);
  return x < 0.0 ? negative : x == 0.0 ? zero : positive;
}

double Expressions::random(double stream) {
  const int index = to_int(stream);
  if (index < 0 || static_cast<std::size_t>(index) >= m_in.random.size()) {
    m_in.fail(m_in.tokens.location(), "rand() of a stream that no seed() has made");
  }
  return next_random(m_in.random[static_cast<std::size_t>(index)]);
}

double Expressions::array_dimension(bool size) {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Punct::kLeftParen);
  const Value* value =
      tokens.peek_operand().kind == TokenKind::kIdentifier ? tokens.value() : nullptr;
  const auto* found = value ? std::get_if<std::shared_ptr<ArrayValue>>(value) : nullptr;
  if (!found) tokens.fail_expected("the identifier of an array");
  const std::shared_ptr<ArrayValue> array = *found;
  tokens.skip();
  double result = static_cast<double>(array->sizes.size());
  if (size) {
    tokens.comma();
    const double which = parse_float();
    if (which >= 1.0 && which < static_cast<double>(array->sizes.size() + 1)) {
      result = array->sizes[static_cast<std::size_t>(which) - 1];
    } else {
      m_in.warn(tokens.location(), "size of dimension " + std::to_string(to_int(which)) +
                                       " of an array that has " +
                                       std::to_string(array->sizes.size()));
      result = 0.0;
    }
  }
  tokens.expect(Punct::kRightParen);
  return result;
}

// What to continue with, if at all.
double Expressions::outside_domain(Keyword function, double x, const Location& where) {
  const std::string name(spelling(function));
  if (function == Keyword::kAcos || function == Keyword::kAsin) {
    m_in.warn(where, "domain error in " + name);
    return std::clamp(x, -1.0, 1.0);
  }
  if (function == Keyword::kSqrt) {
    m_in.fail(where, "sqrt of the negative number " + std::to_string(x));
  }
  m_in.fail(where, name + " of " + std::to_string(x));
}

// After the keyword. False if it is no float function.
bool Expressions::float_function(Keyword keyword, double& value) {
  const Location where = m_in.tokens.location();
  const FunctionWord& word = function_word(keyword);
  if (word.kind == FunctionKind::kOneFloat) {
    double x = float_argument();
    if (!is_defined(word.op, x)) x = outside_domain(keyword, x, where);
    value = core::apply(word.op, x, 0.0);
    return true;
  }
  if (word.kind == FunctionKind::kTwoFloats) {
    const auto [a, b] = two_floats();
    if (!is_defined(word.op, a, b)) {
      m_in.fail(where, std::string(spelling(keyword)) + "(0, 0) is not defined");
    }
    value = core::apply(word.op, a, b);
    return true;
  }
  if (word.kind == FunctionKind::kFold) {
    value = folded(word.op);
    return true;
  }
  switch (keyword) {
    case Keyword::kSelect: value = select(); return true;
    case Keyword::kRand: value = random(float_argument()); return true;
    case Keyword::kSeed:
      m_in.random.push_back(static_cast<std::uint32_t>(to_int(float_argument())));
      value = static_cast<double>(m_in.random.size() - 1);
      return true;
    case Keyword::kDefined: value = m_in.directives.parse_defined(); return true;
    case Keyword::kDimensions: value = array_dimension(false); return true;
    case Keyword::kDimensionSize: value = array_dimension(true); return true;
    case Keyword::kVal:
    case Keyword::kAsc:
    case Keyword::kStrlen:
    case Keyword::kFileExists: {
      m_in.tokens.expect(Punct::kLeftParen);
      const Location named = m_in.tokens.peek_operand().where;
      const std::string text = keyword == Keyword::kFileExists ? parse_path() : parse_string();
      m_in.tokens.expect(Punct::kRightParen);
      if (keyword == Keyword::kVal)
        value = std::strtod(text.c_str(), nullptr);
      else if (keyword == Keyword::kFileExists)
        value = text.empty() || m_in.find_exactly(text, named) ? 1.0 : 0.0;
      else if (keyword == Keyword::kAsc)
        value = first_character(text);
      else
        value = static_cast<double>(count_characters(text));
      return true;
    }
    case Keyword::kStrcmp: {
      m_in.tokens.expect(Punct::kLeftParen);
      const std::string a = parse_string();
      m_in.tokens.comma();
      value = character_difference(a, parse_string());
      m_in.tokens.expect(Punct::kRightParen);
      return true;
    }
    case Keyword::kVdot:
    case Keyword::kInside: {
      m_in.tokens.expect(Punct::kLeftParen);
      if (keyword == Keyword::kInside) {
        const Ref<ObjectDesc> object = object_argument();
        m_in.tokens.comma();
        const core::Vec3 point = parse_vector();
        value = m_in.ask_object([&] { return m_in.productions.inside(*object, point); });
      } else {
        const core::Vec3 a = parse_vector();
        m_in.tokens.comma();
        value = core::dot(a, parse_vector());
      }
      m_in.tokens.expect(Punct::kRightParen);
      return true;
    }
    case Keyword::kVlength: value = core::length(vector_argument()); return true;
    default: return false;
  }
}

}  // namespace lentray::parser
