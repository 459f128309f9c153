// Gives a built object its clips, its `inverse` and its gates, which a ray must hit for the object to be seen
// (core/object/gated.h): its `bounded_by` where stock uses it, and stock's bounding box where the object exceeds it.
// Also: which unions of the scene's list are replaced by their parts there. World space.
// Source: measured on stock (tests/image/clip_boxes_test.cpp, tests/image/own_bounds_test.cpp,
// tests/unit/object/build_objects_test.cpp).
// Errors: none. Threads: any.
#pragma once

#include <functional>
#include <memory>

#include "core/object/object.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// Where an object is used.
struct Standing {
  bool on_list = false;   ///< an entry of the scene's list
  bool is_split = false;  ///< a union whose parts are entries of the list instead of itself
};

using MakeRegion = std::function<std::shared_ptr<const core::Object>(const ObjectDesc&)>;

/// `out` is complete but for these; it becomes a core::Gated around itself if it has gates. `outer` is what moves
/// the statement into the world; `make_region` builds what clips or bounds, in the world.
void set_limits(const ObjectDesc& object, const core::Transform& outer, const Standing& standing,
                const MakeRegion& make_region, std::unique_ptr<core::Object>& out);

/// Whether the parts of this object of the scene's list become entries of the list themselves.
bool splits_on_list(const ObjectDesc& object);

}  // namespace lentray::parser
