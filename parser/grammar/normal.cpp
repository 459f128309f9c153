#include "parser/descriptions/normal.h"

#include "parser/grammar/helpers.h"
#include "parser/grammar/nesting.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

class NormalTarget final : public MapTarget<NormalDesc, NormalMapDesc> {
 public:
  NormalTarget(NormalDesc& normal, MaterialContext& context)
      : MapTarget("normal", normal, normal.pattern, normal.normal_map, context) {}

  void read_list(Parser& parser, int count) override {
    m_desc.accuracy = 0.02;
    m_desc.slope_map = nullptr;
    m_map = nullptr;
    if (!parser.at(Keyword::kNormal)) return;
    m_map = parse_item_list<NormalMapDesc>(
        parser, count, Keyword::kNormal, [&] { return default_layer(m_context).normal; },
        [&] { return parse_normal(parser, m_context); });
  }

  void read_item(Parser& parser) override {
    m_map = map_of<NormalMapDesc>(
        parse_normal_body(parser, m_context, default_layer(m_context).normal));
    m_desc.slope_map = nullptr;
  }

  void after_pattern(Parser& parser) override {
    parser.parse_comma();
    m_desc.amount = parse_optional_float(parser, m_desc.amount);
  }

  bool accept_own_modifier(Parser& parser) override {
    PatternDesc& pattern = m_desc.pattern;
    if (parser.accept(Keyword::kBumpSize, m_desc.amount) ||
        parser.accept(Keyword::kAccuracy, m_desc.accuracy))
      return true;
    if (parser.accept(Keyword::kBumpMap)) {
      pattern.kind = PatternKind::kBumpMap;
      pattern.frequency = 0.0;
      pattern.own.edit().image = parse_bump_map(parser, m_desc.amount);
      after_pattern(parser);
    } else if (parser.accept(Keyword::kNoBumpScale)) {
      m_desc.no_bump_scale = true;
    } else if (accept_map(parser, Keyword::kSlopeMap, pattern, false)) {
      m_desc.slope_map = parse_slope_map(parser, m_context);
      m_map = nullptr;
    } else if (pattern.kind == PatternKind::kFacets && parser.at(Keyword::kNormalMap)) {
      parser.fail("cannot use normal_map with facets");
    } else if (accept_map(parser, Keyword::kNormalMap, pattern, true)) {
      m_map = parse_normal_map(parser, m_context, pattern.kind == PatternKind::kAverage);
      m_desc.slope_map = nullptr;
    } else {
      return false;
    }
    return true;
  }
};

}  // namespace

Ref<NormalDesc> parse_normal_body(Parser& parser, MaterialContext& context, Ref<NormalDesc> base) {
  return parse_body<NormalTarget>(parser, context, base);
}

Ref<NormalDesc> parse_normal_block(Parser& parser, MaterialContext& context, Ref<NormalDesc> base) {
  parser.expect(Punct::kLeftCurly);
  auto normal = parse_normal_body(parser, context, base);
  end_block(parser, kNormalWords);
  return normal;
}

Ref<NormalDesc> parse_normal(Parser& parser, MaterialContext& context) {
  return parse_normal_block(parser, context, default_layer(context).normal);
}

}  // namespace lentray::parser
