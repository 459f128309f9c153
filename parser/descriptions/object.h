// An object statement, read: a shape, its children, its modifiers. Plain data; shapes are in
// the space of their statement and `transform` leads out of it. Shared and never changed once
// made; whoever modifies copies first (children and big tables are shared, so copies are cheap).
// Source: reference manual 3.7, "Objects", "Object Modifiers".
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bounds.h"
#include "core/base/ray.h"
#include "core/base/transform.h"
#include "core/base/vec3.h"
#include "parser/base/sparse.h"
#include "parser/descriptions/light.h"
#include "parser/descriptions/nesting.h"
#include "parser/descriptions/placement.h"
#include "parser/descriptions/shapes.h"
#include "parser/source/source.h"
#include "parser/values/value.h"

namespace lentray::core {
class Object;
}

namespace lentray::parser {

using core::Vec2;
using core::Vec3;

/// The object compiled for inside(), trace() and the extents; a copy starts without it.
struct CompiledSlot {
  struct Compiled {
    std::shared_ptr<const core::Object> object;
    double farthest = core::kFarthest;  ///< up to which trace() sees it
  };
  std::shared_ptr<const Compiled> made;  ///< null: not tried yet
  CompiledSlot() = default;
  CompiledSlot(const CompiledSlot&) {}
  CompiledSlot& operator=(const CompiledSlot&) {
    made.reset();
    return *this;
  }
};

/// What few objects have. Apart, as there may be a million objects; named in dumps as if it were not.
struct RareParts {
  Ref<TextureDesc> interior_texture;  ///< null: the same as `texture`
  Ref<InteriorDesc> interior;         ///< null: inherited
  std::vector<Ref<ObjectDesc>> clipped_by, bounded_by;
  std::optional<double> radiosity_importance;
  PhotonFlags photons;
};

struct ObjectDesc {
  Location where;
  std::string_view keyword;  ///< of the statement, for messages; a reserved word
  ShapeDesc shape;
  Sparse<Placement> transform;

  // Looks and bounds have been moved by the transforms that followed them in the statement.
  Ref<TextureDesc> texture;  ///< null: inherited, at last the default texture
  Sparse<RareParts> rare;
  /// `transform` has still to move `texture`, which many objects may share.
  bool texture_waits = false;
  bool bounds_are_clips = false;  ///< bounded_by { clipped_by } or the other way round

  bool inverse = false;
  bool no_shadow = false, no_image = false, no_reflection = false, no_radiosity = false;
  std::optional<bool> double_illuminate;  ///< of a CSG: holds for everything in it
  std::optional<bool> hollow;             ///< unset: a surrounding CSG may set it
  bool sturm = false, hierarchy = true, uv_mapping = false;
  bool reopened = false;  ///< went through the braces of object {}
  bool copied = false;    ///< made from an identifier: of use to nested light groups

  Nesting nesting;  ///< objects and textures in it

  mutable CompiledSlot compiled;

  /// Whether its shape is of one of these kinds.
  template <typename... Shapes>
  bool is_any() const {
    return (std::holds_alternative<Shapes>(shape) || ...);
  }
  bool is_light() const { return is_any<LightShape>(); }
  const CsgShape* csg() const { return std::get_if<CsgShape>(&shape); }
};

/// Moves the texture now if it waits.
void settle_texture(ObjectDesc& object);

}  // namespace lentray::parser
