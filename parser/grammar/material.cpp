#include "parser/grammar/material.h"

#include "parser/base/edit.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/nesting.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

bool is_layerable(const Ref<TextureDesc>& texture) {
  return !texture || !texture->layers.back().is_patterned();
}

core::Colour filter_as_transmit(const core::Colour& colour) {
  return {colour.rgb, 0.0f, colour.transmit + colour.filter};
}

/// As in stock, its maps change wherever they are used. So these are changed although others refer to them.
Ref<PigmentDesc> filter_as_transmit(const Ref<PigmentDesc>& pigment) {
  auto copy = std::make_shared<PigmentDesc>(*pigment);
  copy->colour = filter_as_transmit(pigment->colour);
  const auto change = []<typename Map>(const std::shared_ptr<const Map>& map) {
    if (!map) return;
    for (auto& entry : const_cast<Map&>(*map).entries) entry.item = filter_as_transmit(entry.item);
  };
  change(copy->colour_map);
  change(copy->pigment_map);
  return copy;
}

/// A texture over what is there. Patterned textures cannot be layered.
void add_texture(Parser& parser, Ref<TextureDesc>& below, Ref<TextureDesc> above) {
  if (below && (!is_layerable(below) || !is_layerable(above))) {
    parser.fail("a texture with a texture_map, tiles or material_map cannot be layered");
  }
  below = layered(std::move(below), std::move(above));
  check_layers(parser, *below);
  if (parser.language_version() > 310 || below->layers.size() < 2) return;
  // Until 3.1 the layers above another let light through untinted.
  auto& layers = edit(below).layers;
  for (std::size_t i = 1; i < layers.size(); ++i) {
    if (layers[i].pigment) layers[i].pigment = filter_as_transmit(layers[i].pigment);
  }
}

/// The topmost layer of an object's own texture, which starts as the default.
TextureLayerDesc& top_layer(Parser& parser, MaterialContext& context, Ref<TextureDesc>& texture) {
  if (!texture) texture = context.default_texture;
  if (texture->layers.back().is_patterned()) {
    parser.fail("a texture with a texture_map, tiles or material_map has no single part to change");
  }
  return edit(texture).layers.back();
}

bool accept_own_part(Parser& parser, MaterialContext& context, Ref<TextureDesc>& texture) {
  const auto layer = [&]() -> TextureLayerDesc& { return top_layer(parser, context, texture); };
  return accept_part(parser, context, layer, false);
}

/// A colour directly in an object: before 1.5 its colour in quick renders, without meaning since.
void accept_object_colour(Parser& parser, Looks& looks) {
  const core::Colour colour = to_colour(parser.parse_colour());
  if (parser.language_version() >= 150 || !looks.texture ||
      looks.texture->layers.back().is_patterned()) {
    parser.warn("a color in an object is ignored; it belongs in a pigment");
    return;
  }
  edit(edit(looks.texture).layers.back().pigment).quick_colour = colour;
}

/// A word of colours or a colour's name: a plain vector is no colour here.
bool at_colour_name(Parser& parser) {
  if (parser.at(Punct::kLess) || !parser.at_colour()) return false;
  const Value* value = parser.peek_value();
  const Number* number = value ? std::get_if<Number>(value) : nullptr;
  return !number || number->is_colour;
}

Ref<TextureDesc> parse_texture_layers(Parser& parser, MaterialContext& context) {
  Ref<TextureDesc> layers = parse_texture(parser, context);
  while (parser.accept(Keyword::kTexture)) {
    add_texture(parser, layers, parse_texture(parser, context));
  }
  return layers;
}

}  // namespace

