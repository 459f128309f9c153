#include "parser/compile/object_builder.h"

#include <algorithm>
#include <new>
#include <utility>

#include "core/material/blob_texture.h"
#include "core/object/csg.h"
#include "core/object/leaf.h"
#include "core/shape/isosurface.h"
#include "parser/base/edit.h"
#include "parser/compile/light_scope.h"
#include "parser/compile/lights.h"
#include "parser/compile/photons.h"
#include "parser/shapes/blob_fields.h"
#include "parser/shapes/shape_geometry.h"
#include "parser/shapes/shapes.h"
#include "parser/shapes/text_shape.h"
#include "parser/source/build_error.h"
#include "parser/stock/gates.h"

namespace lentray::parser {
namespace {

/// Parts without an interior of their own share the whole's, and the last of them says for all whether it is
/// hollow.
std::optional<bool> shared_hollow(const ObjectDesc& object, std::optional<bool> from) {
  if (object.hollow) from = object.hollow;
  const CsgShape* csg = object.csg();
  if (!csg) return from.value_or(false);
  for (auto child = csg->children->rbegin(); child != csg->children->rend(); ++child) {
    if ((*child)->is_light() || (*child)->rare->interior) continue;
    if (const auto hollow = shared_hollow(**child, from)) return hollow;
  }
  return std::nullopt;
}

/// What a part says itself, over what it has from the objects around it: those count first.
void take_photons(const PhotonFlags& own, core::PassFlags& flags) {
  const bool is_refracting_target =
      flags.photon_target > 0.0 && flags.photon_refraction.value_or(false);
  if (own.pass_through && !is_refracting_target) flags.photon_pass_through = true;
  if (!own.collect) flags.photon_collect = false;
  if (!flags.photon_reflection) flags.photon_reflection = own.reflection;
  if (!flags.photon_refraction) flags.photon_refraction = own.refraction;
  if (own.target && flags.photon_target == 0.0) flags.photon_target = own.density;
}

/// The parts of a union that become entries of the scene's list, if nobody else refers to them; else null.
Children* sole_children(Ref<ObjectDesc>& object) {
  if (!splits_on_list(*object) || object.use_count() != 1 || Cutaways::occur_in(*object))
    return nullptr;
  auto& csg = std::get<CsgShape>(edit(object).shape);
  return csg.children.use_count() == 1 ? &edit(csg.children) : nullptr;
}

}  // namespace

ObjectBuilder::ObjectBuilder(core::SceneParts& parts, TextureCompiler& textures, NotYet& not_yet)
    : m_parts(&parts), m_textures(&textures), m_not_yet(not_yet) {}

ObjectBuilder::ObjectBuilder(NotYet& not_yet) : m_not_yet(not_yet) {}

void ObjectBuilder::add(SceneObject& object) {
  m_default = object.default_texture ? object.default_texture : standard_texture();
  Inherited nothing;
  nothing.on_list = true;
  // One for all objects, the last that was said.
  const double importance = m_parts->settings.radiosity
                                ? m_parts->settings.radiosity->default_importance
                                : object.default_importance;
  core::PassFlags flags;
  flags.importance = importance;
  nothing.pass_flags = number_of(flags);
  m_used_up = sole_children(object.object);
  add_to_list(*object.object, core::Transform(), nothing);
  m_used_up = nullptr;
  m_last = {};
  m_moved.clear();
}

void ObjectBuilder::add_to_list(const ObjectDesc& object, const core::Transform& outer,
                                const Inherited& from) {
  const auto around = std::exchange(
      m_cutaways, Cutaways::occur_in(object) ? std::make_shared<Cutaways>() : nullptr);
  auto built = build(object, outer, from);
  const auto cutaways = std::exchange(m_cutaways, around);
  if (!built) return;
  if (cutaways) {
    cutaways->apply(
        *built, from.texture, [this](const Ref<TextureDesc>& t) { return compile(t); },
        [this](auto texture) { m_parts->textures.push_back(std::move(texture)); },
        m_parts->settings.adc_bailout);
  }
  m_parts->objects.push_back(std::move(built));
  if (m_places) m_places->wholes.push_back({object.where, object.keyword});
}

std::unique_ptr<core::Object> ObjectBuilder::geometry(const ObjectDesc& object,
                                                      const core::Transform& to_world) {
  ObjectBuilder plain(m_not_yet);
  auto made = plain.build(object, to_world, {});
  if (made) core::complete(*made);
  return made;
}

Ref<TextureDesc> ObjectBuilder::moved(const Ref<TextureDesc>& texture,
                                      const core::Transform& transform) {
  if (!texture || transform.is_identity() || is_placeless(*texture)) return texture;
  if (texture.use_count() == 1) return transformed(texture, transform);  // no other part has it
  Ref<TextureDesc>& slot = m_moved[{texture, transform.rows()}];
  if (!slot) slot = transformed(texture, transform);
  return slot;
}

/// Looks and switches that hold for the object, in world space.
ObjectBuilder::Inherited ObjectBuilder::resolve(const ObjectDesc& object,
                                                const core::Transform& outer,
                                                const Inherited& from) {
  Inherited looks = from;
  looks.on_list = false;
  looks.no_shadow = from.no_shadow || object.no_shadow;
  looks.no_image = from.no_image || object.no_image;
  looks.no_reflection = from.no_reflection || object.no_reflection;
  looks.no_radiosity = from.no_radiosity || object.no_radiosity;
  if (object.hollow) looks.hollow = object.hollow;
  if (object.rare->interior || !from.in_whole)
    looks.shared_hollow = shared_hollow(object, from.hollow);
  looks.in_whole = true;
  // The outermost double_illuminate overrides those inside it.
  if (!from.double_illuminate) looks.double_illuminate = object.double_illuminate;
  if (!has_materials()) return looks;
  const core::Transform texture_move = object.uv_mapping ? core::Transform() : outer;
  // A part without a texture of its own takes its whole's with it.
  looks.uv_mapping = object.uv_mapping || (!object.texture && from.uv_mapping);
  if (object.texture_waits)
    looks.texture = moved(object.texture, object.transform->then(outer));
  else if (object.texture)
    looks.texture = moved(object.texture, texture_move);
  const RareParts& rare = *object.rare;
  if (rare.radiosity_importance || rare.photons.given) {
    looks.pass_flags = pass_flags_over(from.pass_flags, rare);
  }
  if (rare.interior_texture) looks.interior_texture = moved(rare.interior_texture, texture_move);
  if (rare.interior || (object.texture && !from.interior)) {
    Ref<InteriorDesc> interior = rare.interior;
    if (interior && !interior->media.empty()) interior = transformed(interior, outer);
    // Every object that has one has its own: stock distinguishes nested objects by it.
    if (const auto made = m_textures->interior(interior, looks.texture)) {
      m_parts->interiors.push_back(std::make_shared<const core::Interior>(*made));
      looks.interior = m_parts->interiors.back().get();
    }
  }
  return looks;
}

/// Photons are shot at the outermost object that is a target and hangs together.
void ObjectBuilder::take_aim(const ObjectDesc& object, const core::Transform& outer,
                             Inherited& looks) {
  if (!has_materials() || looks.pass_flags == 0) return;
  core::PassFlags flags = m_parts->pass_flags[looks.pass_flags];
  if (!(flags.photon_target > 0.0) || flags.photon_target_number > 0) return;
  if (looks.lights && !looks.lights->global()) return;
  m_parts->photon_targets.push_back(photon_target(object, outer, flags));
  flags.photon_target_number = static_cast<std::uint32_t>(m_parts->photon_targets.size());
  looks.pass_flags = number_of(flags);
}

const core::Texture* ObjectBuilder::compile(const Ref<TextureDesc>& texture) {
  if (m_last.made && m_last.texture == texture) return m_last.made;
  m_last = {texture, m_textures->texture(texture, m_default).get()};
  return m_last.made;
}

core::Attributes ObjectBuilder::attributes(const Inherited& looks) {
  core::Attributes a{.interior = looks.interior,
                     .pass_flags = looks.pass_flags,
                     .no_shadow = looks.no_shadow,
                     .no_image = looks.no_image,
                     .no_reflection = looks.no_reflection,
                     .no_radiosity = looks.no_radiosity,
                     .hollow = looks.shared_hollow.value_or(false),
                     .double_illuminate = looks.double_illuminate.value_or(false),
                     .uv_mapping = looks.uv_mapping};
  if (!has_materials()) return a;
  a.texture = compile(looks.texture);
  if (looks.interior_texture) a.interior_texture = compile(looks.interior_texture);
  if (looks.lights) a.lights = selection(*looks.lights);
  return a;
}

std::uint32_t ObjectBuilder::number_of(const core::PassFlags& flags) {
  if (flags == core::PassFlags()) return 0;
  const auto [at, is_new] =
      m_pass_flags.try_emplace(flags, static_cast<std::uint32_t>(m_parts->pass_flags.size()));
  if (is_new) m_parts->pass_flags.push_back(flags);
  return at->second;
}

std::uint32_t ObjectBuilder::pass_flags_over(std::uint32_t around, const RareParts& own) {
  core::PassFlags flags = m_parts->pass_flags[around];
  if (own.radiosity_importance) flags.importance = *own.radiosity_importance;
  if (own.photons.given) take_photons(own.photons, flags);
  return number_of(flags);
}

std::unique_ptr<core::Object> ObjectBuilder::build(const ObjectDesc& object,
                                                   const core::Transform& outer,
                                                   const Inherited& from) {
  try {
    return build_whole(object, outer, from);
  } catch (const BuildError&) {
    throw;  // of a part: its place is nearer
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw BuildError(object.where, error.what());
  }
}

std::unique_ptr<core::Object> ObjectBuilder::build_whole(const ObjectDesc& object,
                                                         const core::Transform& outer,
                                                         const Inherited& from) {
  const core::Transform to_world =
      object.transform.is_stored() ? object.transform->then(outer) : outer;
  if (object.is_light()) {
    if (has_materials()) {
      add_light(object, to_world, false);
      add_looks_like(object, to_world, from);
    }
    return nullptr;
  }
  Inherited looks = resolve(object, outer, from);
  const CsgShape* csg = object.csg();
  std::unique_ptr<core::Object> out;
  // The parts of an unclipped union of the scene's list become entries themselves.
  const bool is_split = from.on_list && splits_on_list(object);
  if (!is_split) take_aim(object, outer, looks);
  if (csg) {
    Inherited for_children = looks;
    for_children.on_list = is_split;
    if (!from.named && object.copied) for_children.named = &object;
    out = build_csg(object, *csg, to_world, for_children);
  } else {
    out = build_leaf(object, to_world, looks);
  }
  if (!out) return nullptr;
  out->set_attributes(attributes(looks));
  if (const auto* blob = std::get_if<std::shared_ptr<const BlobShape>>(&object.shape)) {
    add_element_textures(**blob, to_world, *out);
  }
  core::Object& content = *out;
  set_limits(
      object, outer, {from.on_list, is_split},
      [&](const ObjectDesc& region) { return geometry(region, outer); }, out);
  if (m_places && from.on_list && from.in_whole && !is_split) {
    const ObjectDesc& called = from.named ? *from.named : object;
    m_places->parts.push_back({out.get(), {called.where, called.keyword}});
  }
  if (m_cutaways) m_cutaways->record(content, object, object.texture ? looks.texture : nullptr);
  return out;
}

/// The memory of the description and of what was kept for its textures is used again by what is built next.
void ObjectBuilder::let_go(Ref<ObjectDesc>& child) {
  child = nullptr;
  constexpr long kKept = 2;  // by the compiler and here
  if (m_last.texture && m_last.texture.use_count() <= kKept) m_last = {};
  m_textures->forget_unused();
}

std::unique_ptr<core::Object> ObjectBuilder::build_csg(const ObjectDesc& object,
                                                       const CsgShape& csg,
                                                       const core::Transform& to_world,
                                                       const Inherited& looks) {
  if (csg.operation == CsgOperation::kLightGroup && has_materials()) {
    return build_light_group(object, csg, to_world, looks);
  }
  const LightScope scope(looks.lights, object.copied);
  Inherited for_children = looks;
  if (looks.lights) for_children.lights = &scope;
  std::vector<std::unique_ptr<core::Object>> children;
  bool first = true;
  const bool uses_up = csg.children.get() == m_used_up;
  for (std::size_t i = 0; i < csg.children->size(); ++i) {
    const ObjectDesc& child = *(*csg.children)[i];
    auto built = build(child, to_world, for_children);
    const bool is_light = child.is_light();
    if (uses_up) let_go((*m_used_up)[i]);
    // What the first part of a difference would be cut from is missing: so is the whole.
    if (!built && !is_light && first && csg.operation == CsgOperation::kDifference) return nullptr;
    if (!is_light) first = false;
    if (built) children.push_back(std::move(built));
  }
  if (children.empty()) return nullptr;
  auto whole = std::make_unique<core::Csg>(csg_kind(csg.operation), std::move(children));
  if (!csg.split_union) whole->keep_whole();
  return whole;
}

std::unique_ptr<core::Object> ObjectBuilder::build_leaf(const ObjectDesc& object,
                                                        const core::Transform& to_world,
                                                        const Inherited& looks) {
  if (const auto* text = std::get_if<Sparse<TextShape>>(&object.shape)) {
    return build_text(**text, to_world, looks);
  }
  if (const std::string missing = missing_function(object); !missing.empty()) {
    note(missing, object.where);
    return nullptr;
  }
  std::unique_ptr<core::Shape> shape;
  if (const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&object.shape)) {
    std::unique_ptr<core::Mesh> made = build_mesh(object, to_world);
    if (has_materials() && !(*mesh)->textures.empty()) {
      std::vector<const core::Texture*> textures;
      const core::Transform move = object.uv_mapping ? core::Transform() : to_world;
      for (const Ref<TextureDesc>& t : (*mesh)->textures)
        textures.push_back(compile(moved(t, move)));
      made->set_textures(std::move(textures));
    }
    shape = std::move(made);
  } else {
    shape = build_shape(object);
    const auto* surface = std::get_if<Sparse<IsosurfaceShape>>(&object.shape);
    if (surface && shape && has_materials()) {
      static_cast<core::Isosurface&>(*shape).set_watch(m_slope_watches.of(**surface, object.where));
    }
  }
  if (!shape) {
    note(std::string(object.keyword), object.where);
    return nullptr;
  }
  return std::make_unique<core::Leaf>(std::move(shape), to_world);
}

