#include "parser/descriptions/texture.h"

#include "parser/base/edit.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/nesting.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

class TextureTarget final : public MapTarget<TextureLayerDesc, TextureMapDesc> {
 public:
  TextureTarget(TextureLayerDesc& layer, MaterialContext& context)
      : MapTarget("texture", layer, layer.pattern.edit(), layer.map, context) {}

  void read_list(Parser& parser, int count) override {
    m_map = parse_item_list<TextureMapDesc>(
        parser, count, Keyword::kTexture, [&] { return m_context.default_texture; },
        [&] { return parse_texture(parser, m_context); });
  }

  void read_item(Parser& parser) override {
    m_map = map_of<TextureMapDesc>(parse_texture_body(parser, m_context));
  }

  bool accept_own_modifier(Parser& parser) override {
    if (!accept_map(parser, Keyword::kTextureMap, *m_desc.pattern, true)) return false;
    m_map = parse_texture_map(parser, m_context, m_desc.pattern->kind == PatternKind::kAverage);
    return true;
  }
};

/// Names of a pigment, normal or finish standing for the statement itself.
bool accept_part_names(Parser& parser, TextureLayerDesc& layer) {
  bool any = false;
  for (;;) {
    if (const auto pigment = parser.accept_value<Ref<PigmentDesc>>()) {
      layer.pigment = *pigment;
    } else if (const auto normal = parser.accept_value<Ref<NormalDesc>>()) {
      layer.normal = *normal;
    } else if (const auto finish = parser.accept_value<Ref<FinishDesc>>()) {
      layer.finish = *finish;
    } else {
      return any;
    }
    any = true;
  }
}

void keep_bump_scale(TextureDesc& texture) {
  for (TextureLayerDesc& layer : texture.layers) {
    if (!layer.normal) continue;
    edit(layer.normal).no_bump_scale = true;
  }
}

void parse_transforms(Parser& parser, Ref<TextureDesc>& texture) {
  while (const auto transform = parser.accept_transforms()) {
    texture = transformed(std::move(texture), *transform);
  }
}

/// tiles, material_map, or a pattern with its texture_map; nullptr if none of these is next.
Ref<TextureDesc> parse_patterned(Parser& parser, MaterialContext& context) {
  auto texture = std::make_shared<TextureDesc>();
  texture->where = parser.location();
  TextureLayerDesc layer;
  if (parser.accept(Keyword::kTiles)) {
    layer = parse_tiles(parser, context);
  } else if (parser.accept(Keyword::kMaterialMap)) {
    layer = parse_material_map(parser, context);
  } else {
    TextureTarget target(layer, context);
    parse_pattern_body(parser, context, target);
    if (layer.pattern->kind == PatternKind::kPlain) return nullptr;
    if (!layer.map) parser.fail("a texture with a pattern needs a texture_map");
  }
  layer.where = texture->where;
  texture->layers.push_back(std::move(layer));
  Ref<TextureDesc> result = texture;
  parse_transforms(parser, result);
  return result;
}

}  // namespace

bool accept_part(Parser& parser, MaterialContext& context,
                 const std::function<TextureLayerDesc&()>& layer, bool default_normal) {
  if (parser.accept(Keyword::kPigment)) {
    TextureLayerDesc& top = layer();
    top.pigment = parse_pigment_block(parser, context, top.pigment);
  } else if (parser.accept(Keyword::kNormal)) {
    TextureLayerDesc& top = layer();
    const bool from_default = default_normal && !top.normal;
    top.normal = parse_normal_block(parser, context,
                                    from_default ? default_layer(context).normal : top.normal);
  } else if (parser.accept(Keyword::kFinish)) {
    TextureLayerDesc& top = layer();
    top.finish = parse_finish_block(parser, context, top.finish);
  } else {
    return false;
  }
  return true;
}

