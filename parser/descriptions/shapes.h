// What the statement of a shape says, a struct a kind, each with the list of its members
// (fields.h). Plain data, in the space of the statement.
// Source: reference manual 3.7, "Finite Solid Primitives", "Finite Patch Primitives",
// "Infinite Solid Primitives", "Constructive Solid Geometry".
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/transform.h"
#include "core/base/vec3.h"
#include "core/shape/mesh_data.h"
#include "parser/base/sparse.h"
#include "parser/descriptions/fields.h"
#include "parser/source/source.h"
#include "parser/values/value.h"

namespace lentray::core {
class TriangleMesh;
}

namespace lentray::parser {

using core::Vec2;
using core::Vec3;

struct SphereShape {
  Vec3 centre;
  double radius = 1.0;
};
LENTRAY_FIELDS(SphereShape, centre, radius)

struct BoxShape {
  Vec3 corner1, corner2;
};
LENTRAY_FIELDS(BoxShape, corner1, corner2)

struct PlaneShape {
  Vec3 normal;  ///< as written
  double distance = 0.0;
};
LENTRAY_FIELDS(PlaneShape, normal, distance)

struct CylinderShape {
  Vec3 base, cap;
  double radius = 1.0;
  bool open = false;
};
LENTRAY_FIELDS(CylinderShape, base, cap, radius, open)

struct ConeShape {
  Vec3 base, cap;
  double base_radius = 1.0, cap_radius = 0.0;
  bool open = false;
};
LENTRAY_FIELDS(ConeShape, base, cap, base_radius, cap_radius, open)

struct TorusShape {
  double major = 1.0, minor = 0.25;
};
LENTRAY_FIELDS(TorusShape, major, minor)

struct DiscShape {
  Vec3 centre, normal{0, 0, 1};
  double radius = 1.0, hole = 0.0;
};
LENTRAY_FIELDS(DiscShape, centre, normal, radius, hole)

struct TriangleShape {
  std::array<Vec3, 3> p;
};
LENTRAY_FIELDS(TriangleShape, p)

struct SmoothTriangleShape {
  std::array<Vec3, 3> p;
  std::array<Vec3, 3> n;  ///< weigh as they are long, see parser/stock/triangle_steps.h
};
LENTRAY_FIELDS(SmoothTriangleShape, p, n)

struct PolygonShape {
  std::vector<Vec3> points;  ///< closed sub-polygons, as written
};
LENTRAY_FIELDS(PolygonShape, points)

/// a x2 + b y2 + c z2 + d xy + e xz + f yz + g x + h y + i z + j = 0
struct QuadricShape {
  std::array<double, 10> c{};
};
LENTRAY_FIELDS(QuadricShape, c)

/// mesh and mesh2 alike.
struct MeshShape {
  std::vector<Vec3> vertices, normals;
  std::vector<Vec2> uvs;
  std::vector<Ref<TextureDesc>> textures;
  std::vector<core::MeshTriple> faces;  ///< into vertices
  core::MeshTriples face_normals;       ///< into normals; none: flat
  core::MeshTriples face_uvs;           ///< into uvs
  core::MeshTriples face_textures;      ///< into textures; none: the object's
  std::optional<Vec3> inside_vector;
  /// The triangles as the kernel has them, made when first asked; placed copies share them.
  mutable std::shared_ptr<const core::TriangleMesh> compiled;
};
LENTRAY_FIELDS(MeshShape, vertices, normals, uvs, textures, faces, face_normals, face_uvs,
               face_textures, inside_vector, compiled)

enum class CsgOperation { kUnion, kMerge, kIntersection, kDifference, kLightGroup };
using Children = std::vector<Ref<ObjectDesc>>;
struct CsgShape {
  CsgOperation operation = CsgOperation::kUnion;
  std::shared_ptr<const Children> children;
  bool split_union = true;
  bool cutaway_textures = false;
  bool global_lights = false;  ///< light_group
  bool has_triangles = false;
};
LENTRAY_FIELDS(CsgShape, operation, children, split_union, cutaway_textures, global_lights,
               has_triangles)

struct LightShape {
  Ref<LightDesc> light;
};
LENTRAY_FIELDS(LightShape, light)

struct BlobElement {
  enum class Kind { kSphere, kCylinder } kind = Kind::kSphere;
  Vec3 a, b;
  double radius = 1.0, strength = 1.0;
  core::Transform transform;
  Ref<TextureDesc> texture;
};
LENTRAY_FIELDS(BlobElement, kind, a, b, radius, strength, transform, texture)

struct BlobShape {
  double threshold = 1.0;
  std::vector<BlobElement> elements;
  bool has_textures() const {
    return std::ranges::any_of(elements, [](const auto& e) { return e.texture != nullptr; });
  }
};
LENTRAY_FIELDS(BlobShape, threshold, elements)

struct BicubicPatchShape {
  int type = 0, u_steps = 0, v_steps = 0;
  double flatness = 0.0;
  std::array<Vec3, 16> points;
  std::optional<std::array<Vec2, 4>> uv;
};
LENTRAY_FIELDS(BicubicPatchShape, type, u_steps, v_steps, flatness, points, uv)

struct HeightFieldShape {
  std::string file_type;
  FoundFile file;
  std::optional<double> file_gamma;  ///< less than 0: sRGB
  Ref<FunctionDesc> function;        ///< instead of a file
  Ref<PigmentDesc> pigment;          ///< `function w, h { pigment {...} }`
  int width = 0, height = 0;         ///< of the function
  double water_level = 0.0;
  bool smooth = false;
};
LENTRAY_FIELDS(HeightFieldShape, file_type, file, file_gamma, function, pigment, width, height,
               water_level, smooth)

/// `contained_by`
struct ContainerShape {
  bool sphere = false;
  Vec3 a{-1, -1, -1}, b{1, 1, 1};
  double radius = 1.0;
};
LENTRAY_FIELDS(ContainerShape, sphere, a, b, radius)

struct IsosurfaceShape {
  Ref<FunctionDesc> function;
  ContainerShape container;
  double threshold = 0.0, accuracy = 0.001, max_gradient = 1.1;
  std::optional<std::array<double, 3>> evaluate;
  int max_trace = 1;
  bool all_intersections = false, open = false;
};
LENTRAY_FIELDS(IsosurfaceShape, function, container, threshold, accuracy, max_gradient, evaluate,
               max_trace, all_intersections, open)

struct JuliaFractalShape {
  std::array<double, 4> parameter{1, 0, 0, 0}, slice{0, 0, 0, 1};
  double slice_distance = 0.0, precision = 20.0;
  Vec2 exponent;
  int max_iteration = 20;
  bool hypercomplex = false;
  std::string function = "sqr";
};
LENTRAY_FIELDS(JuliaFractalShape, parameter, slice, slice_distance, precision, exponent,
               max_iteration, hypercomplex, function)

enum class CurveKind { kLinear, kQuadratic, kCubic, kBezier, kB, kNatural };
struct LatheShape {
  CurveKind spline = CurveKind::kLinear;
  std::vector<Vec2> points;
};
LENTRAY_FIELDS(LatheShape, spline, points)

struct OvusShape {
  double bottom = 1.0, top = 0.5;
};
LENTRAY_FIELDS(OvusShape, bottom, top)

struct ParametricShape {
  std::array<Ref<FunctionDesc>, 3> functions;
  Vec2 lo, hi;
  ContainerShape container;
  double max_gradient = 1.0, accuracy = 0.001;
  int precompute_depth = 0;
  std::array<bool, 3> precompute{false, false, false};
};
LENTRAY_FIELDS(ParametricShape, functions, lo, hi, container, max_gradient, accuracy,
               precompute_depth, precompute)

/// Coefficients in the order of the manual, "Poly, Cubic and Quartic".
struct PolyShape {
  int order = 2;
  std::vector<double> coefficients;
};
LENTRAY_FIELDS(PolyShape, order, coefficients)

struct PrismShape {
  CurveKind spline = CurveKind::kLinear;
  bool conic_sweep = false, open = false;
  double height1 = 0.0, height2 = 1.0;
  std::vector<Vec2> points;
};
LENTRAY_FIELDS(PrismShape, spline, conic_sweep, open, height1, height2, points)

struct SorShape {
  std::vector<Vec2> points;
  bool open = false;
};
LENTRAY_FIELDS(SorShape, points, open)

struct SphereSweepShape {
  CurveKind spline = CurveKind::kLinear;
  std::vector<Vec3> centres;
  std::vector<double> radii;
  double tolerance = 1e-6;
};
LENTRAY_FIELDS(SphereSweepShape, spline, centres, radii, tolerance)

struct SuperellipsoidShape {
  double e = 1.0, n = 1.0;
};
LENTRAY_FIELDS(SuperellipsoidShape, e, n)

struct TextShape {
  FoundFile font;
  std::string text;  ///< UTF-8
  double thickness = 1.0;
  Vec3 offset;           ///< added after each glyph; its z means nothing
  bool unicode = false;  ///< charset utf8: a font's Unicode table comes before Macintosh's
};
LENTRAY_FIELDS(TextShape, font, text, thickness, offset, unicode)

/// Large ones apart: there may be a million of the small.
using ShapeDesc =
    std::variant<SphereShape, BoxShape, PlaneShape, CylinderShape, ConeShape, TorusShape, DiscShape,
                 TriangleShape, Sparse<SmoothTriangleShape>, PolygonShape, Sparse<QuadricShape>,
                 std::shared_ptr<const MeshShape>, CsgShape, LightShape,
                 std::shared_ptr<const BlobShape>, std::shared_ptr<const BicubicPatchShape>,
                 Sparse<HeightFieldShape>, Sparse<IsosurfaceShape>, Sparse<JuliaFractalShape>,
                 LatheShape, OvusShape, Sparse<ParametricShape>, PolyShape, PrismShape, SorShape,
                 SphereSweepShape, SuperellipsoidShape, Sparse<TextShape>>;

}  // namespace lentray::parser
