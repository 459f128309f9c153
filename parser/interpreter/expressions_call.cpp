// Splines, and calls of functions and splines in ordinary expressions.
#include <algorithm>
#include <array>

#include "parser/interpreter/interpreter.h"
#include "parser/values/spline.h"

namespace lentray::parser {
namespace {

class SplineFunction final : public core::Function {
 public:
  explicit SplineFunction(Ref<SplineDesc> spline) : m_spline(std::move(spline)) {}
  std::size_t parameters() const override { return 1; }
  double evaluate(std::span<const double> a) const override { return m_spline->evaluate(a[0])[0]; }
  std::size_t results() const override { return static_cast<std::size_t>(m_spline->size); }
  void evaluate_all(std::span<const double> a, std::span<double> result) const override {
    const auto values = m_spline->evaluate(a[0]);
    std::copy_n(values.begin(), results(), result.begin());
  }

 private:
  Ref<SplineDesc> m_spline;
};

class TransformFunction final : public core::Function {
 public:
  explicit TransformFunction(const core::Transform& transform) : m_transform(transform) {}
  std::size_t parameters() const override { return 3; }
  double evaluate(std::span<const double> a) const override {
    return m_transform.point({a[0], a[1], a[2]}).x;
  }
  std::size_t results() const override { return 3; }
  void evaluate_all(std::span<const double> a, std::span<double> result) const override {
    const core::Vec3 p = m_transform.point({a[0], a[1], a[2]});
    result[0] = p.x;
    result[1] = p.y;
    result[2] = p.z;
  }

 private:
  core::Transform m_transform;
};

Ref<FunctionDesc> described(std::shared_ptr<const core::Function> function) {
  auto desc = std::make_shared<FunctionDesc>();
  desc->function = std::move(function);
  return desc;
}

std::optional<SplineKind> spline_kind(const Token& t) {
  if (t.is(Keyword::kLinearSpline)) return SplineKind::kLinear;
  if (t.is(Keyword::kQuadraticSpline)) return SplineKind::kQuadratic;
  if (t.is(Keyword::kCubicSpline)) return SplineKind::kCubic;
  if (t.is(Keyword::kNaturalSpline)) return SplineKind::kNatural;
  return std::nullopt;
}

}  // namespace

Ref<FunctionDesc> spline_function(const Ref<SplineDesc>& spline) {
  return described(std::make_shared<SplineFunction>(spline));
}

Ref<FunctionDesc> transform_function(const core::Transform& transform) {
  return described(std::make_shared<TransformFunction>(transform));
}

// { [NAME] [kind] t, VALUE ... } : a named spline comes first, to be copied and extended.
Ref<SplineDesc> Expressions::parse_spline() {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Punct::kLeftCurly);
  auto spline = std::make_shared<SplineDesc>();
  spline->size = 1;
  if (tokens.peek_operand().kind == TokenKind::kIdentifier) {
    const Value* value = tokens.value();
    const Token* after = tokens.following();
    const auto* named = value ? std::get_if<Ref<SplineDesc>>(value) : nullptr;
    if (named && !(after && after->is(Punct::kLeftParen))) {
      *spline = **named;
      tokens.skip();
    }
  }
  if (const auto kind = spline_kind(tokens.peek())) {
    spline->kind = *kind;
    tokens.skip();
  }
  std::array<double, 5> components{};
  while (!tokens.at(Punct::kRightCurly)) {
    const double at = parse_float();
    tokens.comma();
    Number value = parse_additive();
    tokens.comma();
    // A float stands for two components. Those that a value lacks are those of the point written before it; how many
    // the spline has, the longest value says (measured on stock: tests/compat/language/splines.cases).
    if (value.size == 1) promote(value, 2);
    std::copy_n(value.v.begin(), value.size, components.begin());
    spline->size = std::max(spline->size, value.size);
    spline->add(at, components);
  }
  if (spline->knots.empty()) tokens.fail_expected("the points of a spline");
  spline->size = std::max(spline->size, 2);
  spline->prepare();
  tokens.expect(Punct::kRightCurly);
  return spline;
}

Number ScriptTokens::call_spline(const Ref<SplineDesc>& named) {
  m_tokens.expect(Punct::kLeftParen);
  Ref<SplineDesc> spline = named;
  const double at = m_in.expressions.parse_float();
  if (m_tokens.accept(Punct::kComma)) {
    const auto kind = spline_kind(m_tokens.peek());
    if (!kind)
      m_tokens.fail_expected("linear_spline, quadratic_spline, cubic_spline or natural_spline");
    m_tokens.skip();
    auto other = std::make_shared<SplineDesc>(*spline);
    other->kind = *kind;
    other->prepare();
    spline = other;
  }
  m_tokens.expect(Punct::kRightParen);
  return {spline->evaluate(at), spline->size};
}

Number ScriptTokens::call_function(const Ref<FunctionDesc>& desc, std::string_view name) {
  const core::Function& function = *desc->function;
  const Location where = m_tokens.location();
  const std::string called(name);
  m_tokens.expect(Punct::kLeftParen);
  std::array<double, core::kMostParameters> arguments;
  const std::size_t wanted = function.parameters();
  std::size_t count = 0;
  while (!m_tokens.at(Punct::kRightParen) && count < wanted) {
    arguments[count++] = m_in.expressions.parse_float();
    m_tokens.comma();
  }
  if (count < wanted || !m_tokens.at(Punct::kRightParen)) {
    m_in.fail(m_tokens.location(), "function " + called + " takes " + std::to_string(wanted) +
                                       " arguments, found " +
                                       (count < wanted ? std::to_string(count) : "more"));
  }
  m_tokens.skip();
  if (const std::string missing = function.not_yet(); !missing.empty()) {
    m_in.diagnostics.not_yet(missing, where);
  }
  Number result;
  result.size = static_cast<int>(function.results());
  function.evaluate_all({arguments.data(), wanted}, result.v);
  return result;
}

}  // namespace lentray::parser
