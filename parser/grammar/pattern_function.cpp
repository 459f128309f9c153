#include <algorithm>
#include <array>

#include "core/function/function.h"
#include "parser/compile/density_reader.h"
#include "parser/compile/pattern_compiler.h"
#include "parser/compile/picture_reader.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

core::Vec3 point_of(std::span<const double> arguments) {
  return {arguments[0], arguments[1], arguments[2]};
}

class PigmentFunction final : public core::Function {
 public:
  PigmentFunction(std::shared_ptr<const core::Pigment> pigment, std::string not_yet)
      : m_pigment(std::move(pigment)), m_not_yet(std::move(not_yet)) {}
  std::size_t parameters() const override { return 3; }
  std::size_t results() const override { return 5; }
  std::string not_yet() const override { return m_not_yet; }
  double evaluate(std::span<const double> arguments) const override {
    return m_pigment->colour(point_of(arguments)).rgb.r;
  }
  void evaluate_all(std::span<const double> arguments, std::span<double> result) const override {
    const core::Colour c = m_pigment->colour(point_of(arguments));
    const std::array<double, 5> all = {c.rgb.r, c.rgb.g, c.rgb.b, c.filter, c.transmit};
    std::copy(all.begin(), all.end(), result.begin());
  }

 private:
  std::shared_ptr<const core::Pigment> m_pigment;
  std::string m_not_yet;
};

class PatternFunction final : public core::Function {
 public:
  PatternFunction(core::PlacedPattern pattern, std::string not_yet)
      : m_pattern(std::move(pattern)), m_not_yet(std::move(not_yet)) {}
  std::size_t parameters() const override { return 3; }
  std::string not_yet() const override { return m_not_yet; }
  double evaluate(std::span<const double> arguments) const override {
    return m_pattern.value(m_pattern.placement.inwards(point_of(arguments)));
  }

 private:
  core::PlacedPattern m_pattern;
  std::string m_not_yet;
};

TextureSettings settings_of(const Parser& parser) {
  TextureSettings settings;
  settings.language_version = parser.language_version();
  settings.noise_generator = parser.noise_generator();
  return settings;
}

std::string first_of(const std::set<std::string>& names) {
  return names.empty() ? std::string() : *names.begin();
}

}  // namespace

Ref<FunctionDesc> parse_pattern_function(Parser& parser, MaterialContext& context) {
  const TextureSettings settings = settings_of(parser);
  auto desc = std::make_shared<FunctionDesc>();
  if (parser.accept(Keyword::kPigment)) {
    desc->pigment = parse_pigment(parser, context);
    desc->depth = desc->pigment->pattern.nesting.depth;
    desc->calls = desc->pigment->pattern.nesting.parts;
    TextureCompiler compiler(settings);
    auto pigment = compiler.pigment(desc->pigment);
    desc->function =
        std::make_shared<PigmentFunction>(std::move(pigment), first_of(compiler.not_yet()));
    return desc;
  }
  parser.expect(Keyword::kPattern);
  parser.expect(Punct::kLeftCurly);
  // A pattern statement is a pigment without colours.
  const auto pigment = parse_pigment_body(parser, context, std::make_shared<const PigmentDesc>());
  if (pigment->pattern.kind == PatternKind::kPlain) parser.fail_expected("a pattern");
  end_block(parser, "a modifier of the pattern (turbulence, warp, scale ...)");
  desc->depth = pigment->pattern.nesting.depth;
  desc->calls = pigment->pattern.nesting.parts;
  std::set<std::string> not_yet;
  const PatternBuild build{
      settings, not_yet,
      [&](const Ref<PigmentDesc>& inner) {
        TextureCompiler compiler(settings);
        return compiler.pigment(inner);
      },
      [&](const ImageDesc& image) { return PictureReader(not_yet).get(image, false); },
      [](const FoundFile& file) { return parser::read_density_file(file); }};
  auto placed = compile_placed(pigment->pattern, build);
  desc->function = std::make_shared<PatternFunction>(std::move(placed), first_of(not_yet));
  return desc;
}

}  // namespace lentray::parser