/// The textures of a blob's elements, mixed; those without have the blob's.
void ObjectBuilder::add_element_textures(const BlobShape& blob, const core::Transform& to_world,
                                         core::Object& out) {
  if (!has_materials() || !blob.has_textures()) return;
  core::Attributes looks = out.attributes();
  const std::shared_ptr<const core::Texture> own(std::shared_ptr<void>(), looks.texture);
  const std::vector<core::BlobField> fields = blob_fields(blob);
  std::vector<core::BlobTexture::Element> elements;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    core::BlobField field = fields[i];
    field.to_blob = field.to_blob.then(to_world);
    const Ref<TextureDesc>& texture = blob.elements[i].texture;
    elements.push_back(
        {field, texture ? m_textures->texture(moved(texture, to_world), m_default) : own});
  }
  const auto mixed =
      std::make_shared<const core::BlobTexture>(std::move(elements), m_parts->settings.adc_bailout);
  m_parts->textures.push_back(mixed);
  looks.texture = mixed.get();
  looks.interior_texture = nullptr;  // stock mixes those of the outside there too
  out.set_attributes(looks);
}

/// A union of its glyphs.
std::unique_ptr<core::Object> ObjectBuilder::build_text(const TextShape& text,
                                                        const core::Transform& to_world,
                                                        const Inherited& looks) {
  const LightScope scope(looks.lights, false);
  Inherited of_glyphs = looks;
  if (looks.lights) of_glyphs.lights = &scope;
  std::vector<std::unique_ptr<core::Object>> glyphs = text_glyphs(m_texts, text, to_world);
  for (const auto& glyph : glyphs) glyph->set_attributes(attributes(of_glyphs));
  if (glyphs.empty()) return nullptr;
  return std::make_unique<core::Csg>(core::CsgKind::kUnion, std::move(glyphs));
}

