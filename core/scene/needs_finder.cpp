#include "core/scene/needs_finder.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <typeinfo>
#include <utility>

#include "core/object/csg.h"
#include "core/object/gated.h"
#include "core/object/leaf.h"
#include "core/shape/mesh.h"

namespace lentray::core {
namespace {

const Mesh* mesh_of(const Leaf& leaf) {
  const Shape& shape = leaf.shape();
  return typeid(shape) == typeid(Mesh) ? static_cast<const Mesh*>(&shape) : nullptr;
}

/// Every texture that a leaf's surface may show.
template <class Visit>
void visit_textures(const Leaf& leaf, Visit&& visit) {
  const Attributes& attributes = leaf.attributes();
  if (attributes.texture) visit(*attributes.texture);
  if (attributes.interior_texture) visit(*attributes.interior_texture);
  if (const Mesh* mesh = mesh_of(leaf)) {
    for (const Texture* texture : mesh->textures()) {
      if (texture) visit(*texture);
    }
  }
}

/// Whether visit(leaf) answers true for every one; ends at the first other.
template <class Visit>
bool every_leaf(const Object& object, Visit&& visit) {
  if (typeid(object) == typeid(Leaf)) return visit(static_cast<const Leaf&>(object));
  std::vector<const Leaf*> leaves;
  object.leaves(leaves);
  return std::all_of(leaves.begin(), leaves.end(), [&](const Leaf* leaf) { return visit(*leaf); });
}

bool is_opaque(const Leaf& leaf) {
  bool opaque = true;
  visit_textures(leaf, [&](const Texture& texture) { opaque = opaque && texture.is_opaque(); });
  return opaque;
}

/// Tells whether a leaf is of the last one's kind and shows the same, as most are. Never of meshes:
/// their faces have textures of their own.
class LikeTheLast {
 public:
  bool operator()(const Leaf& leaf) {
    const Shape& shape = leaf.shape();
    const Attributes& a = leaf.attributes();
    if (&typeid(shape) == m_shape && a.texture == m_texture &&
        a.interior_texture == m_interior_texture && a.interior == m_interior) {
      return true;
    }
    m_shape = mesh_of(leaf) ? nullptr : &typeid(shape);
    m_texture = a.texture;
    m_interior_texture = a.interior_texture;
    m_interior = a.interior;
    return false;
  }

 private:
  const std::type_info* m_shape = nullptr;
  const Texture* m_texture = nullptr;
  const Texture* m_interior_texture = nullptr;
  const Interior* m_interior = nullptr;
};

class Finder {
 public:
  explicit Finder(const SceneParts& parts) : m_parts(parts) {}

  Needs run() {
    for (const auto& object : m_parts.objects) look_at_object(*object);
    for (const Light& light : m_parts.lights) look_at_light(light);
    m_needs.sky_sphere = m_parts.sky_sphere && !m_parts.sky_sphere->pigments.empty();
    m_needs.atmosphere = !m_parts.atmosphere.is_empty();
    const Atmosphere& air = m_parts.atmosphere;
    if (!air.media.empty()) m_needs.media = true;
    m_needs.dimming_air = (!air.fogs.empty() || !air.media.empty()) && any_light_dimmed_by_air();
    // Air is where no solid is.
    if (m_needs.atmosphere || m_needs.media) m_needs.interiors = true;
    if (m_parts.settings.atmosphere_ior != 1.0 && m_needs.transparency) m_needs.refraction = true;
    m_needs.greatest_depth = m_needs.reflection || m_needs.transparency || m_needs.subsurface
                                 ? std::max(1, m_parts.settings.max_trace_level)
                                 : 1;
    return std::move(m_needs);
  }

 private:
  void look_at_object(const Object& object) {
    const Attributes& a = object.attributes();
    if (a.no_image || a.no_reflection || a.no_radiosity || a.no_shadow)
      m_needs.visibility_flags = true;
    const bool filters = !object.is_opaque() && !a.no_shadow;
    if (filters) m_needs.transparent_shadows = true;
    look_at_structure(object);
    every_leaf(object, [&](const Leaf& leaf) {
      look_at_leaf(leaf);
      if (filters && !leaf.shape().traits().tells_all) m_needs.shadows_begin_anew = true;
      return true;
    });
  }

