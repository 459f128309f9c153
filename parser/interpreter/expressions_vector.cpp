// The vector functions and constants of the language, and the questions asked of live objects.
#include <algorithm>

#include "core/noise/noise.h"
#include "parser/interpreter/interpreter.h"

namespace lentray::parser {

core::Vec3 Expressions::vector_argument() {
  m_in.tokens.expect(Punct::kLeftParen);
  const core::Vec3 v = parse_vector();
  m_in.tokens.expect(Punct::kRightParen);
  return v;
}

Ref<ObjectDesc> Expressions::object_argument() {
  TokenReader& tokens = m_in.tokens;
  const Value* value =
      tokens.peek_operand().kind == TokenKind::kIdentifier ? tokens.value() : nullptr;
  const auto* object = value ? std::get_if<Ref<ObjectDesc>>(value) : nullptr;
  if (!object) tokens.fail_expected("the identifier of an object");
  const Ref<ObjectDesc> copy = *object;
  tokens.skip();
  return copy;
}

// trace (OBJECT, origin, direction [, identifier for the normal])
core::Vec3 Expressions::trace() {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Punct::kLeftParen);
  const Ref<ObjectDesc> object = object_argument();
  tokens.comma();
  const core::Vec3 origin = parse_vector();
  tokens.comma();
  const core::Vec3 direction = core::normalized(parse_vector());
  tokens.comma();
  core::Vec3 point, normal;
  const bool hit = m_in.ask_object(
      [&] { return m_in.productions.trace(*object, origin, direction, point, normal); });
  if (!hit) {
    point = {};
    normal = {};
  }
  if (tokens.peek().kind == TokenKind::kIdentifier) {
    Value* value = tokens.value();
    const Number* old = value ? std::get_if<Number>(value) : nullptr;
    if (!old || old->size != 3) tokens.fail_expected("the identifier of a vector");
    *value = Number::vector(normal);
    tokens.skip();
  }
  tokens.expect(Punct::kRightParen);
  return point;
}

core::Vec3 Expressions::extent(bool upper) {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Punct::kLeftParen);
  const Value* value =
      tokens.peek_operand().kind == TokenKind::kIdentifier ? tokens.value() : nullptr;
  const bool image = value && (std::holds_alternative<Ref<PigmentDesc>>(*value) ||
                               std::holds_alternative<Ref<NormalDesc>>(*value) ||
                               std::holds_alternative<Ref<TextureDesc>>(*value) ||
                               std::holds_alternative<Ref<DensityDesc>>(*value));
  core::Vec3 lo, hi;
  if (image && upper) {
    m_in.diagnostics.not_yet("max_extent() of an image", tokens.location());
    tokens.skip();
  } else {
    const Ref<ObjectDesc> object = object_argument();
    m_in.ask_object([&] { m_in.productions.extent(*object, lo, hi); });
  }
  tokens.expect(Punct::kRightParen);
  return upper ? hi : lo;
}

// vturbulence (lambda, omega, octaves, point)
core::Vec3 Expressions::turbulence() {
  core::Turbulence turbulence;
  m_in.tokens.expect(Punct::kLeftParen);
  // In single precision, as stock keeps them.
  turbulence.lambda = static_cast<float>(parse_float());
  m_in.tokens.comma();
  turbulence.omega = static_cast<float>(parse_float());
  m_in.tokens.comma();
  constexpr int kMostOctaves = 10;
  turbulence.octaves = std::clamp(to_int(parse_float()), 1, kMostOctaves);
  m_in.tokens.comma();
  const core::Vec3 point = parse_vector();
  m_in.tokens.comma();
  m_in.tokens.expect(Punct::kRightParen);
  return core::vector_turbulence(point, turbulence);
}

// After the keyword. False if it is no vector function.
bool Expressions::vector_function(Keyword keyword, Number& value) {
  TokenReader& tokens = m_in.tokens;
  const Location where = tokens.location();
  if (unit_vector(keyword, value)) return true;
  switch (keyword) {
    case Keyword::kVcross:
    case Keyword::kVrotate: {
      tokens.expect(Punct::kLeftParen);
      const core::Vec3 a = parse_vector();
      tokens.comma();
      const core::Vec3 b = parse_vector();
      tokens.expect(Punct::kRightParen);
      value = Number::vector(keyword == Keyword::kVcross ? core::cross(a, b) : rotated(a, b));
      return true;
    }
    case Keyword::kVaxisRotate: {
      tokens.expect(Punct::kLeftParen);
      const core::Vec3 a = parse_vector();
      tokens.comma();
      const core::Vec3 axis = parse_vector();
      tokens.comma();
      const double degrees = parse_float();
      tokens.expect(Punct::kRightParen);
      value = Number::vector(rotated_about(a, axis, degrees));
      return true;
    }
    case Keyword::kVnormalize: {
      const core::Vec3 a = vector_argument();
      if (a == core::Vec3{} && m_in.version >= 350) {
        m_in.warn(where, "vnormalize() of a vector of length zero");
      }
      value = Number::vector(normalised(a));
      return true;
    }
    case Keyword::kTrace: value = Number::vector(trace()); return true;
    case Keyword::kMinExtent: value = Number::vector(extent(false)); return true;
    case Keyword::kMaxExtent: value = Number::vector(extent(true)); return true;
    case Keyword::kVturbulence: value = Number::vector(turbulence()); return true;
    default: return false;
  }
}

}  // namespace lentray::parser
