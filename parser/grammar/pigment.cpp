#include "parser/descriptions/pigment.h"

#include "parser/base/recycled.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/nesting.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

class PigmentTarget final : public MapTarget<PigmentDesc, PigmentMapDesc> {
 public:
  PigmentTarget(PigmentDesc& pigment, MaterialContext& context)
      : MapTarget("pigment", pigment, pigment.pattern, pigment.pigment_map, context) {}

  bool accept_plain(Parser& parser) override {
    if (!parser.at_colour()) return false;
    m_desc.colour = to_colour(parser.parse_colour());
    return true;
  }

  void read_list(Parser& parser, int count) override {
    if (!parser.at(Keyword::kPigment)) {
      m_desc.colour_map = parse_colour_list(parser, m_desc.pattern.kind, count);
      m_map = nullptr;
      return;
    }
    m_map = parse_item_list<PigmentMapDesc>(
        parser, count, Keyword::kPigment, [&] { return default_layer(m_context).pigment; },
        [&] { return parse_pigment(parser, m_context); });
    m_desc.colour_map = nullptr;
  }

  void read_item(Parser& parser) override {
    m_map = map_of<PigmentMapDesc>(
        parse_pigment_body(parser, m_context, default_layer(m_context).pigment));
    m_desc.colour_map = nullptr;
  }

  bool accept_own_modifier(Parser& parser) override {
    // Without a pattern a color_map means nothing, and stock accepts it.
    if ((is_unset(m_desc.pattern) && parser.accept(Keyword::kColorMap)) ||
        accept_map(parser, Keyword::kColorMap, m_desc.pattern, false)) {
      m_desc.colour_map = parse_colour_map(parser, m_context);
      m_map = nullptr;
    } else if (accept_map(parser, Keyword::kPigmentMap, m_desc.pattern, true)) {
      m_map = parse_pigment_map(parser, m_context, m_desc.pattern.kind == PatternKind::kAverage);
      m_desc.colour_map = nullptr;
    } else if (parser.accept(Keyword::kQuickColor)) {
      m_desc.quick_colour = to_colour(parser.parse_colour());
    } else {
      return false;
    }
    return true;
  }
};

}  // namespace

const TextureLayerDesc& default_layer(const MaterialContext& context) {
  return context.default_texture->layers.back();
}

Ref<PigmentDesc> parse_pigment_body(Parser& parser, MaterialContext& context,
                                    Ref<PigmentDesc> base) {
  const Location where = parser.location();
  const auto known = parser.accept_value<Ref<PigmentDesc>>();
  const PigmentDesc* from = known ? known->get() : base.get();
  auto pigment = from ? make_recycled<PigmentDesc>(*from) : make_recycled<PigmentDesc>();
  pigment->where = where;
  PigmentTarget target(*pigment, context);
  parse_pattern_body(parser, context, target);
  return pigment;
}

Ref<PigmentDesc> parse_pigment(Parser& parser, MaterialContext& context) {
  parser.expect(Punct::kLeftCurly);
  auto pigment = parse_pigment_body(parser, context, default_layer(context).pigment);
  end_block(parser, kPigmentWords);
  return pigment;
}

}  // namespace lentray::parser
