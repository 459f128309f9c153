#include "parser/stock/gates.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "core/numeric/bounds_help.h"
#include "core/object/csg.h"
#include "core/object/leaf.h"
#include "core/shape/box.h"
#include "parser/stock/quadric_box.h"
#include "parser/stock/stock_box.h"

namespace lentray::parser {
namespace {

using Regions = core::Object::Regions;

constexpr double kFinite = 1e9;  ///< the longest side of a box that is not taken for infinite

/// How stock comes to ask an object for hits.
enum class Reach {
  kPart,      ///< a part of a CSG: without a look at its box
  kOneByOne,  ///< the scene's list is so short that stock asks each object
  kByBoxes    ///< through a hierarchy of boxes
};

double longest_side(const core::Bounds& b) {
  const Vec3 size = b.hi - b.lo;
  return std::max({size.x, size.y, size.z});
}

std::optional<core::Bounds> box_in_world(const ObjectDesc& object, const core::Transform& outer,
                                         const Standing& standing) {
  if (standing.known_box) return *standing.known_box;
  return stock_box_in_world(object, outer);
}

std::shared_ptr<const core::Object> gate_of(const core::Bounds& box) {
  return std::make_shared<core::Leaf>(std::make_unique<core::Box>(box.lo, box.hi),
                                      core::Transform());
}

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
  return csg && (csg->operation == CsgOperation::kIntersection ||
                 csg->operation == CsgOperation::kDifference);
}

/// Of others no surface stands out of stock's box. `in_cut`: somewhere in an intersection or difference, where
/// the surfaces of other parts are seen inside this one beyond its bounds, which box it.
bool may_leave(const ObjectDesc& object, const CsgShape* around, bool in_cut) {
  if (!object.rare->clipped_by.empty() || (in_cut && !object.rare->bounded_by.empty())) return true;
  const CsgShape* csg = object.csg();
  if (!csg) {
    // The solid of a height field is endless. Stock's box of a union does not know that.
    if (std::holds_alternative<Sparse<HeightFieldShape>>(object.shape))
      return in_cut && !cuts(around);
    return cuts(around) && std::holds_alternative<Sparse<QuadricShape>>(object.shape);
  }
  return std::any_of(
      csg->children->begin(), csg->children->end(),
      [&](const Ref<ObjectDesc>& child) { return may_leave(*child, csg, in_cut || cuts(csg)); });
}

bool holds(const core::Bounds& box, const core::Bounds& all) {
  constexpr double kSlack = 1e-5;  // of both boxes' roundings
  for (int axis = 0; axis < 3; ++axis) {
    const double slack = kSlack * (box.hi[axis] - box.lo[axis]);
    if (all.lo[axis] < box.lo[axis] - slack || all.hi[axis] > box.hi[axis] + slack) return false;
  }
  return true;
}

/// Stock's box as a gate of `built`, which has its clips: what a height field clips, which has no lower end, quadrics
/// for which stock counts too little, and what is cut by parts with bounds of their own, stand out of it. Null where
/// it changes nothing. `open_bounds`: have_open_inside().
std::shared_ptr<const core::Object> box_gate(const ObjectDesc& object, const core::Transform& outer,
                                             Reach reach, bool open_bounds,
                                             const core::Object& built) {
  if (reach == Reach::kPart || !(open_bounds || may_leave(object, nullptr, false))) return nullptr;
  if (reach == Reach::kOneByOne && has_no_box_test(object)) return nullptr;
  bool is_whole = true;
  const core::Bounds own = stock_box(object, is_whole);
  if (!is_whole || own.is_empty() || longest_side(own) > kFinite) return nullptr;
  const core::Bounds box = core::transformed(own, outer), seen = built.bounds();
  if (seen.is_empty() || holds(box, seen)) return nullptr;
  return gate_of(box);
}

/// Whether some of what bounds an object has an inside beyond its own box.
bool have_open_inside(const Regions& bounds) {
  return std::any_of(bounds.begin(), bounds.end(), [](const auto& bound) {
    return bound->is_gated() || !bound->solid_bounds().is_finite();
  });
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
  return std::holds_alternative<std::shared_ptr<const BicubicPatchShape>>(object.shape);
}

/// Of an object in the scene's list: whether it seems to stock worth a test of its bounds.
bool keeps_bounds(const ObjectDesc& object) {
  if (const auto* quadric = std::get_if<Sparse<QuadricShape>>(&object.shape)) {
    const auto& clips = object.rare->clipped_by;
    const bool is_limited =
        std::any_of(clips.begin(), clips.end(), [](const auto& clip) { return !clip->inverse; });
    return has_products((*quadric)->c) || (!is_limited && is_open_all_around((*quadric)->c));
  }
  return object.csg() || std::holds_alternative<PolyShape>(object.shape) ||
         std::holds_alternative<Sparse<TextShape>>(object.shape);
}

void set_regions(const ObjectDesc& object, const core::Transform& outer, const Standing& standing,
                 const MakeRegion& make_region, core::Object& out) {
  Regions clips, bounds;
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
    add(object.rare->bounded_by, bounds);
  }
  const bool open_bounds = have_open_inside(bounds);
  if (standing.on_list && !bounds.empty() && !keeps_bounds(object))
    bounds = boxed_bounds(object, outer);
  if (!clips.empty() && !forgets_clips(object)) out.set_clips(std::move(clips));
  const Reach reach = !standing.on_list || standing.is_split ? Reach::kPart
                      : standing.has_hierarchy               ? Reach::kByBoxes
                                                             : Reach::kOneByOne;
  if (auto gate = box_gate(object, outer, reach, open_bounds, out))
    bounds.push_back(std::move(gate));
  if (!bounds.empty()) out.set_gates(std::move(bounds));
}

