#include "parser/descriptions/texture.h"

#include <algorithm>
#include <utility>

#include "parser/descriptions/interior.h"

namespace lentray::parser {

core::Colour to_colour(const Number& number) {
  const auto at = [&](int i) { return static_cast<float>(number.v[number.size == 1 ? 0 : i]); };
  core::Colour colour{{at(0), at(1), at(2)}, 0.0f, 0.0f};
  if (number.size == 1 || number.size >= 4) colour.filter = at(3);
  if (number.size == 1 || number.size >= 5) colour.transmit = at(4);
  return colour;
}

Ref<TextureDesc> transformed(Ref<TextureDesc> texture, const core::Transform& transform) {
  if (!texture || transform.is_identity()) return texture;
  for (TextureLayerDesc& layer : edit(texture).layers) {
    if (layer.is_patterned()) {
      // Entries of a map are looked up at points that went through the pattern's placement.
      layer.pattern.edit().transform(transform);
    } else {
      layer.pigment = transformed(std::move(layer.pigment), transform);
      layer.normal = transformed(std::move(layer.normal), transform);
    }
  }
  return texture;
}

bool can_wait(const TextureDesc& texture) {
  const auto pattern_can = [](const PatternDesc& pattern) {
    return pattern.placement.empty() || pattern.placement.back().kind != WarpDesc::Kind::kTransform;
  };
  return std::all_of(texture.layers.begin(), texture.layers.end(), [&](const TextureLayerDesc& l) {
    return l.is_patterned()
               ? pattern_can(*l.pattern)
               : pattern_can(l.pigment->pattern) && (!l.normal || pattern_can(l.normal->pattern));
  });
}

bool is_placeless(const TextureDesc& texture) {
  return std::all_of(texture.layers.begin(), texture.layers.end(),
                     [](const TextureLayerDesc& layer) { return layer.is_plain(); });
}

Ref<TextureDesc> layered(Ref<TextureDesc> below, Ref<TextureDesc> above) {
  if (!below) return above;
  if (!above) return below;
  auto& layers = edit(below).layers;
  layers.insert(layers.end(), above->layers.begin(), above->layers.end());
  return below;
}

Ref<TextureDesc> standard_texture() {
  auto texture = std::make_shared<TextureDesc>();
  TextureLayerDesc layer;
  layer.pigment = std::make_shared<PigmentDesc>();
  layer.finish = std::make_shared<FinishDesc>();
  texture->layers.push_back(layer);
  return texture;
}

Ref<MediaDesc> transformed(Ref<MediaDesc> media, const core::Transform& transform) {
  if (!media) return nullptr;
  for (Ref<DensityDesc>& density : edit(media).densities)
    density = transformed(std::move(density), transform);
  return media;
}

Ref<InteriorDesc> transformed(Ref<InteriorDesc> interior, const core::Transform& transform) {
  if (!interior || interior->media.empty()) return interior;
  for (Ref<MediaDesc>& media : edit(interior).media)
    media = transformed(std::move(media), transform);
  return interior;
}

}  // namespace lentray::parser
