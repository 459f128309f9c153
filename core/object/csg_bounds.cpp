// The boxes and balls of a CSG, from those of its parts, and which of them are asked first.
#include <algorithm>
#include <memory>
#include <numbers>
#include <typeinfo>

#include "core/object/csg_convex.h"
#include "core/object/csg_search.h"
#include "core/object/leaf.h"
#include "core/shape/prism.h"

namespace lentray::core {
namespace {

constexpr std::size_t kMany = 9;  // children from which a hierarchy over them pays

bool is_convex_solid(const Shape& shape) {
  if (const auto* prism = dynamic_cast<const Prism*>(&shape)) return prism->is_convex_solid();
  return shape.traits().convexity == Convexity::kConvex;
}

}  // namespace

Csg::Fence Csg::fence_of(const Object& child) {
  const Bounds solid = child.solid_bounds(), hollow = child.void_bounds();
  const bool beyond = !hollow.is_empty() ? hollow.is_finite() : true;
  return {child.bounds(), beyond ? hollow : solid, beyond};
}

/// Boxes from those of the children: what is kept of a child's surface lies in all siblings
/// (intersection); what is kept of a union lies in one of them.
void Csg::fence_children() {
  const std::size_t n = m_children.size();
  const bool join = joins(m_kind);
  const bool later = join && n >= kMany;  // most such unions are split into their parts
  m_fences.clear();
  if (!later) m_fences.reserve(n);
  m_surface = Bounds();
  m_solid = join ? Bounds() : Bounds::everything();
  m_void = join ? Bounds::everything() : Bounds();
  bool lies_in_parts = !join;
  std::vector<Bounds> before(join ? 0 : n + 1, Bounds::everything());
  for (std::size_t i = 0; i < n; ++i) {
    const Object& child = *m_children[i];
    const Bounds solid = child.solid_bounds(), hollow = child.void_bounds();
    lies_in_parts = lies_in_parts && child.lies_in_parts();
    if (join) {
      m_solid.include(solid);
      m_void.intersect(hollow);
      m_surface.include(child.bounds());
    } else {
      before[i + 1] = before[i];
      before[i + 1].intersect(solid);
      m_solid.intersect(solid);
      m_void.include(hollow);
    }
    if (!later) m_fences.push_back(fence_of(child));
  }
  Bounds after = Bounds::everything();
  for (std::size_t i = join ? 0 : n; i-- > 0;) {
    m_fences[i].surface.intersect(before[i]);
    m_fences[i].surface.intersect(after);
    if (m_fences[i].surface.is_empty()) m_fences[i].surface = Bounds();
    after.intersect(m_children[i]->solid_bounds());
    m_surface.include(m_fences[i].surface);
  }
  if (m_solid.is_empty()) m_solid = Bounds();
  if (m_void.is_empty()) m_void = Bounds();
  m_search.reset();
  set_lies_in_parts(lies_in_parts);
  set_ball(surface_ball());
  choose_tests();
}

/// Which boxes and parts are asked first. The core is the smallest there is.
void Csg::choose_tests() {
  m_core = kNobody;
  m_way = hides_parts() ? Way::kHidden : Way::kParts;
  m_convex.reset();
  set_closed(false);
  if (m_children.size() >= kMany) {
    if (m_way == Way::kParts && is_overlap()) m_way = Way::kOverlap;
    return;
  }
  // A ball that is hardly larger than the box turns rays away for less.
  constexpr double kMuchLarger = 3.0;
  const auto is_tight = [](const auto& child) {
    const Vec3 size = child->bounds().hi - child->bounds().lo;
    const double radius = child->ball().radius();
    return radius * radius * 2.0 * std::numbers::pi <
           kMuchLarger * (size.x * size.y + size.y * size.z + size.z * size.x);
  };
  m_asks_boxes = joins(m_kind) && !std::all_of(m_children.begin(), m_children.end(), is_tight);
  set_closed(m_way != Way::kHidden &&
             std::all_of(m_children.begin(), m_children.end(),
                         [](const auto& child) { return child->is_closed(); }));
  if (joins(m_kind)) return;
  double least = Bounds::kInf;
  for (std::size_t i = 0; i < m_children.size(); ++i) {
    const double radius =
        m_children[i]->is_closed() ? m_children[i]->solid_ball().radius() : Bounds::kInf;
    if (!(radius < least)) continue;
    least = radius;
    m_core = i;
  }
  if (m_core == kNobody) return;
  m_convex = ConvexParts::of(m_children, m_core, m_kind == CsgKind::kIntersection);
  if (m_convex) m_way = Way::kConvex;
}

/// Whether the surface is that of a solid in which all parts, or all their inverses, overlap.
bool Csg::is_overlap() const {
  if (m_kind == CsgKind::kUnion || m_kind == CsgKind::kDifference) return false;
  return std::ranges::all_of(m_children, [this](const auto& child) {
    if (typeid(*child) != typeid(Leaf) || child->is_inverse() != joins(m_kind)) return false;
    const auto& leaf = static_cast<const Leaf&>(*child);
    return is_convex_solid(leaf.shape()) && leaf.clips().empty();
  });
}

Ball Csg::surface_ball() const {
  Ball ball = Ball::around(m_surface);
  // What is kept of a part lies in the solids of its siblings.
  if (!joins(m_kind)) {
    for (const auto& child : m_children) ball = smaller(ball, child->solid_ball());
  }
  return ball;
}

Ball Csg::solid_ball() const {
  Ball ball;
  if (joins(m_kind)) {
    Bounds all = m_surface;
    all.include(m_solid);
    ball = Ball::around(all);
  } else {
    for (const auto& child : m_children) ball = smaller(ball, child->solid_ball());
  }
  return within_clips(ball);
}

void Csg::build_search() {
  if (m_children.size() < kMany) return;
  if (m_fences.empty()) {
    m_fences.reserve(m_children.size());
    for (const auto& child : m_children) m_fences.push_back(fence_of(*child));
  }
  m_search = std::make_unique<Search>();
  std::vector<Bounds> surfaces(m_children.size()), solids(m_children.size());
  for (std::size_t i = 0; i < m_children.size(); ++i) {
    const Fence& fence = m_fences[i];
    const auto index = static_cast<std::uint32_t>(i);
    if (fence.surface.is_finite()) {
      surfaces[i] = fence.surface;
    } else if (!fence.surface.is_empty()) {
      m_search->open_surfaces.push_back(index);
    }
    if (!fence.decide.is_finite() && !fence.decide.is_empty()) {
      m_search->open_solids.push_back(index);
      continue;
    }
    solids[i] = fence.decide;
    ++(fence.beyond ? m_search->in_beyond : m_search->out_beyond);
  }
  m_search->surfaces = WideBvh(surfaces);
  m_search->solids = WideBvh(solids);
}

Bounds Csg::bounds() const { return within_clips(m_surface); }

Bounds Csg::solid_bounds() const { return within_clips(m_solid); }

Bounds Csg::void_bounds() const { return clips().empty() ? m_void : Bounds::everything(); }

}  // namespace lentray::core