/// How stock turns the z axis to a normal.
core::Transform upright(const Vec3& normal) {
  constexpr double kAlong = 1e-10;
  if (std::fabs(normal.z) <= 1.0 - kAlong) {
    return core::Transform::axis_rotation({-normal.y, normal.x, 0.0}, std::acos(normal.z));
  }
  return core::Transform::axis_rotation({1.0, 0.0, 0.0}, normal.z < 0.0 ? std::numbers::pi : 0.0);
}

/// The box of a slab about a disc's square.
core::Bounds slab_box(const DiscShape& disc, const core::Transform& to_world) {
  constexpr double kThickness = 1e-3;
  const Vec3 normal = core::normalized(disc.normal);
  const double radius = std::fabs(disc.radius);
  const core::Transform turn = upright(normal);
  const Vec3 a = to_world.vector(turn.vector({radius, 0.0, 0.0})),
             b = to_world.vector(turn.vector({0.0, radius, 0.0}));
  const Vec3 c = to_world.vector(normal * kThickness), centre = to_world.point(disc.centre);
  Vec3 half;
  for (int axis = 0; axis < 3; ++axis)
    half[axis] = std::fabs(a[axis]) + std::fabs(b[axis]) + std::fabs(c[axis]);
  return core::padded({centre - half, centre + half});
}

/// Discs, which count as half-spaces, meshes with holes and some julia fractals have a solid without end. Stock takes
/// it to end where the surface does: at the surface's box, or at the common box of what bounds or what clips it, if
/// that is smaller.
void gate_endless_solid(const ObjectDesc& object, const core::Transform& outer,
                        const core::Bounds& surface, core::Leaf& leaf) {
  const auto* disc = std::get_if<DiscShape>(&object.shape);
  core::Bounds box = disc ? slab_box(*disc, object.transform->then(outer)) : surface;
  for (const Regions* regions : {&leaf.gates(), &leaf.clips()}) {
    core::Bounds common = core::Bounds::everything();
    for (const auto& region : *regions) common.intersect(region->solid_bounds());
    if (common.is_empty()) return leaf.set_solid_gate(core::Bounds());
    if (common.is_finite() && volume(common) < volume(box)) box = common;
  }
  leaf.set_solid_gate(box);
}

bool is_endless(const ObjectDesc& object, const core::Object& built) {
  const bool may_be = std::holds_alternative<DiscShape>(object.shape) ||
                      std::holds_alternative<std::shared_ptr<const MeshShape>>(object.shape) ||
                      std::holds_alternative<Sparse<JuliaFractalShape>>(object.shape);
  return may_be && static_cast<const core::Leaf&>(built).shape().traits().solid_is_unbounded;
}

/// Who looks for the solids around a point of the scene finds none beyond stock's box.
void gate_list_object(const ObjectDesc& object, const core::Transform& outer,
                      const Standing& standing, core::Object& out) {
  core::Bounds solid = out.solid_bounds();
  const bool is_in_box = solid.is_finite() || solid.is_empty();
  if (is_in_box && out.gates().empty()) return;
  const auto box = box_in_world(object, outer, standing);
  if (!box || !(longest_side(*box) < kFinite)) return;
  solid.intersect(*box);
  out.set_solid_gate(solid.is_empty() ? core::Bounds() : solid);
}

}  // namespace

std::optional<core::Bounds> stock_box_in_world(const ObjectDesc& object,
                                               const core::Transform& outer) {
  bool is_whole = true;
  const core::Bounds box = core::transformed(stock_box(object, is_whole), outer);
  return is_whole ? std::optional(box) : std::nullopt;
}

void set_limits(const ObjectDesc& object, const core::Transform& outer, const Standing& standing,
                const MakeRegion& make_region, core::Object& out) {
  const bool endless = is_endless(object, out);
  const core::Bounds surface = endless ? out.bounds() : core::Bounds();
  core::Csg* csg = object.csg() ? static_cast<core::Csg*>(&out) : nullptr;
  // The box of a turned CSG is that of its parts' boxes, turned.
  if (csg && csg->is_gated()) {
    const auto box = box_in_world(object, outer, standing);
    if (box && !box->is_empty()) csg->set_box(*box);
  }
  set_regions(object, outer, standing, make_region, out);
  if (endless) gate_endless_solid(object, outer, surface, static_cast<core::Leaf&>(out));
  if (object.inverse) out.set_inverse(true);
  // Stock asks the parts of a CSG without a look at their boxes.
  if (csg && !standing.is_split && (standing.on_list || !standing.is_part)) csg->open_parts();
  if (standing.on_list) gate_list_object(object, outer, standing, out);
}

void set_gates_alone(const ObjectDesc& object, core::Object& out) {
  if (!have_open_inside(out.gates())) return;
  auto gate = box_gate(object, core::Transform(), Reach::kOneByOne, true, out);
  if (!gate) return;
  Regions gates = out.gates();
  gates.push_back(std::move(gate));
  out.set_gates(std::move(gates));
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