  void look_at_structure(const Object& object) {
    if (typeid(object) == typeid(Gated))
      return look_at_structure(static_cast<const Gated&>(object).content());
    if (!object.clips().empty()) m_needs.clipping = true;
    if (typeid(object) == typeid(Csg)) {
      m_needs.csg = true;
      for (const auto& child : static_cast<const Csg&>(object).children())
        look_at_structure(*child);
    }
    if (object.attributes().interior) look_at_interior(*object.attributes().interior);
  }

  void look_at_leaf(const Leaf& leaf) {
    count_name(leaf.name());
    if (m_like_the_last(leaf)) return;
    const Attributes& a = leaf.attributes();
    if (a.interior) look_at_interior(*a.interior);
    if (a.interior_texture && a.interior_texture != a.texture) m_needs.interior_textures = true;
    const bool opaque = is_opaque(leaf);
    if (!opaque) {
      m_needs.transparency = true;
      if (a.interior && a.interior->ior != 1.0) m_needs.refraction = true;
      if (a.interior && a.interior->dispersion != 1.0) m_needs.dispersion = true;
    }
    if (const Mesh* mesh = mesh_of(leaf)) {
      if (mesh->has_textures()) m_needs.textures_by_place = true;
    }
    visit_textures(leaf, [&](const Texture& texture) { look_at_texture(texture); });
  }

  void look_at_interior(const Interior& interior) {
    m_needs.interiors = true;
    if (!interior.media.empty()) m_needs.media = true;
  }

  bool any_light_dimmed_by_air() const {
    return std::any_of(m_parts.lights.begin(), m_parts.lights.end(),
                       [](const Light& light) { return light.dimmed_by_air; });
  }

  /// Most leaves are of the last one's kind and look like it.
  void count_name(std::string_view name) {
    if (!m_counted || name != m_name) {
      m_name = name;
      m_counted = &m_needs.primitives[std::string(name)];
    }
    ++*m_counted;
  }

  void look_at_texture(const Texture& texture) {
    if (const LayeredTexture* stack = texture.everywhere()) return look_at_stack(*stack);
    if (!m_seen.insert(&texture).second) return;
    m_needs.textures_by_place = true;
    std::vector<const LayeredTexture*> stacks;
    texture.collect(stacks);
    for (const LayeredTexture* stack : stacks) look_at_stack(*stack);
  }

  void look_at_stack(const LayeredTexture& stack) {
    if (stack.layers().size() > 1) m_needs.layered_textures = true;
    for (const TextureLayer& layer : stack.layers()) look_at_finish(*layer.finish);
  }

  void look_at_finish(const Finish& finish) {
    if (!finish.reflection_max.is_black() || !finish.reflection_min.is_black()) {
      m_needs.reflection = true;
    }
    if (finish.subsurface) m_needs.subsurface = true;
    if (finish.phong != 0.0 || finish.specular != 0.0) m_needs.highlights = true;
  }

  void look_at_light(const Light& light) {
    if (light.has_area) m_needs.area_lights = true;
    if (light.illuminates_by_area()) m_needs.area_illumination = true;
    if (light.projector) m_needs.projected_lights = true;
    if (light.kind != Light::Kind::kPoint) m_needs.spot_lights = true;
    if (light.fade_power != 0.0 && light.fade_distance != 0.0) m_needs.fading_lights = true;
    if (light.shadowless) m_needs.shadowless_lights = true;
  }

  const SceneParts& m_parts;
  std::set<const Texture*> m_seen;
  LikeTheLast m_like_the_last;
  std::string_view m_name;  ///< counted last, in *m_counted
  std::size_t* m_counted = nullptr;
  Needs m_needs;
};

}  // namespace

void set_opacity(const std::vector<std::unique_ptr<Object>>& objects) {
  LikeTheLast like_the_last;
  bool last = true;
  for (const auto& object : objects) {
    object->set_opaque(every_leaf(*object, [&](const Leaf& leaf) {
      if (!like_the_last(leaf)) last = is_opaque(leaf);
      return last;
    }));
  }
}

Needs find_needs(const SceneParts& parts) { return Finder(parts).run(); }

Needs everything_needed(Needs found, const SceneSettings& settings) {
  Needs all;
  for (const auto& [name, feature] : kNeededFeatures) all.*feature = true;
  all.primitives = std::move(found.primitives);
  all.shadows_begin_anew = found.shadows_begin_anew;  // this alone changes what is found
  all.greatest_depth = std::max(1, settings.max_trace_level);
  return all;
}

}  // namespace lentray::core
