#include "parser/compile/cutaways.h"

#include "core/object/gated.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace lentray::parser {
namespace {

using Part = core::CutawayTexture::Part;

core::Csg* as_csg(core::Object& object, const ObjectDesc& desc) {
  return desc.csg() ? static_cast<core::Csg*>(&object) : nullptr;
}

/// What an inversion has made another kind of CSG: stock forgets there that it was a difference,
/// and that parts have textures.
bool is_changed(const core::Csg& csg, CsgOperation operation) {
  return csg.kind() != csg_kind(operation);
}

bool intersects(core::CsgKind kind) {
  return kind == core::CsgKind::kIntersection || kind == core::CsgKind::kDifference;
}

bool has_element_textures(const ObjectDesc& desc) {
  const auto* blob = std::get_if<std::shared_ptr<const BlobShape>>(&desc.shape);
  return blob && (*blob)->has_textures();
}

/// For a text, for its glyphs too.
void set_texture(core::Object& object, const core::Texture* texture) {
  core::Attributes looks = object.attributes();
  looks.texture = texture;
  object.set_attributes(looks);
  if (auto* csg = dynamic_cast<core::Csg*>(&object)) {
    for (const auto& child : csg->children()) set_texture(*child, texture);
  }
}

}  // namespace

core::CsgKind csg_kind(CsgOperation operation) {
  switch (operation) {
    case CsgOperation::kMerge: return core::CsgKind::kMerge;
    case CsgOperation::kIntersection: return core::CsgKind::kIntersection;
    case CsgOperation::kDifference: return core::CsgKind::kDifference;
    case CsgOperation::kUnion:
    case CsgOperation::kLightGroup: break;
  }
  return core::CsgKind::kUnion;
}

/// What holds for the parts of an object.
struct Cutaways::Around {
  std::optional<Ref<TextureDesc>> texture;  ///< inherited; empty: none, not even the default
  bool cutaway = false;                     ///< one of the objects around says so
  bool intersects = false;                  ///< the parent is an intersection or difference
  bool in_whole = false;                    ///< below the CSG whose parts are asked for
};

struct Cutaways::Pass {
  const Compile& compile;
  const Keep& keep;
  double least;
  std::vector<core::Object*> bare;  ///< without a texture, below the current whole
};

bool Cutaways::occur_in(const ObjectDesc& object) {
  const CsgShape* csg = object.csg();
  return csg && (csg->cutaway_textures ||
                 std::any_of(csg->children->begin(), csg->children->end(),
                             [](const Ref<ObjectDesc>& child) { return occur_in(*child); }));
}

void Cutaways::record(const core::Object& object, const ObjectDesc& desc, Ref<TextureDesc> own) {
  m_records[&object] = {&desc, std::move(own)};
}

void Cutaways::apply(core::Object& whole, Ref<TextureDesc> inherited, const Compile& compile,
                     const Keep& keep, double least) const {
  Around nothing;
  if (inherited) nothing.texture = std::move(inherited);
  Pass pass{compile, keep, least, {}};
  walk(core::ungated(whole), nothing, pass);
}

/// Whether the object or a part of it has been given a texture.
bool Cutaways::textured(const core::Object& object) const {
  const auto& [desc, own] = m_records.at(&object);
  if (!desc->csg()) return own != nullptr;
  const auto& csg = static_cast<const core::Csg&>(object);
  if (is_changed(csg, desc->csg()->operation)) return false;
  if (own) return true;
  return std::any_of(csg.children().begin(), csg.children().end(),
                     [this](const auto& child) { return textured(core::ungated(*child)); });
}

Part Cutaways::walk(core::Object& object, const Around& around, Pass& pass) const {
  const auto& [desc, own] = m_records.at(&object);
  Around below = around;
  if (own) below.texture = own;
  // Only a direct part of such a CSG goes without the default texture.
  const bool may_be_bare = around.cutaway && around.intersects;
  if (!below.texture && !may_be_bare && !textured(object)) below.texture = nullptr;
  Part part{&object, nullptr, false, {}};
  core::Csg* csg = as_csg(object, *desc);
  if (!csg) {
    if (below.texture) {
      part.texture = pass.compile(*below.texture);
    } else if (may_be_bare && !has_element_textures(*desc)) {
      pass.bare.push_back(&object);
    }
    return part;
  }
  const bool changed = is_changed(*csg, desc->csg()->operation);
  below.cutaway = around.cutaway || desc->csg()->cutaway_textures;
  below.intersects = intersects(csg->kind());
  // Unions leave the parts to themselves, unless they clip them.
  below.in_whole = around.in_whole || csg->kind() != core::CsgKind::kUnion || !csg->clips().empty();
  part.only_first = desc->csg()->operation == CsgOperation::kDifference && !changed;
  for (const auto& child : csg->children())
    part.parts.push_back(walk(core::ungated(*child), below, pass));
  if (below.in_whole && !around.in_whole && !pass.bare.empty()) {
    const auto texture = std::make_shared<const core::CutawayTexture>(std::move(part), pass.least);
    pass.keep(texture);
    for (core::Object* bare : pass.bare) set_texture(*bare, texture.get());
    pass.bare.clear();
    return {};
  }
  return part;
}

}  // namespace lentray::parser
