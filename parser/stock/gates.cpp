#include "parser/stock/gates.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/object/gated.h"
#include "core/object/leaf.h"
#include "core/shape/box.h"
#include "parser/stock/quadric_box.h"
#include "parser/stock/stock_box.h"

namespace lentray::parser {
namespace {

using Regions = core::Object::Regions;

constexpr double kFinite = 1e9;  ///< the longest side of a box that is not taken for infinite

double longest_side(const core::Bounds& b) {
  const Vec3 size = b.hi - b.lo;
  return std::max({size.x, size.y, size.z});
}

std::shared_ptr<const core::Object> gate_of(const core::Bounds& box) {
  return std::make_shared<core::Leaf>(std::make_unique<core::Box>(box.lo, box.hi),
                                      core::Transform());
}

bool cuts(const ObjectDesc& object) {
  const CsgShape* csg = object.csg();
  return csg && (csg->operation == CsgOperation::kIntersection ||
                 csg->operation == CsgOperation::kDifference);
}

/// Whether there may be more of an object than stock's box holds. `in_cut`: somewhere in an intersection or difference,
/// where the surfaces of other parts are seen inside this one beyond its bounds, which box it.
bool may_exceed_box(const ObjectDesc& object, const ObjectDesc* around, bool in_cut) {
  if (!object.rare->clipped_by.empty() || (in_cut && !object.rare->bounded_by.empty())) return true;
  if (const CsgShape* csg = object.csg()) {
    return std::ranges::any_of(*csg->children, [&](const Ref<ObjectDesc>& child) {
      return may_exceed_box(*child, &object, in_cut || cuts(object));
    });
  }
  const bool is_cut = around && cuts(*around);
  // The solid of a height field is endless. Stock's box of a union does not know that.
  if (object.is_any<Sparse<HeightFieldShape>>()) return in_cut && !is_cut;
  // Half of space is inside a disc, whose box is flat.
  if (object.is_any<DiscShape>()) return is_cut && !around->inverse;
  // The box of a quadric is found from its equation.
  return is_cut && object.is_any<Sparse<QuadricShape>>();
}

bool holds(const core::Bounds& box, const core::Bounds& all) {
  constexpr double kSlack = 1e-5;  // of both boxes' roundings
  for (int axis = 0; axis < 3; ++axis) {
    const double slack = kSlack * (box.hi[axis] - box.lo[axis]);
    if (all.lo[axis] < box.lo[axis] - slack || all.hi[axis] > box.hi[axis] + slack) return false;
  }
  return true;
}

/// Stock's box as a gate of `built`, which has its clips. Null where it changes nothing.
std::shared_ptr<const core::Object> box_gate(const ObjectDesc& object, const core::Transform& outer,
                                             const core::Object& built) {
  if (!may_exceed_box(object, nullptr, false)) return nullptr;
  bool is_whole = true;
  const core::Bounds own = stock_box(object, is_whole);
  if (!is_whole || own.is_empty() || longest_side(own) > kFinite) return nullptr;
  const core::Bounds box = core::transformed(own, outer), seen = built.bounds();
  if (seen.is_empty() || holds(box, seen)) return nullptr;
  return gate_of(box);
}

/// What is left of bounds that stock drops: their common box, if it is smaller than stock's of the object without them.
Regions boxed_bounds(const ObjectDesc& object, const core::Transform& outer) {
  if (!heeds_regions(object)) return {};
  ObjectDesc alone = object;
  alone.rare.edit().bounded_by.clear();
  bool is_whole = true;
  const core::Bounds own = core::transformed(stock_box(alone, is_whole), outer);
  core::Bounds box = core::Bounds::everything();
  is_whole = true;
  for (const Ref<ObjectDesc>& bound : object.rare->bounded_by) {
    if (!bound->inverse) box.intersect(core::transformed(stock_box(*bound, is_whole), outer));
  }
  const bool is_smaller = !own.is_empty() && volume(box) < volume(own);
  if (!is_whole || box.is_empty() || !box.is_finite() || !is_smaller) return {};
  return {gate_of(box)};
}

/// Stock asks no patch for what clips it: the clips only lend their box.
bool forgets_clips(const ObjectDesc& object) {
  return object.is_any<std::shared_ptr<const BicubicPatchShape>>();
}

/// Of an object in the scene's list: whether it seems to stock worth a test of its bounds.
bool keeps_bounds(const ObjectDesc& object) {
  if (const auto* quadric = std::get_if<Sparse<QuadricShape>>(&object.shape)) {
    const auto& clips = object.rare->clipped_by;
    const bool is_limited = std::ranges::any_of(clips, [](const auto& c) { return !c->inverse; });
    return has_products((*quadric)->c) || (!is_limited && is_open_all_around((*quadric)->c));
  }
  return object.is_any<CsgShape, PolyShape, Sparse<TextShape>>();
}

}  // namespace

void set_limits(const ObjectDesc& object, const core::Transform& outer, const Standing& standing,
                const MakeRegion& make_region, std::unique_ptr<core::Object>& out) {
  Regions clips, gates;
  if (object.rare.is_stored()) {
    std::map<const ObjectDesc*, std::shared_ptr<const core::Object>> made;
    const auto add = [&](const std::vector<Ref<ObjectDesc>>& from, Regions& to) {
      for (const Ref<ObjectDesc>& desc : from) {
        std::shared_ptr<const core::Object>& slot = made[desc.get()];
        if (!slot) slot = make_region(*desc);
        if (slot) to.push_back(slot);
      }
    };
    add(object.rare->clipped_by, clips);
    add(object.rare->bounded_by, gates);
  }
  if (standing.on_list && !gates.empty() && !keeps_bounds(object))
    gates = boxed_bounds(object, outer);
  if (!clips.empty() && !forgets_clips(object)) {
    out->set_clips(std::move(clips));
    if (object.is_any<PolyShape>()) static_cast<core::Leaf&>(*out).search_within_clips();
  }
  if (standing.on_list && !standing.is_split) {
    if (auto gate = box_gate(object, outer, *out)) gates.push_back(std::move(gate));
  }
  if (object.inverse) out->set_inverse(true);
  if (!gates.empty()) out = std::make_unique<core::Gated>(std::move(out), std::move(gates));
}

bool splits_on_list(const ObjectDesc& object) {
  const CsgShape* csg = object.csg();
  return csg && csg->split_union && !object.inverse && object.rare->clipped_by.empty() &&
         object.rare->bounded_by.empty() &&
         (csg->operation == CsgOperation::kUnion || csg->operation == CsgOperation::kLightGroup);
}

}  // namespace lentray::parser
