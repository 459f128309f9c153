// The limits of an object as stock has them, derived from its description once it is built: its clips, the gates that
// rays must meet to see it, the box that stands for the bounds of its solid, and how the scene's list holds it.
// Where stock drops a bound, or takes a box for an object that stands out of it, the gates say so; the kernel knows
// gates alone (core/object/object.h).
// Source: measured on stock (tests/image/clip_boxes_test.cpp, open_shapes_test.cpp, unit/build_objects_test.cpp).
// Errors: none. Threads: any.
#pragma once

#include <functional>
#include <memory>

#include "core/object/object.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// Where an object is used.
struct Standing {
  bool on_list = false;       ///< in the scene's list
  bool is_split = false;      ///< its parts are there in its place
  bool is_part = false;       ///< in another object
  bool has_hierarchy = true;  ///< of the scene: else stock asks each object for hits
};

using MakeRegion = std::function<std::shared_ptr<const core::Object>(const ObjectDesc&)>;

/// Gives an object its clips, its `inverse` and its gates. `out` is complete but for these. `outer` is what moves the
/// statement into the world; `make_region` builds what clips or bounds, in the world.
void set_limits(const ObjectDesc& object, const core::Transform& outer, const Standing& standing,
                const MakeRegion& make_region, core::Object& out);

/// The gates that an object has besides where inside() and trace() ask for it alone.
void set_gates_alone(const ObjectDesc& object, core::Object& out);

/// Whether the parts of this object of the scene's list come to hang in the list themselves.
bool splits_on_list(const ObjectDesc& object);

/// How many objects and lights the object is in the scene's list.
std::size_t count_on_list(const ObjectDesc& object);

/// From so many objects and lights on stock makes a hierarchy.
constexpr std::size_t kHierarchyFrom = 3;

}  // namespace lentray::parser
