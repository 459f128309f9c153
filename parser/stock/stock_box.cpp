#include "parser/stock/stock_box.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/tiny.h"
#include "core/numeric/bounds_help.h"
#include "core/shape/julia_fractal.h"
#include "parser/shapes/shape_geometry.h"
#include "parser/stock/quadric_box.h"

namespace lentray::parser {
namespace {

using core::Bounds;
using core::Transform;

constexpr double kHuge = 1e10;  ///< where boxes end
constexpr double kCritical =
    1e6;  ///< a CSG's or quadric's box longer than this is taken for infinite
constexpr double kThickness = 1e-3;  ///< flat things are given this much to both sides
using core::kTiny;

Bounds everything() { return {Vec3(-kHuge), Vec3(kHuge)}; }

bool is_long(const Bounds& b) {
  const Vec3 size = b.hi - b.lo;
  return size.x > kCritical || size.y > kCritical || size.z > kCritical;
}

/// Through memory: where it makes vectors of such roundings, g++ 12 leaves them out.
double single(double x) {
  const volatile auto rounded = static_cast<float>(x);
  return rounded;
}

/// A corner and lengths is what is kept, in single precision.
Bounds kept(const Bounds& b) {
  Bounds out;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = std::clamp(b.lo[axis], -kHuge, kHuge);
    const double hi = std::clamp(b.hi[axis], -kHuge, kHuge);
    out.lo[axis] = single(lo);
    out.hi[axis] = out.lo[axis] + single(hi - lo);
  }
  return out;
}

Bounds moved(const Bounds& b, const Transform& t) {
  return t.is_identity() ? b : kept(core::transformed(b, t));
}

/// Unit lengths stand for `radius` across and `length` along the z axis, which becomes `axis`.
Transform standing(const Vec3& origin, const Vec3& axis, double radius, double length) {
  const bool upright = std::fabs(axis.z) > 1.0 - kTiny;
  const Vec3 about = upright ? Vec3(1, 0, 0) : Vec3(-axis.y, axis.x, 0);
  const double angle = upright ? (axis.z < 0.0 ? std::acos(-1.0) : 0.0) : std::acos(axis.z);
  return Transform::scaling({radius, radius, length})
      .then(Transform::axis_rotation(about, angle))
      .then(Transform::translation(origin));
}

/// How much larger a ball has become, less than 0 if turned inside out.
double ball_scale(const Transform& t) {
  const double scale = core::similarity_scale(t);
  return dot(cross(t.vector({1, 0, 0}), t.vector({0, 1, 0})), t.vector({0, 0, 1})) < 0.0 ? -scale
                                                                                         : scale;
}

/// What placed balls while they were balls; null: it was the whole transform.
const Transform* placing_of_ball(const ObjectDesc& object) {
  const PlacementSteps& steps = *object.transform->steps;
  return steps.empty() ? nullptr : &steps.front().transform;
}

/// The box of balls, and what has turned it since they were.
Bounds turned_since(const Bounds& box, const Transform* placing, const Transform& all) {
  return placing ? moved(kept(box), placing->inverse().then(all)) : kept(box);
}

Bounds about(const Vec3& centre, double radius) {
  return {centre - Vec3(radius), centre + Vec3(radius)};
}

/// Those that `inverse` and a difference leave as they are, their boxes too.
bool has_no_outside(const ObjectDesc& object) {
  return object.is_any<TriangleShape, PolygonShape, Sparse<SmoothTriangleShape>,
                       std::shared_ptr<const BicubicPatchShape>, Sparse<ParametricShape>>();
}

class BoxFinder {
 public:
  explicit BoxFinder(bool& is_whole) : m_is_whole(is_whole) {}

