#include "parser/grammar/object_shapes.h"

#include <algorithm>

#include "core/base/tiny.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/object.h"
#include "parser/stock/triangle_steps.h"

namespace lentray::parser {
namespace {

using core::kTiny;

bool is_degenerate(const std::array<Vec3, 3>& p) {
  return length_squared(cross(p[1] - p[0], p[2] - p[0])) == 0.0;
}

}  // namespace

bool is_patch(const ObjectDesc& object) {
  if (const CsgShape* csg = object.csg()) {
    return std::any_of(csg->children->begin(), csg->children->end(),
                       [](const Ref<ObjectDesc>& child) { return is_patch(*child); });
  }
  if (const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&object.shape)) {
    return !(*mesh)->inside_vector;
  }
  return object.is_any<LightShape, TriangleShape, Sparse<SmoothTriangleShape>,
                       Sparse<ParametricShape>, std::shared_ptr<const BicubicPatchShape>>();
}

ShapeDesc parse_sphere(Parser& parser, Context&) {
  SphereShape s;
  parse_values(parser, s.centre, s.radius);
  return s;
}

ShapeDesc parse_box(Parser& parser, Context&) {
  BoxShape s;
  parse_values(parser, s.corner1, s.corner2);
  return s;
}

ShapeDesc parse_plane(Parser& parser, Context&) {
  PlaneShape s;
  s.normal = parser.parse_vector();
  parser.parse_comma();
  if (length(s.normal) < kTiny) parser.fail("Degenerate plane normal.");
  s.distance = parser.parse_float();
  return s;
}

ShapeDesc parse_cylinder(Parser& parser, Context&) {
  CylinderShape s;
  parse_values(parser, s.base, s.cap, s.radius);
  s.open = parser.accept(Keyword::kOpen);
  if (length(s.cap - s.base) < kTiny) {
    parser.fail("Degenerate cylinder, base point = apex point.");
  }
  return s;
}

ShapeDesc parse_cone(Parser& parser, Context&) {
  ConeShape s;
  parse_values(parser, s.base, s.base_radius, s.cap, s.cap_radius);
  s.open = parser.accept(Keyword::kOpen);
  if (length(s.cap - s.base) < kTiny) {
    parser.fail("Degenerate cone, base point = apex point.");
  }
  return s;
}

ShapeDesc parse_torus(Parser& parser, Context&) {
  TorusShape s;
  parse_values(parser, s.major, s.minor);
  return s;
}

ShapeDesc parse_disc(Parser& parser, Context&) {
  DiscShape s;
  parse_values(parser, s.centre, s.normal, s.radius);
  s.hole = next_float(parser, 0.0);
  return s;
}

ShapeDesc parse_triangle(Parser& parser, Context&) {
  const Location where = parser.location();
  TriangleShape s;
  for (Vec3& p : s.p) {
    p = parser.parse_vector();
    parser.parse_comma();
  }
  if (is_degenerate(s.p)) parser.warn_at(where, "Degenerate triangle: it has no area.");
  return s;
}

ShapeDesc parse_smooth_triangle(Parser& parser, Context&) {
  const Location where = parser.location();
  SmoothTriangleShape s;
  for (int i = 0; i < 3; ++i) {
    parse_values(parser, s.p[i], s.n[i]);
    parser.parse_comma();
  }
  const bool flat =
      std::any_of(s.n.begin(), s.n.end(), [](const Vec3& n) { return length(n) == 0.0; });
  if (is_degenerate(s.p) || flat) {
    parser.warn_at(where, "Degenerate triangle: it has no area or a normal of no length.");
  }
  for (Vec3& n : s.n) n = normalized(n);
  return s;
}

ShapeDesc parse_polygon(Parser& parser, Context&) {
  const Location where = parser.location();
  const int count = parser.parse_int();
  if (count < 3) parser.fail("Polygon needs at least three points.");
  PolygonShape s;
  constexpr int kMostReserved = 1 << 20;  // the number is only what the scene says
  s.points.reserve(static_cast<std::size_t>(std::min(count, kMostReserved)));
  for (int i = 0; i < count; ++i) {
    parser.parse_comma();
    s.points.push_back(parser.parse_vector());
  }
  // As stock: the first point that is repeated closes an outline and the next begins another.
  Vec3 first = s.points.front();
  bool open = true;
  for (std::size_t i = 1; i < s.points.size(); ++i) {
    if (!open) {
      first = s.points[i];
      open = true;
    } else if (s.points[i] == first) {
      open = false;
    }
  }
  if (open) {
    parser.warn_at(where, "This polygon is not closed: closing it.");
    s.points.push_back(first);
  }
  return s;
}

ShapeDesc parse_quadric(Parser& parser, Context&) {
  QuadricShape s;
  for (int group = 0; group < 3; ++group) {
    const Vec3 v = parser.parse_vector();
    parser.parse_comma();
    for (int i = 0; i < 3; ++i) s.c[group * 3 + i] = v[i];
  }
  s.c[9] = parser.parse_float();
  return s;
}

ShapeDesc parse_csg(Parser& parser, Context& context, CsgOperation operation) {
  auto children = std::make_shared<Children>();
  const bool solid =
      operation == CsgOperation::kIntersection || operation == CsgOperation::kDifference;
  const auto add = [&](Ref<ObjectDesc> child) {
    if (solid && is_patch(*child)) {
      parser.warn("what has no inside does not belong in an intersection or difference");
    }
    children->push_back(std::move(child));
  };
  while (Ref<ObjectDesc> child = accept_object(parser, context)) add(std::move(child));
  if (children->size() < 2 && operation != CsgOperation::kLightGroup &&
      parser.language_version() >= 150) {
    parser.warn("a CSG should have at least two objects");
  }
  CsgShape s;
  s.operation = operation;
  s.has_triangles =
      std::any_of(children->begin(), children->end(),
                  [](const Ref<ObjectDesc>& child) { return has_triangles(child->shape); });
  s.children = std::move(children);
  return s;
}

}  // namespace lentray::parser
