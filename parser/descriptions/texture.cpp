#include "parser/descriptions/texture.h"

#include "parser/descriptions/interior.h"

namespace lentray::parser {
namespace {

/// A copy with its pattern transformed; null stays null.
template <typename Desc>
std::shared_ptr<Desc> moved(const Ref<Desc>& original, const core::Transform& transform) {
  if (!original) return nullptr;
  auto copy = std::make_shared<Desc>(*original);
  copy->pattern.transform(transform);
  return copy;
}

}  // namespace

core::Colour to_colour(const Number& number) {
  const auto at = [&](int i) { return static_cast<float>(number.v[number.size == 1 ? 0 : i]); };
  core::Colour colour{{at(0), at(1), at(2)}, 0.0f, 0.0f};
  if (number.size == 1 || number.size >= 4) colour.filter = at(3);
  if (number.size == 1 || number.size >= 5) colour.transmit = at(4);
  return colour;
}

Ref<PigmentDesc> transformed(const Ref<PigmentDesc>& pigment, const core::Transform& transform) {
  return moved(pigment, transform);
}

Ref<NormalDesc> transformed(const Ref<NormalDesc>& normal, const core::Transform& transform) {
  return moved(normal, transform);
}

Ref<DensityDesc> transformed(const Ref<DensityDesc>& density, const core::Transform& transform) {
  return moved(density, transform);
}

Ref<TextureDesc> transformed(const Ref<TextureDesc>& texture, const core::Transform& transform) {
  if (!texture || transform.is_identity()) return texture;
  auto copy = std::make_shared<TextureDesc>(*texture);
  for (TextureLayerDesc& layer : copy->layers) {
    if (layer.is_patterned()) {
      // Entries of a map are looked up at points that went through the pattern's placement.
      layer.pattern.transform(transform);
    } else {
      layer.pigment = transformed(layer.pigment, transform);
      layer.normal = transformed(layer.normal, transform);
    }
  }
  return copy;
}

Ref<TextureDesc> layered(const Ref<TextureDesc>& below, const Ref<TextureDesc>& above) {
  if (!below) return above;
  if (!above) return below;
  auto both = std::make_shared<TextureDesc>(*below);
  both->layers.insert(both->layers.end(), above->layers.begin(), above->layers.end());
  return both;
}

Ref<TextureDesc> standard_texture() {
  auto texture = std::make_shared<TextureDesc>();
  TextureLayerDesc layer;
  layer.pigment = std::make_shared<PigmentDesc>();
  layer.finish = std::make_shared<FinishDesc>();
  texture->layers.push_back(layer);
  return texture;
}

Ref<MediaDesc> transformed(const Ref<MediaDesc>& media, const core::Transform& transform) {
  if (!media) return nullptr;
  auto copy = std::make_shared<MediaDesc>(*media);
  for (Ref<DensityDesc>& density : copy->densities) density = transformed(density, transform);
  return copy;
}

Ref<InteriorDesc> transformed(const Ref<InteriorDesc>& interior, const core::Transform& transform) {
  if (!interior || interior->media.empty()) return interior;
  auto copy = std::make_shared<InteriorDesc>(*interior);
  for (Ref<MediaDesc>& media : copy->media) media = transformed(media, transform);
  return copy;
}

Ref<MaterialDesc> transformed(const Ref<MaterialDesc>& material, const core::Transform& transform) {
  if (!material) return nullptr;
  auto copy = std::make_shared<MaterialDesc>(*material);
  copy->texture = transformed(material->texture, transform);
  copy->interior_texture = transformed(material->interior_texture, transform);
  copy->interior = transformed(material->interior, transform);
  return copy;
}

}  // namespace lentray::parser
