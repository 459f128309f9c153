// The float functions and constants of the language.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "parser/interpreter.h"
#include "parser/text.h"

namespace lentray::parser {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

int to_int(double x) {
  constexpr int kSmallest = std::numeric_limits<int>::min();
  return x > kSmallest - 1.0 && x < 2147483648.0 ? static_cast<int>(x) : kSmallest;
}

bool Expressions::keyword_float(Keyword keyword, double& value) {
  switch (keyword) {
    case Keyword::kPi: value = std::numbers::pi; return true;
    case Keyword::kTrue: case Keyword::kYes: case Keyword::kOn: value = 1.0; return true;
    case Keyword::kFalse: case Keyword::kNo: case Keyword::kOff: value = 0.0; return true;
    case Keyword::kClock: value = m_in.options.clock; return true;
    case Keyword::kClockOn: value = m_in.options.frame_number > 0 ? 1.0 : 0.0; return true;
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

template <typename Fold>
double Expressions::fold(Fold op) {
  m_in.tokens.expect(Punct::kLeftParen);
  double x = parse_scalar_expression();
  while (m_in.tokens.accept(Punct::kComma)) x = op(x, parse_scalar_expression());
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

// A linear congruential generator a stream; constants measured by the values stock prints.
double Expressions::next_random(double stream) {
  const int index = to_int(stream);
  if (index < 0 || static_cast<std::size_t>(index) >= m_in.random.size()) {
    m_in.fail(m_in.tokens.location(), "rand() of a stream that no seed() has made");
  }
  std::uint32_t& state = m_in.random[static_cast<std::size_t>(index)];
  state = state * 1812433253u + 12345u;
  return static_cast<double>(state) * (1.0 / 4294967295.0);
}

double Expressions::array_dimension(bool size) {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Punct::kLeftParen);
  const Value* value = tokens.peek_operand().kind == TokenKind::kIdentifier ? tokens.value() : nullptr;
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

// After the keyword. False if it is no float function.
bool Expressions::float_function(Keyword keyword, double& value) {
  const Location where = m_in.tokens.location();
  const auto unit_range = [&](const char* name) {
    const double x = float_argument();
    if (std::fabs(x) > 1.0) m_in.warn(where, std::string("domain error in ") + name);
    return std::clamp(x, -1.0, 1.0);
  };
  const auto positive = [&](const char* name) {
    const double x = float_argument();
    if (!(x > 0.0)) m_in.fail(where, std::string(name) + " of " + std::to_string(x));
    return x;
  };
  switch (keyword) {
    case Keyword::kAbs: value = std::fabs(float_argument()); return true;
    case Keyword::kAcos: value = std::acos(unit_range("acos")); return true;
    case Keyword::kAsin: value = std::asin(unit_range("asin")); return true;
    case Keyword::kAtan: value = std::atan(float_argument()); return true;
    case Keyword::kAtan2: {
      const auto [y, x] = two_floats();
      if (std::fabs(y) <= kCompareEpsilon && std::fabs(x) <= kCompareEpsilon) {
        m_in.fail(where, "atan2(0, 0) is not defined");
      }
      value = std::atan2(y, x);
      return true;
    }
    case Keyword::kCos: value = std::cos(float_argument()); return true;
    case Keyword::kSin: value = std::sin(float_argument()); return true;
    case Keyword::kTan: value = std::tan(float_argument()); return true;
    case Keyword::kCosh: value = std::cosh(float_argument()); return true;
    case Keyword::kSinh: value = std::sinh(float_argument()); return true;
    case Keyword::kTanh: value = std::tanh(float_argument()); return true;
    case Keyword::kAcosh: value = std::acosh(float_argument()); return true;
    case Keyword::kAsinh: value = std::asinh(float_argument()); return true;
    case Keyword::kAtanh: value = std::atanh(float_argument()); return true;
    case Keyword::kCeil: value = std::ceil(float_argument()); return true;
    case Keyword::kFloor: value = std::floor(float_argument()); return true;
    case Keyword::kInt: value = to_int(float_argument()); return true;
    case Keyword::kDegrees: value = float_argument() / kDegree; return true;
    case Keyword::kRadians: value = float_argument() * kDegree; return true;
    case Keyword::kExp: value = std::exp(float_argument()); return true;
    case Keyword::kLn: value = std::log(positive("ln")); return true;
    case Keyword::kLog: value = std::log10(positive("log")); return true;
    case Keyword::kSqr: value = float_argument(); value *= value; return true;
    case Keyword::kSqrt:
      value = float_argument();
      if (value < 0.0) m_in.fail(where, "sqrt of the negative number " + std::to_string(value));
      value = std::sqrt(value);
      return true;
    case Keyword::kDiv: {
      const auto [a, b] = two_floats();
      value = to_int(a / b);
      return true;
    }
    case Keyword::kMod: {
      const auto [a, b] = two_floats();
      value = std::fmod(a, b);
      return true;
    }
    case Keyword::kPow: {
      const auto [a, b] = two_floats();
      if (a == 0.0 && b == 0.0) m_in.fail(where, "pow(0, 0) is not defined");
      value = std::pow(a, b);
      return true;
    }
    case Keyword::kMax: value = fold([](double a, double b) { return std::max(a, b); }); return true;
    case Keyword::kMin: value = fold([](double a, double b) { return std::min(a, b); }); return true;
    case Keyword::kBitwiseAnd:
      value = fold([](double a, double b) { return to_int(a) & to_int(b); });
      return true;
    case Keyword::kBitwiseOr:
      value = fold([](double a, double b) { return to_int(a) | to_int(b); });
      return true;
    case Keyword::kBitwiseXor:
      value = fold([](double a, double b) { return to_int(a) ^ to_int(b); });
      return true;
    case Keyword::kSelect: value = select(); return true;
    case Keyword::kRand: value = next_random(float_argument()); return true;
    case Keyword::kSeed:
      m_in.random.push_back(static_cast<std::uint32_t>(to_int(float_argument())));
      value = static_cast<double>(m_in.random.size() - 1);
      return true;
    case Keyword::kDefined: value = m_in.directives.parse_defined(); return true;
    case Keyword::kDimensions: value = array_dimension(false); return true;
    case Keyword::kDimensionSize: value = array_dimension(true); return true;
    case Keyword::kVal: case Keyword::kAsc: case Keyword::kStrlen: case Keyword::kFileExists: {
      m_in.tokens.expect(Punct::kLeftParen);
      const std::string text = keyword == Keyword::kFileExists ? parse_path() : parse_string();
      m_in.tokens.expect(Punct::kRightParen);
      if (keyword == Keyword::kVal) value = std::strtod(text.c_str(), nullptr);
      else if (keyword == Keyword::kFileExists) value = text.empty() || m_in.find_exactly(text) ? 1.0 : 0.0;
      else if (keyword == Keyword::kAsc) value = first_character(text);
      else value = static_cast<double>(count_characters(text));
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
    case Keyword::kVdot: case Keyword::kInside: {
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
