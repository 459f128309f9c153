// Gives a built object its clips, its `inverse` and its gates: regions that a ray must enter to see the object
// (core/object/gated.h). Gates are the bounds that POV-Ray tests, and POV-Ray's box where it hides something. Also:
// which unions are replaced by their parts in the scene's list. World space.
// Source: measured on stock (tests/image/clip_boxes_test.cpp, tests/image/own_bounds_test.cpp,
// tests/unit/build_objects_test.cpp).
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

/// `out` is complete but for its clips, `inverse` and gates; with gates it is wrapped in a core::Gated. `outer` moves
/// the statement into the world. `make_region` builds a clipping or bounding object, in the world.
void set_limits(const ObjectDesc& object, const core::Transform& outer, const Standing& standing,
                const MakeRegion& make_region, std::unique_ptr<core::Object>& out);

/// Whether the parts of this object are entries of the scene's list instead of the object.
bool splits_on_list(const ObjectDesc& object);

}  // namespace lentray::parser
