// Rays that miss stock's box of an object miss the object, whatever stands out of the box: what a
// height field clips, which has no lower end, quadrics for which stock counts too little, and what is cut by parts
// with bounds of their own.
// Source: measured on stock (tests/image/clip_boxes_test.cpp). Errors: none. Threads: any.
#pragma once

#include <memory>

#include "core/object/object.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

/// How stock comes to ask an object for hits.
enum class Reach {
  kPart,      ///< a part of a CSG: without a look at its box
  kOneByOne,  ///< the scene's list is so short that stock asks each object
  kByBoxes    ///< through a hierarchy of boxes
};

/// Stock's box as a region that bounds `built`, which has its clips; null where it changes nothing.
/// World space; `outer` is what moves the statement there. `open_bounds`: have_open_inside().
std::shared_ptr<const core::Object> box_region(const ObjectDesc& object, const core::Transform& outer,
                                               Reach reach, bool open_bounds, const core::Object& built);

/// Whether some of what bounds an object has an inside beyond its own box.
bool have_open_inside(const core::Object::Regions& bounds);

/// Whether the parts of this object of the scene's list come to hang in the list themselves.
bool splits_on_list(const ObjectDesc& object);

/// How many objects and lights the object is in the scene's list.
std::size_t count_on_list(const ObjectDesc& object);

/// From so many objects and lights on stock makes a hierarchy.
constexpr std::size_t kHierarchyFrom = 3;

}  // namespace lentray::parser