/// Its lights come first: they light what stands before them, too.
std::unique_ptr<core::Object> ObjectBuilder::build_light_group(const ObjectDesc& object,
                                                               const CsgShape& csg,
                                                               const core::Transform& to_world,
                                                               const Inherited& looks) {
  std::vector<std::uint32_t> lights;
  for (const Ref<ObjectDesc>& child : *csg.children) {
    if (!child->is_light()) continue;
    lights.push_back(static_cast<std::uint32_t>(m_parts->lights.size()));
    add_light(*child, child->transform->then(to_world), true);
  }
  const LightScope scope(looks.lights, object.copied, std::move(lights), csg.global_lights);
  Inherited for_children = looks;
  for_children.lights = &scope;
  std::vector<std::unique_ptr<core::Object>> children;
  for (const Ref<ObjectDesc>& child : *csg.children) {
    if (child->is_light()) {
      add_looks_like(*child, child->transform->then(to_world), for_children);
    } else if (auto built = build(*child, to_world, for_children)) {
      children.push_back(std::move(built));
    }
  }
  if (children.empty()) return nullptr;
  return std::make_unique<core::Csg>(core::CsgKind::kUnion, std::move(children));
}

void ObjectBuilder::add_light(const ObjectDesc& object, const core::Transform& to_world,
                              bool grouped) {
  const LightDesc& light = *std::get<LightShape>(object.shape).light;
  m_parts->lights.push_back(build_light(light, to_world));
  m_parts->lights.back().grouped = grouped;
  if (!light.projected_through) return;
  if (auto projector = geometry(*light.projected_through, to_world)) {
    m_parts->lights.back().projector = projector.get();
    m_parts->projectors.push_back(std::move(projector));
  }
}

void ObjectBuilder::add_looks_like(const ObjectDesc& object, const core::Transform& to_world,
                                   const Inherited& from) {
  const LightDesc& light = *std::get<LightShape>(object.shape).light;
  if (!light.looks_like) return;
  const LightScope scope = LightScope::of_light(from.lights);
  Inherited around = from;
  if (from.lights) around.lights = &scope;
  Inherited looks = resolve(object, to_world, around);
  looks.no_shadow = true;
  looks.in_whole = false;
  // The kernel's list holds it: a light in a CSG takes no part in the CSG.
  add_to_list(*light.looks_like, to_world, looks);
}

const core::LightSelection* ObjectBuilder::selection(const LightScope& scope) {
  core::LightSelection lights{scope.global(), scope.local()};
  const core::LightSelection*& slot = m_selections[{lights.global, lights.local}];
  if (!slot) {
    m_parts->light_selections.push_back(
        std::make_unique<const core::LightSelection>(std::move(lights)));
    slot = m_parts->light_selections.back().get();
  }
  return slot;
}

}  // namespace lentray::parser