Ref<MaterialDesc> parse_material(Parser& parser, MaterialContext& context) {
  auto material = std::make_shared<MaterialDesc>();
  const Location where = parser.location();
  parser.expect(Punct::kLeftCurly);
  if (const auto known = parser.accept_value<Ref<MaterialDesc>>()) *material = **known;
  material->where = where;
  for (;;) {
    if (parser.accept(Keyword::kTexture)) {
      add_texture(parser, material->texture, parse_texture(parser, context));
    } else if (parser.accept(Keyword::kInteriorTexture)) {
      add_texture(parser, material->interior_texture, parse_texture(parser, context));
    } else if (parser.accept(Keyword::kInterior)) {
      material->interior = parse_interior(parser, context, material->interior);
    } else if (const auto transform = parser.accept_transforms()) {
      // Stock leaves the interior texture where it is.
      material->texture = transformed(std::move(material->texture), *transform);
      material->interior = transformed(std::move(material->interior), *transform);
    } else {
      break;
    }
  }
  end_block(parser, "one of texture, interior_texture, interior, a transform");
  return material;
}

bool accept_looks(Parser& parser, MaterialContext& context, Looks& looks) {
  if (parser.accept(Keyword::kTexture)) {
    add_texture(parser, looks.texture, parse_texture(parser, context));
  } else if (parser.accept(Keyword::kInteriorTexture)) {
    add_texture(parser, looks.interior_texture, parse_texture(parser, context));
  } else if (parser.accept(Keyword::kInterior)) {
    looks.interior = parse_interior(parser, context, looks.interior);
  } else if (parser.accept(Keyword::kMaterial)) {
    const Ref<MaterialDesc> material = parse_material(parser, context);
    if (material->texture) add_texture(parser, looks.texture, material->texture);
    if (material->interior_texture) {
      add_texture(parser, looks.interior_texture, material->interior_texture);
    }
    if (material->interior) looks.interior = material->interior;
  } else if (accept_own_part(parser, context, looks.texture)) {
    return true;
  } else if (at_colour_name(parser)) {
    accept_object_colour(parser, looks);
  } else {
    return false;
  }
  return true;
}

void transform_looks(Looks& looks, const core::Transform& transform) {
  looks.texture = transformed(std::move(looks.texture), transform);
  looks.interior_texture = transformed(std::move(looks.interior_texture), transform);
  looks.interior = transformed(std::move(looks.interior), transform);
}

std::optional<Value> accept_material_value(Parser& parser, MaterialContext& context) {
  if (parser.accept(Keyword::kPigment)) return parse_pigment(parser, context);
  if (parser.accept(Keyword::kNormal)) return parse_normal(parser, context);
  if (parser.accept(Keyword::kFinish)) return parse_finish(parser, context);
  if (parser.accept(Keyword::kTexture)) return parse_texture_layers(parser, context);
  if (parser.accept(Keyword::kInterior)) return parse_interior(parser, context);
  if (parser.accept(Keyword::kMaterial)) return parse_material(parser, context);
  if (parser.accept(Keyword::kMedia)) return parse_media(parser, context);
  if (parser.accept(Keyword::kDensity)) return parse_density(parser, context);
  if (parser.accept(Keyword::kColorMap)) return parse_colour_map(parser, context);
  if (parser.accept(Keyword::kPigmentMap)) return parse_pigment_map(parser, context);
  if (parser.accept(Keyword::kNormalMap)) return parse_normal_map(parser, context);
  if (parser.accept(Keyword::kSlopeMap)) return parse_slope_map(parser, context);
  if (parser.accept(Keyword::kTextureMap)) return parse_texture_map(parser, context);
  if (parser.accept(Keyword::kDensityMap)) return parse_density_map(parser, context);
  return std::nullopt;
}

bool accept_material_default(Parser& parser, MaterialContext& context) {
  if (parser.accept(Keyword::kTexture)) {
    const Ref<TextureDesc> texture = parse_texture(parser, context);
    if (texture->layers.back().is_patterned()) {
      parser.fail("the default texture cannot be a map of textures");
    }
    if (texture->layers.size() > 1) parser.fail("the default texture cannot be layered");
    context.default_texture = texture;
    return true;
  }
  context.in_default = true;
  const bool accepted = accept_own_part(parser, context, context.default_texture);
  context.in_default = false;
  return accepted;
}

}  // namespace lentray::parser
