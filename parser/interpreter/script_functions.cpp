// The functions that do more than to compute: they ask arrays, files and objects, or begin a stream
// of random numbers.
#include <algorithm>

#include "core/noise/noise.h"
#include "parser/interpreter/interpreter.h"

namespace lentray::parser {

// After the keyword.
bool ScriptTokens::function(Keyword word, Number& n) {
  if (word == Keyword::kDefined) {
    n.v[0] = m_in.directives.parse_defined();
    return true;
  }
  expect(Punct::kLeftParen);
  switch (word) {
    case Keyword::kSeed:
      m_in.random.push_back(
          static_cast<std::uint32_t>(core::to_int(m_in.expressions.parse_scalar_expression())));
      n.v[0] = static_cast<double>(m_in.random.size() - 1);
      break;
    case Keyword::kDimensions:
      n.v[0] = static_cast<double>(named<std::shared_ptr<ArrayValue>>("an array")->sizes.size());
      break;
    case Keyword::kDimensionSize: n.v[0] = dimension_size(); break;
    case Keyword::kFileExists: {
      const Location where = peek_operand().where;
      const std::string path = m_in.expressions.parse_path();
      n.v[0] = path.empty() || m_in.find_exactly(path, where) ? 1.0 : 0.0;
      break;
    }
    case Keyword::kInside: {
      const auto object = named<Ref<ObjectDesc>>("an object");
      m_tokens.comma();
      const core::Vec3 point = m_in.expressions.parse_vector();
      n.v[0] = m_in.ask_object([&] { return m_in.productions.inside(*object, point); });
      break;
    }
    case Keyword::kTrace: n = Number::vector(trace()); break;
    case Keyword::kMinExtent: n = Number::vector(extent(false)); break;
    case Keyword::kMaxExtent: n = Number::vector(extent(true)); break;
    default: n = Number::vector(turbulence());
  }
  return expect(Punct::kRightParen);
}

template <typename T>
T ScriptTokens::named(const char* what) {
  const Value* value =
      m_tokens.peek_operand().kind == TokenKind::kIdentifier ? m_tokens.value() : nullptr;
  const T* found = value ? std::get_if<T>(value) : nullptr;
  if (!found) m_tokens.fail_expected("the identifier of " + std::string(what));
  const T copy = *found;
  m_tokens.skip();
  return copy;
}

double ScriptTokens::dimension_size() {
  const auto array = named<std::shared_ptr<ArrayValue>>("an array");
  m_tokens.comma();
  const double which = m_in.expressions.parse_float();
  if (which >= 1.0 && which < static_cast<double>(array->sizes.size() + 1))
    return array->sizes[static_cast<std::size_t>(which) - 1];
  m_in.warn(m_tokens.location(), "size of dimension " + std::to_string(core::to_int(which)) +
                                     " of an array that has " +
                                     std::to_string(array->sizes.size()));
  return 0.0;
}

// OBJECT, origin, direction [, identifier for the normal]
core::Vec3 ScriptTokens::trace() {
  const auto object = named<Ref<ObjectDesc>>("an object");
  m_tokens.comma();
  const core::Vec3 origin = m_in.expressions.parse_vector();
  m_tokens.comma();
  const core::Vec3 direction = core::normalized(m_in.expressions.parse_vector());
  m_tokens.comma();
  core::Vec3 point, normal;
  const bool hit = m_in.ask_object(
      [&] { return m_in.productions.trace(*object, origin, direction, point, normal); });
  if (!hit) {
    point = {};
    normal = {};
  }
  if (m_tokens.peek().kind == TokenKind::kIdentifier) {
    Value* value = m_tokens.value();
    const Number* old = value ? std::get_if<Number>(value) : nullptr;
    if (!old || old->size != 3) m_tokens.fail_expected("the identifier of a vector");
    *value = Number::vector(normal);
    m_tokens.skip();
  }
  return point;
}

core::Vec3 ScriptTokens::extent(bool upper) {
  const Value* value =
      m_tokens.peek_operand().kind == TokenKind::kIdentifier ? m_tokens.value() : nullptr;
  const bool image = value && (std::holds_alternative<Ref<PigmentDesc>>(*value) ||
                               std::holds_alternative<Ref<NormalDesc>>(*value) ||
                               std::holds_alternative<Ref<TextureDesc>>(*value) ||
                               std::holds_alternative<Ref<DensityDesc>>(*value));
  core::Vec3 lo, hi;
  if (image && upper) {
    m_in.diagnostics.not_yet("max_extent() of an image", m_tokens.location());
    m_tokens.skip();
  } else {
    const auto object = named<Ref<ObjectDesc>>("an object");
    m_in.ask_object([&] { m_in.productions.extent(*object, lo, hi); });
  }
  return upper ? hi : lo;
}

// lambda, omega, octaves, point
core::Vec3 ScriptTokens::turbulence() {
  core::Turbulence turbulence;
  // In single precision, as stock keeps them.
  turbulence.lambda = static_cast<float>(m_in.expressions.parse_float());
  m_tokens.comma();
  turbulence.omega = static_cast<float>(m_in.expressions.parse_float());
  m_tokens.comma();
  constexpr int kMostOctaves = 10;
  turbulence.octaves = std::clamp(core::to_int(m_in.expressions.parse_float()), 1, kMostOctaves);
  m_tokens.comma();
  const core::Vec3 point = m_in.expressions.parse_vector();
  m_tokens.comma();
  return core::vector_turbulence(point, turbulence);
}

}  // namespace lentray::parser
