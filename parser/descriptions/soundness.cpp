#include "parser/descriptions/soundness.h"

#include <algorithm>

#include "parser/descriptions/texture.h"

namespace lentray::parser {
namespace {

bool is_plain(const Ref<TextureDesc>& texture) {
  if (!texture) return true;
  return std::all_of(
      texture->layers.begin(), texture->layers.end(),
      [](const TextureLayerDesc& layer) { return layer.is_plain() && !layer.finish->subsurface; });
}

struct SimpleShape {
  const Ref<TextureDesc>& default_texture;

  bool operator()(const SphereShape&) const { return true; }
  bool operator()(const BoxShape&) const { return true; }
  bool operator()(const PlaneShape&) const { return true; }
  bool operator()(const CylinderShape&) const { return true; }
  bool operator()(const ConeShape&) const { return true; }
  bool operator()(const TorusShape&) const { return true; }
  bool operator()(const DiscShape&) const { return true; }
  bool operator()(const TriangleShape&) const { return true; }
  bool operator()(const Sparse<SmoothTriangleShape>&) const { return true; }
  bool operator()(const Sparse<QuadricShape>&) const { return true; }
  bool operator()(const std::shared_ptr<const MeshShape>& mesh) const {
    return std::all_of(mesh->textures.begin(), mesh->textures.end(), is_plain);
  }
  bool operator()(const CsgShape& csg) const {
    return csg.operation != CsgOperation::kLightGroup && !csg.cutaway_textures &&
           std::all_of(
               csg.children->begin(), csg.children->end(),
               [&](const Ref<ObjectDesc>& child) { return is_sound(*child, default_texture); });
  }
  template <typename Other>
  bool operator()(const Other&) const {
    return false;
  }
};

}  // namespace

bool is_sound(const ObjectDesc& object, const Ref<TextureDesc>& default_texture) {
  const RareParts& rare = *object.rare;
  if (rare.interior || !rare.clipped_by.empty() || !rare.bounded_by.empty()) return false;
  return is_plain(object.texture ? object.texture : default_texture) &&
         is_plain(rare.interior_texture) && std::visit(SimpleShape{default_texture}, object.shape);
}

}  // namespace lentray::parser