  Bounds of(const ObjectDesc& object) { return rounded(kept_of(object)); }
  Bounds kept_of(const ObjectDesc& object) {
    Bounds box =
        kept(std::visit([&](const auto& shape) { return leaf(shape, object); }, object.shape));
    if (!heeds_regions(object)) return box;
    for (const auto* regions : {&object.rare->bounded_by, &object.rare->clipped_by}) {
      Bounds common = everything();
      for (const Ref<ObjectDesc>& region : *regions) {
        if (!region->inverse) common.intersect(of(*region));
      }
      common = kept(common);
      if (!regions->empty() && volume(common) < volume(box)) box = common;
    }
    return box;
  }

 private:
  static Bounds rounded(const Bounds& box) {
    return {box.lo, {single(box.hi.x), single(box.hi.y), single(box.hi.z)}};
  }

  /// What a part of an intersection leaves, or its outside: of planes only those along an axis have
  /// a box, all others have none outside.
  Bounds limited(const ObjectDesc& part, bool outside) {
    const auto* plane = std::get_if<PlaneShape>(&part.shape);
    if (part.inverse) outside = !outside;
    if (has_no_outside(part)) outside = false;
    if (!plane) return outside ? everything() : of(part);
    Bounds box = everything();
    const Vec3 normal =
        core::normalized(part.transform->normal(plane->normal)) * (outside ? -1.0 : 1.0);
    const Vec3 unit = core::normalized(plane->normal);
    const Vec3 on = part.transform->point(unit * plane->distance);
    for (int axis = 0; axis < 3; ++axis) {
      if (normal[axis] > 1.0 - kTiny) box.hi[axis] = on[axis];
      if (normal[axis] < kTiny - 1.0) box.lo[axis] = on[axis];
    }
    return box;
  }

