// Gives a built object the limits that stock gives it. Clips cut its surface. Gates are regions that
// a ray must meet to see the object. A solid gate is the box beyond which its inside does not count.
// The kernel knows these alone (core/object/object.h). Also: which unions of the scene's list stand
// there in parts. World space.
// Source: measured on stock (tests/image/clip_boxes_test.cpp, tests/image/open_shapes_test.cpp,
// tests/unit/build_objects_test.cpp).
// Errors: none. Threads: any.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/object/object.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// Where an object is used.
struct Standing {
  bool on_list = false;       ///< an entry of the scene's list
  bool is_split = false;      ///< a union whose parts are entries of the list instead of itself
  bool is_part = false;       ///< in another object
  bool has_hierarchy = true;  ///< the scene has at least kHierarchyFrom objects and lights
  /// stock_box_in_world() of an object whose parts are gone; null: it is whole.
  const std::optional<core::Bounds>* known_box = nullptr;
};

using MakeRegion = std::function<std::shared_ptr<const core::Object>(const ObjectDesc&)>;

/// Gives an object its clips, its `inverse` and its gates. `out` is complete but for these. `outer` is what moves the
/// statement into the world; `make_region` builds what clips or bounds, in the world.
void set_limits(const ObjectDesc& object, const core::Transform& outer, const Standing& standing,
                const MakeRegion& make_region, core::Object& out);

/// Stock's box of the object in the world; nothing where parts of it have no geometry yet.
std::optional<core::Bounds> stock_box_in_world(const ObjectDesc& object,
                                               const core::Transform& outer);

/// The gates that an object has besides where inside() and trace() ask for it alone.
void set_gates_alone(const ObjectDesc& object, core::Object& out);

/// Whether the parts of this object of the scene's list come to hang in the list themselves.
bool splits_on_list(const ObjectDesc& object);

/// How many objects and lights the object is in the scene's list.
std::size_t count_on_list(const ObjectDesc& object);

/// Stock builds a hierarchy if objects and lights are at least so many; else it asks each for hits.
constexpr std::size_t kHierarchyFrom = 3;

}  // namespace lentray::parser
