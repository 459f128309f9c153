#include "parser/grammar/nesting.h"

#include <string>

#include "parser/descriptions/light.h"

namespace lentray::parser {
namespace {

Nesting nesting_of(const FunctionDesc& function) { return {function.depth, function.calls}; }
Nesting nesting_of(const ObjectDesc& object) { return object.nesting; }

template <typename Desc>
void hold_each(Nesting& nesting, const std::vector<Ref<Desc>>& all) {
  for (const Ref<Desc>& one : all) nesting.hold(nesting_of(*one));
}

template <typename Desc>
void hold_one(Nesting& nesting, const Ref<Desc>& one) {
  if (one) nesting.hold(nesting_of(*one));
}

// What only some shapes hold.
struct HoldShape {
  Nesting& nesting;
  void operator()(const CsgShape& csg) const { hold_each(nesting, *csg.children); }
  void operator()(const LightShape& light) const {
    hold_one(nesting, light.light->looks_like);
    hold_one(nesting, light.light->projected_through);
  }
  void operator()(const std::shared_ptr<const MeshShape>& mesh) const {
    hold_each(nesting, mesh->textures);
  }
  void operator()(const std::shared_ptr<const BlobShape>& blob) const {
    for (const BlobElement& element : blob->elements) hold_one(nesting, element.texture);
  }
  void operator()(const Sparse<HeightFieldShape>& field) const {
    hold_one(nesting, field->function);
    hold_one(nesting, field->pigment);
  }
  void operator()(const Sparse<IsosurfaceShape>& shape) const {
    hold_one(nesting, shape->function);
  }
  void operator()(const Sparse<ParametricShape>& shape) const {
    for (const auto& function : shape->functions) hold_one(nesting, function);
  }
  template <typename Shape>
  void operator()(const Shape&) const {}
};

}  // namespace

Nesting nesting_of(const TextureDesc& texture) {
  Nesting nesting;
  for (const TextureLayerDesc& layer : texture.layers) {
    if (layer.is_patterned()) {
      nesting.hold(layer.pattern->nesting);
    } else {
      hold_one(nesting, layer.pigment);
      hold_one(nesting, layer.normal);
    }
  }
  return nesting;
}

Nesting nesting_of(const InteriorDesc& interior) {
  Nesting nesting;
  for (const Ref<MediaDesc>& media : interior.media) hold_each(nesting, media->densities);
  return nesting;
}

Nesting held_by(const PatternDesc& pattern) {
  Nesting nesting;
  hold_one(nesting, pattern.own->pigment);
  hold_one(nesting, pattern.own->object);
  hold_one(nesting, pattern.own->function);
  if (pattern.own->image) hold_one(nesting, pattern.own->image->function);
  return nesting;
}

void keep_nesting(Parser& parser, Nesting& place, const Nesting& counted, const Location& where,
                  std::string_view what) {
  const Limits& limits = parser.options().limits;
  if (counted.depth > parser.most_levels()) {
    parser.fail_at(where, std::string(what) + " within each other, more than " +
                              std::to_string(parser.most_levels()) + " deep");
  }
  if (counted.parts > limits.object_parts) {
    parser.fail_at(where, std::string(what) + " made of too many others");
  }
  parser.note_levels(counted.depth);
  place = counted;
}

void measure(Parser& parser, ObjectDesc& object) {
  Nesting nesting;
  std::visit(HoldShape{nesting}, object.shape);
  hold_one(nesting, object.texture);
  if (object.rare.is_stored()) {
    const RareParts& rare = *object.rare;
    hold_each(nesting, rare.clipped_by);
    hold_each(nesting, rare.bounded_by);
    hold_one(nesting, rare.interior_texture);
    hold_one(nesting, rare.interior);
  }
  keep_nesting(parser, object.nesting, nesting, object.where, "objects");
}

void check_layers(Parser& parser, const TextureDesc& texture) {
  const std::size_t most = parser.options().limits.layers;
  if (texture.layers.size() > most) {
    parser.fail("a texture of more than " + std::to_string(most) + " layers");
  }
}

}  // namespace lentray::parser