  Bounds leaf(const SphereShape& s, const ObjectDesc& o) {
    const Transform* end = placing_of_ball(o);
    const Transform& placing = end ? *end : *o.transform;
    const double radius = s.radius * std::fabs(ball_scale(placing));
    return turned_since(about(placing.point(s.centre), radius), end, *o.transform);
  }
  Bounds leaf(const BoxShape& s, const ObjectDesc& o) {
    Bounds box;
    box.include(s.corner1);
    box.include(s.corner2);
    return moved(kept(box), *o.transform);
  }
  Bounds leaf(const PlaneShape&, const ObjectDesc&) { return everything(); }
  Bounds leaf(const LightShape&, const ObjectDesc&) { return everything(); }
  Bounds leaf(const CylinderShape& s, const ObjectDesc& o) {
    const Vec3 axis = s.cap - s.base;
    const double length = core::length(axis);
    return moved({{-1, -1, 0}, {1, 1, 1}},
                 standing(s.cap, -axis / length, s.radius, length).then(*o.transform));
  }
  /// A cone stands on its tip: from there its wider end is at 1.
  Bounds leaf(const ConeShape& s, const ObjectDesc& o) {
    const bool wider_base = s.base_radius > s.cap_radius;
    const Vec3 narrow = wider_base ? s.cap : s.base, wide = wider_base ? s.base : s.cap;
    const double small = wider_base ? s.cap_radius : s.base_radius;
    const double large = wider_base ? s.base_radius : s.cap_radius;
    if (large - small < kTiny || large < 0.0)
      return leaf(CylinderShape{s.base, s.cap, large, s.open}, o);
    const double length = core::length(wide - narrow);
    const Vec3 axis = (wide - narrow) / length;
    const double below = small * length / (large - small);
    return moved({{-1, -1, below / (below + length)}, {1, 1, 1}},
                 standing(narrow - axis * below, axis, large, below + length).then(*o.transform));
  }
  Bounds leaf(const DiscShape& s, const ObjectDesc& o) {
    return moved(kept({{-s.radius, -s.radius, -kThickness}, {s.radius, s.radius, kThickness}}),
                 standing(s.centre, core::normalized(s.normal), 1, 1).then(*o.transform));
  }
  Bounds leaf(const TorusShape& s, const ObjectDesc& o) {
    const double out = s.major + s.minor;
    return moved(kept({{-out, -s.minor, -out}, {out, s.minor, out}}), *o.transform);
  }
  Bounds leaf(const SuperellipsoidShape&, const ObjectDesc& o) {
    return moved(kept(about({}, 1.0001)), *o.transform);
  }
  Bounds leaf(const PolygonShape& s, const ObjectDesc& o) {
    Bounds box;
    for (const Vec3& p : s.points) box.include(o.transform->point(p));
    for (int axis = 0; axis < 3; ++axis) {
      if (box.hi[axis] - box.lo[axis] >= kThickness) continue;
      box.lo[axis] -= kThickness;
      box.hi[axis] += kThickness;
    }
    return kept(box);
  }
  Bounds leaf(const TriangleShape& s, const ObjectDesc& o) { return points(s.p, o); }
  Bounds leaf(const Sparse<SmoothTriangleShape>& s, const ObjectDesc& o) { return points(s->p, o); }
  Bounds points(const std::array<Vec3, 3>& corners, const ObjectDesc& o) {
    Bounds box;
    for (const Vec3& p : corners) box.include(o.transform->point(p));
    return kept({box.lo - Vec3(kTiny), box.hi + Vec3(kTiny)});
  }
  Bounds leaf(const std::shared_ptr<const MeshShape>& s, const ObjectDesc& o) {
    Bounds box;
    for (const core::MeshTriple& face : s->faces) {
      for (const std::uint32_t v : face) box.include(s->vertices[v]);
    }
    return moved(kept(box), *o.transform);
  }
  Bounds leaf(const CsgShape& s, const ObjectDesc& o) {
    const bool all = s.operation == CsgOperation::kUnion || s.operation == CsgOperation::kMerge ||
                     s.operation == CsgOperation::kLightGroup;
    Bounds box = all ? Bounds() : everything();
    if (all) {
      for (const Ref<ObjectDesc>& child : *s.children) box.include(of(*child));
    } else {
      cut_by_parts(s, box);
    }
    if (box.is_empty() || is_long(box)) return everything();
    box = kept(box);
    return moved_by_steps(box, *o.transform);
  }
  static Bounds moved_by_steps(Bounds box, const Placement& placement) {
    const PlacementSteps& steps = *placement.steps;
    if (steps.empty()) return moved(box, placement);
    for (const PlacementStep& step : steps) box = moved(box, step.transform);
    return box;
  }
  /// Quadrics come last: what the others leave limits them. Height fields, whose solids are endless,
  /// leave everything.
  void cut_by_parts(const CsgShape& s, Bounds& box) {
    std::vector<const ObjectDesc*> quadrics;
    bool outside = false;
    for (const Ref<ObjectDesc>& child : *s.children) {
      const bool is_kept = child->inverse == outside;
      if (child->is_any<Sparse<QuadricShape>>()) {
        if (is_kept) quadrics.push_back(child.get());
      } else if (!child->is_light() && !child->is_any<Sparse<HeightFieldShape>>()) {
        box.intersect(limited(*child, outside));
      }
      outside = s.operation == CsgOperation::kDifference;
    }
    const Bounds limits = box;
    for (const ObjectDesc* quadric : quadrics) {
      box.intersect(of(*quadric));
      box.intersect(of_quadric(*quadric, limits));
    }
  }
  Bounds leaf(const std::shared_ptr<const BicubicPatchShape>& s, const ObjectDesc& o) {
    Bounds box;
    for (const Vec3& p : s->points) box.include(o.transform->point(p));
    return kept(box);
  }
  Bounds leaf(const Sparse<QuadricShape>& s, const ObjectDesc& o) {
    const std::optional<Bounds> box = kept_of(*s, *o.transform->steps);
    return box ? *box : quadric_where(*s, *o.transform, everything());
  }
  /// Where its transform places it, with what `limits` leave. One with products of two coordinates has none but
  /// what is left from before it was turned.
  static Bounds quadric_where(const QuadricShape& s, const Transform& placed,
                              const Bounds& limits) {
    const std::array<double, 10> c = moved_quadric(s.c, placed);
    if (has_products(c)) return everything();
    const Bounds box = quadric_box(c, limits);
    return is_long(box) ? everything() : kept(box);
  }
  /// The same, where `before` is the box that it has kept, if any.
  static Bounds limited_quadric(const QuadricShape& s, const Transform& placed,
                                const std::optional<Bounds>& before, const Bounds& limits) {
    if (!has_products(moved_quadric(s.c, placed))) return quadric_where(s, placed, limits);
    const Bounds box = before ? *before : everything();
    return volume(kept(limits)) < volume(box) ? kept(limits) : box;
  }
  /// Of a quadric, with what its siblings leave.
  Bounds of_quadric(const ObjectDesc& object, const Bounds& limits) {
    const QuadricShape& s = *std::get<Sparse<QuadricShape>>(object.shape);
    return limited_quadric(s, *object.transform, kept_of(s, *object.transform->steps), limits);
  }
  /// The box that a quadric keeps from when it was clipped or turned first, moved by each step since.
  std::optional<Bounds> kept_of(const QuadricShape& s, const PlacementSteps& steps) {
    std::optional<Bounds> box;
    Transform placed;
    for (const PlacementStep& step : steps) {
      switch (step.kind) {
        case PlacementStep::Kind::kBefore: placed = step.transform; break;
        case PlacementStep::Kind::kClips:
          placed = step.transform;
          box = limited_quadric(s, placed, box, clip_limits(step.clips));
          break;
        case PlacementStep::Kind::kTransform:
          turn_quadric(s, placed, step.transform, box);
          placed = placed.then(step.transform);
          break;
      }
    }
    return box;
  }
  static void turn_quadric(const QuadricShape& s, const Transform& placed, const Transform& turn,
                           std::optional<Bounds>& box) {
    if (!box && core::keeps_axes(turn)) return;
    const Bounds before = rounded(kept(box ? *box : quadric_where(s, placed, everything())));
    if (!box && is_long(before)) return;
    box = is_long(before) ? before : kept(core::transformed(before, turn));
  }
  Bounds clip_limits(const std::vector<Ref<ObjectDesc>>& clips) {
    Bounds limits = everything();
    for (const Ref<ObjectDesc>& clip : clips) limits.intersect(limited(*clip, false));
    return limits;
  }
  /// Of a sphere about each element, a cylinder's round ends counted apart; where an element is
  /// placed its sphere is as wide as the box of the placed box from the middle to a corner.
  Bounds leaf(const std::shared_ptr<const BlobShape>& s, const ObjectDesc& o) {
    Bounds box;
    const auto add = [&](const Transform& placing, double z, double radius) {
      const Bounds placed = core::transformed({Vec3(), Vec3(radius)}, placing);
      const Vec3 size = placed.hi - placed.lo;
      box.include(about(placing.point({0, 0, z}), std::max({size.x, size.y, size.z})));
    };
    const auto adds = [](const BlobElement& e) { return e.strength > 0.0; };
    const bool any_adds = std::any_of(s->elements.begin(), s->elements.end(), adds);
    for (const BlobElement& e : s->elements) {
      if (any_adds && !adds(e)) continue;
      if (e.kind == BlobElement::Kind::kSphere) {
        add(Transform::translation(e.a).then(e.transform), 0.0, e.radius);
        continue;
      }
      const double length = core::length(e.b - e.a);
      const Transform placing = standing(e.a, (e.b - e.a) / length, 1.0, 1.0).then(e.transform);
      add(placing, 0.0, e.radius);
      add(placing, length, e.radius);
      add(placing, 0.5 * length, std::hypot(e.radius, 0.5 * length));
    }
    return moved(kept(box), *o.transform);
  }
  Bounds leaf(const Sparse<JuliaFractalShape>& s, const ObjectDesc& o) {
    return moved(kept(about({}, core::julia_sphere(s->parameter, s->hypercomplex))), *o.transform);
  }
  /// Of Bezier curves their control points count as well.
  template <typename Shape>
  Bounds of_points(Shape s, const ObjectDesc& o) {
    if (s.spline == CurveKind::kBezier) s.spline = CurveKind::kLinear;
    return built(s, o);
  }
  Bounds leaf(const LatheShape& s, const ObjectDesc& o) { return of_points(s, o); }
  Bounds leaf(const PrismShape& s, const ObjectDesc& o) { return of_points(s, o); }
  /// Of the boxes that the font gives its glyphs, blanks too, a little thicker than the text. Stock turns each text a
  /// little to begin with. Without a glyph it is taken for infinite.
  static Bounds leaf(const Sparse<TextShape>& s, const ObjectDesc& o) {
    constexpr double kThicker = 1e-6, kTurn = 0.001;
    Bounds box = text_box(*s, o.where);
    if (box.is_empty()) return everything();
    box.lo.z -= kThicker;
    box.hi.z += kThicker;
    static const Transform kTurned = Transform::rotation(Vec3(kTurn));
    return moved_by_steps(moved(kept(box), kTurned), *o.transform);
  }
  /// That of its container.
  Bounds leaf(const Sparse<ParametricShape>& s, const ObjectDesc& o) {
    if (s->container.sphere)
      return moved(kept(about(s->container.a, s->container.radius)), *o.transform);
    Bounds box;
    box.include(s->container.a);
    box.include(s->container.b);
    return moved(kept(box), *o.transform);
  }
  /// Of all its spheres, twice as wide for a cubic spline; after `scale -1` their radii are below 0.
  Bounds leaf(const SphereSweepShape& s, const ObjectDesc& o) {
    const Transform* end = placing_of_ball(o);
    const Transform& placing = end ? *end : *o.transform;
    const double wide = (s.spline == CurveKind::kCubic ? 2.0 : 1.0) * ball_scale(placing);
    Bounds box;
    for (std::size_t i = 0; i < s.centres.size(); ++i) {
      const Bounds ball = about(placing.point(s.centres[i]), wide * s.radii[i]);
      for (int axis = 0; axis < 3; ++axis) {
        box.lo[axis] = std::min(box.lo[axis], ball.lo[axis]);
        box.hi[axis] = std::max(box.hi[axis], ball.hi[axis]);
      }
    }
    return turned_since(box, end, *o.transform);
  }
  /// All others by the bounds of their geometry.
  template <typename Shape>
  Bounds leaf(const Shape& s, const ObjectDesc& o) {
    return built(s, o);
  }
  template <typename Shape>
  Bounds built(const Shape& s, const ObjectDesc& o) {
    ObjectDesc alone;
    alone.keyword = o.keyword;
    alone.where = o.where;
    alone.shape = s;
    const auto made = shape_geometry(alone, m_is_whole);
    if (!made || made->bounds().is_empty()) return {Vec3(), Vec3()};
    const Bounds box = made->bounds();
    return box.is_finite() ? moved(kept(box), *o.transform) : kept(box);
  }

  bool& m_is_whole;
};

}  // namespace

core::Bounds stock_box(const ObjectDesc& object, bool& is_whole) {
  return BoxFinder(is_whole).of(object);
}

core::Bounds kept_stock_box(const ObjectDesc& object, bool& is_whole) {
  return BoxFinder(is_whole).kept_of(object);
}

core::Bounds kept_stock_box(const core::Bounds& box) { return kept(box); }

bool heeds_regions(const ObjectDesc& object) {
  return object.reopened ||
         !object.is_any<Sparse<HeightFieldShape>, std::shared_ptr<const BlobShape>,
                        Sparse<JuliaFractalShape>>();
}

}  // namespace lentray::parser
