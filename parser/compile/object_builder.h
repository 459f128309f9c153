// Object descriptions -> objects of the kernel, in world space, materials inherited through CSG.
// One builder a scene, one thread. Source: reference manual 3.7, "Object Modifiers"; the rules of
// inheritance measured on stock (tests/unit/object/build_objects_test.cpp).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "parser/compile/cutaways.h"
#include "parser/compile/object_places.h"
#include "parser/compile/slope_watches.h"
#include "parser/compile/texture_compiler.h"
#include "parser/descriptions/object.h"
#include "parser/descriptions/scene.h"
#include "parser/shapes/text_shape.h"
#include "parser/source/diagnostics.h"

namespace lentray::parser {

/// What is missing so far: SDL's word for it, and the first place that asked for it.
using NotYet = std::map<std::string, Location>;

class LightScope;

class ObjectBuilder {
 public:
  /// Objects with materials: textures and interiors go to `parts`, lights and the objects that lights
  /// look like too.
  ObjectBuilder(core::SceneParts& parts, TextureCompiler& textures, NotYet& not_yet);
  /// Geometry alone: attributes stay empty, lights are left out.
  explicit ObjectBuilder(NotYet& not_yet);

  /// Gets the places of the objects of the parts' list; null: nobody wants them.
  void set_places(ObjectPlaces* places) { m_places = places; }
  /// One statement of the scene level: appends to the parts. Parts of a union that nobody else refers to
  /// are let go of as soon as they are built.
  void add(SceneObject& object);

  /// Geometry alone of one object; null if nothing of it is rendered.
  std::unique_ptr<core::Object> geometry(const ObjectDesc& object,
                                         const core::Transform& to_world = core::Transform());

  const SlopeWatches& slope_watches() const { return m_slope_watches; }

 private:
  /// What an object takes over from the CSG around it.
  struct Inherited {
    Ref<TextureDesc> texture, interior_texture;  ///< in world space already
    const core::Interior* interior = nullptr;
    std::optional<bool> hollow, double_illuminate;
    bool uv_mapping = false;
    bool no_shadow = false, no_image = false, no_reflection = false, no_radiosity = false;
    std::uint32_t pass_flags = 0;        ///< their number in the parts
    const LightScope* lights = nullptr;  ///< null: in no light_group
    std::optional<bool> shared_hollow;   ///< of all that have the same interior
    bool in_whole = false;               ///< is a part of something
    const ObjectDesc* named = nullptr;   ///< the outermost around it that comes from an identifier
    bool on_list = false;  ///< an entry of the scene's list: stock drops needless bounds there
  };

  /// Builds an entry of the scene's list.
  void add_to_list(const ObjectDesc& object, const core::Transform& outer, const Inherited& from);
  /// Throws BuildError.
  std::unique_ptr<core::Object> build(const ObjectDesc& object, const core::Transform& outer,
                                      const Inherited& from);
  std::unique_ptr<core::Object> build_whole(const ObjectDesc& object, const core::Transform& outer,
                                            const Inherited& from);
  std::unique_ptr<core::Object> build_csg(const ObjectDesc& object, const CsgShape& csg,
                                          const core::Transform& to_world, const Inherited& looks);
  std::unique_ptr<core::Object> build_leaf(const ObjectDesc& object,
                                           const core::Transform& to_world, const Inherited& looks);
  void add_element_textures(const BlobShape& blob, const core::Transform& to_world,
                            core::Object& out);
  std::unique_ptr<core::Object> build_text(const TextShape& text, const core::Transform& to_world,
                                           const Inherited& looks);
  std::unique_ptr<core::Object> build_light_group(const ObjectDesc& object, const CsgShape& csg,
                                                  const core::Transform& to_world,
                                                  const Inherited& looks);
  void add_light(const ObjectDesc& object, const core::Transform& to_world, bool grouped);
  void add_looks_like(const ObjectDesc& object, const core::Transform& to_world,
                      const Inherited& from);
  const core::LightSelection* selection(const LightScope& scope);
  Inherited resolve(const ObjectDesc& object, const core::Transform& outer, const Inherited& from);
  void take_aim(const ObjectDesc& object, const core::Transform& outer, Inherited& looks);
  core::Attributes attributes(const Inherited& looks);
  std::uint32_t number_of(const core::PassFlags& flags);
  std::uint32_t pass_flags_over(std::uint32_t around, const RareParts& own);
  const core::Texture* compile(const Ref<TextureDesc>& texture);
  Ref<TextureDesc> moved(const Ref<TextureDesc>& texture, const core::Transform& transform);
  void let_go(Ref<ObjectDesc>& child);
  void note(const std::string& feature, const Location& where) {
    m_not_yet.try_emplace(feature, where);
  }

  bool has_materials() const { return m_parts; }

  core::SceneParts* m_parts = nullptr;  ///< null: geometry alone, without materials and lights
  TextureCompiler* m_textures = nullptr;
  NotYet& m_not_yet;
  ObjectPlaces* m_places = nullptr;
  TextLayout m_texts;
  SlopeWatches m_slope_watches;
  Ref<TextureDesc> m_default;
  Children* m_used_up = nullptr;  ///< of the object being built, those to be let go of; null: none
  std::shared_ptr<Cutaways> m_cutaways;  ///< of the object being built; null: it has none
  /// What was compiled last, with the default as it is: most objects look like the one before.
  struct Last {
    Ref<TextureDesc> texture;
    const core::Texture* made = nullptr;
  };
  Last m_last;
  /// Textures by origin and transform, so that equal parts share what is compiled.
  std::map<std::pair<Ref<TextureDesc>, core::Matrix>, Ref<TextureDesc>> m_moved;
  std::map<core::PassFlags, std::uint32_t> m_pass_flags;
  std::map<std::pair<bool, std::vector<std::uint32_t>>, const core::LightSelection*> m_selections;
};

}  // namespace lentray::parser
