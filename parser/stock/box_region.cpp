#include "parser/stock/box_region.h"

#include <algorithm>

#include "core/object/leaf.h"
#include "core/shape/box.h"
#include "parser/stock/stock_box.h"

namespace lentray::parser {
namespace {

/// Asked one by one these are asked for hits without their boxes first.
bool has_no_box_test(const ObjectDesc& object) {
  return std::holds_alternative<PlaneShape>(object.shape) ||
         std::holds_alternative<SphereShape>(object.shape) ||
         std::holds_alternative<BoxShape>(object.shape) ||
         std::holds_alternative<TriangleShape>(object.shape) ||
         std::holds_alternative<PolyShape>(object.shape) ||
         std::holds_alternative<Sparse<SmoothTriangleShape>>(object.shape);
}

bool cuts(const CsgShape* csg) {
  return csg && (csg->operation == CsgOperation::kIntersection || csg->operation == CsgOperation::kDifference);
}

/// Of others no surface stands out of stock's box. `in_cut`: somewhere in an intersection or difference, where
/// the surfaces of other parts are seen inside this one beyond its bounds, which box it.
bool may_leave(const ObjectDesc& object, const CsgShape* around, bool in_cut) {
  if (!object.rare->clipped_by.empty() || (in_cut && !object.rare->bounded_by.empty())) return true;
  const CsgShape* csg = object.csg();
  if (!csg) {
    // The solid of a height field is endless. Stock's box of a union does not know that.
    if (std::holds_alternative<Sparse<HeightFieldShape>>(object.shape)) return in_cut && !cuts(around);
    return cuts(around) && std::holds_alternative<Sparse<QuadricShape>>(object.shape);
  }
  return std::any_of(csg->children->begin(), csg->children->end(), [&](const Ref<ObjectDesc>& child) {
    return may_leave(*child, csg, in_cut || cuts(csg));
  });
}

bool holds(const core::Bounds& box, const core::Bounds& all) {
  constexpr double kSlack = 1e-5;  // of both boxes' roundings
  for (int axis = 0; axis < 3; ++axis) {
    const double slack = kSlack * (box.hi[axis] - box.lo[axis]);
    if (all.lo[axis] < box.lo[axis] - slack || all.hi[axis] > box.hi[axis] + slack) return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const core::Object> box_region(const ObjectDesc& object, const core::Transform& outer,
                                               Reach reach, bool open_bounds, const core::Object& built) {
  if (reach == Reach::kPart || !(open_bounds || may_leave(object, nullptr, false))) return nullptr;
  if (reach == Reach::kOneByOne && has_no_box_test(object)) return nullptr;
  constexpr double kFinite = 1e9;
  bool is_whole = true;
  const core::Bounds own = stock_box(object, is_whole);
  const Vec3 size = own.hi - own.lo;
  if (!is_whole || own.is_empty() || std::max({size.x, size.y, size.z}) > kFinite) return nullptr;
  const core::Bounds box = core::transformed(own, outer), seen = built.bounds();
  if (seen.is_empty() || holds(box, seen)) return nullptr;
  return std::make_shared<core::Leaf>(std::make_unique<core::Box>(box.lo, box.hi), core::Transform());
}

bool have_open_inside(const core::Object::Regions& bounds) {
  return std::any_of(bounds.begin(), bounds.end(), [](const auto& bound) {
    return bound->solid_leaves_bounds() || !bound->solid_bounds().is_finite();
  });
}

bool splits_on_list(const ObjectDesc& object) {
  const CsgShape* csg = object.csg();
  return csg && csg->split_union && !object.inverse && object.rare->clipped_by.empty() &&
         object.rare->bounded_by.empty() &&
         (csg->operation == CsgOperation::kUnion || csg->operation == CsgOperation::kLightGroup);
}

std::size_t count_on_list(const ObjectDesc& object) {
  if (!splits_on_list(object)) return 1;
  std::size_t n = 0;
  for (const Ref<ObjectDesc>& child : *object.csg()->children) n += count_on_list(*child);
  return n;
}

}  // namespace lentray::parser
