#include "parser/descriptions/pigment.h"

#include "parser/grammar/helpers.h"
#include "parser/grammar/nesting.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

class PigmentTarget final : public ColourTarget<PigmentDesc, PigmentMapDesc> {
 public:
  PigmentTarget(PigmentDesc& pigment, MaterialContext& context)
      : ColourTarget("pigment", pigment, pigment.pattern, pigment.pigment_map, context) {}

  void read_list(Parser& parser, int count) override {
    if (!parser.at(Keyword::kPigment)) {
      return set_colours(parse_colour_list(parser, m_desc.pattern.kind));
    }
    set_map(parse_item_list<PigmentMapDesc>(
        parser, count, Keyword::kPigment, [&] { return default_layer(m_context).pigment; },
        [&] { return parse_pigment(parser, m_context); }));
  }

  void read_item(Parser& parser) override {
    set_map(map_of<PigmentMapDesc>(
        parse_pigment_body(parser, m_context, default_layer(m_context).pigment)));
  }

  bool accept_own_modifier(Parser& parser) override {
    // Without a pattern a color_map means nothing, and stock accepts it.
    if (is_unset(m_desc.pattern) && parser.accept(Keyword::kColorMap)) {
      set_colours(parse_colour_map(parser, m_context));
    } else if (parser.accept(Keyword::kQuickColor)) {
      m_desc.quick_colour = to_colour(parser.parse_colour());
    } else {
      return accept_either_map(parser, Keyword::kPigmentMap, parse_pigment_map);
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
  return parse_body<PigmentTarget>(parser, context, base);
}

Ref<PigmentDesc> parse_pigment_block(Parser& parser, MaterialContext& context,
                                     Ref<PigmentDesc> base) {
  parser.expect(Punct::kLeftCurly);
  auto pigment = parse_pigment_body(parser, context, base);
  end_block(parser, kPigmentWords);
  return pigment;
}

Ref<PigmentDesc> parse_pigment(Parser& parser, MaterialContext& context) {
  return parse_pigment_block(parser, context, default_layer(context).pigment);
}

}  // namespace lentray::parser