Ref<TextureDesc> parse_texture_body(Parser& parser, MaterialContext& context) {
  if (parser.language_version() < 300) return parse_old_texture_body(parser, context);
  const Location where = parser.location();
  Ref<TextureDesc> texture = context.default_texture;
  bool modified = false;
  if (const auto known = parser.accept_value<Ref<TextureDesc>>()) {
    texture = *known;
    modified = true;
  }
  if (texture->layers.back().is_patterned()) {
    parse_transforms(parser, texture);
    return texture;
  }
  edit(texture).where = where;
  // Parts replace those of the topmost layer; transforms reach all of them.
  modified |= accept_part_names(parser, edit(texture).layers.back());
  bool keep_bumps = false;
  const auto top = [&]() -> TextureLayerDesc& { return edit(texture).layers.back(); };
  for (;;) {
    if (accept_part(parser, context, top, true)) {
      modified = true;
    } else if (const auto transform = parser.accept_transforms()) {
      texture = transformed(std::move(texture), *transform);
      modified = true;
    } else if (parser.accept(Keyword::kNoBumpScale)) {
      keep_bumps = true;
    } else {
      break;
    }
  }
  if (keep_bumps) keep_bump_scale(edit(texture));
  if (!modified) {
    if (auto patterned = parse_patterned(parser, context)) return patterned;
  }
  return texture;
}

Ref<TextureDesc> parse_texture(Parser& parser, MaterialContext& context) {
  parser.expect(Punct::kLeftCurly);
  auto texture = parse_texture_body(parser, context);
  end_block(parser, "one of pigment, normal, finish, a transform, a pattern with a texture_map");
  return texture;
}

namespace {

/// Completes a layer of tiles or of a material_map.
void set_map(Parser& parser, TextureLayerDesc& layer, std::shared_ptr<const TextureMapDesc> map) {
  layer.map = std::move(map);
  PatternDesc& pattern = layer.pattern.edit();
  Nesting nesting = held_by(pattern);
  hold_map(nesting, layer.map.get());
  keep_nesting(parser, pattern.nesting, nesting, pattern.where, "textures");
}

}  // namespace

TextureLayerDesc parse_tiles(Parser& parser, MaterialContext& context) {
  TextureLayerDesc layer;
  PatternDesc& pattern = layer.pattern.edit();
  pattern.kind = PatternKind::kTiles;
  pattern.where = parser.location();
  pattern.frequency = 0.0;
  parser.expect(Punct::kLeftCurly);
  const auto read_layers = [&] {
    Ref<TextureDesc> tile;
    while (parser.accept(Keyword::kTexture)) {
      tile = layered(std::move(tile), parse_texture(parser, context));
      check_layers(parser, *tile);
    }
    if (!tile) parser.fail_expected("the texture of a tile");
    return tile;
  };
  // The first tile lies where the checker pattern is 1.
  const Ref<TextureDesc> first = read_layers();
  parser.expect(Keyword::kTile2);
  const Ref<TextureDesc> second = read_layers();
  parser.expect(Punct::kRightCurly);
  auto map = std::make_shared<TextureMapDesc>();
  map->where = pattern.where;
  map->entries = {{0.0, second}, {1.0, first}};
  set_map(parser, layer, map);
  return layer;
}

TextureLayerDesc parse_material_map(Parser& parser, MaterialContext& context) {
  TextureLayerDesc layer;
  PatternDesc& pattern = layer.pattern.edit();
  pattern.kind = PatternKind::kMaterialMap;
  pattern.where = parser.location();
  pattern.frequency = 0.0;
  parser.expect(Punct::kLeftCurly);
  auto image = parse_image_source(parser);
  while (accept_image_modifier(parser, *image)) {
  }
  pattern.own.edit().image = image;
  auto map = std::make_shared<TextureMapDesc>();
  map->where = pattern.where;
  do {
    parser.expect(Keyword::kTexture);
    map->entries.push_back(
        {static_cast<double>(map->entries.size()), parse_texture(parser, context)});
  } while (parser.at(Keyword::kTexture));
  parser.expect(Punct::kRightCurly);
  set_map(parser, layer, map);
  return layer;
}

}  // namespace lentray::parser
