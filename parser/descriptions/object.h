// An object statement, read: a shape, its children, its modifiers. Plain data; shapes are in
// the space of their statement and `transform` leads out of it. Shared and never changed once
// made; whoever modifies copies first (children and big tables are shared, so copies are cheap).
// Source: reference manual 3.7, "Objects", "Object Modifiers".
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/bounds.h"
#include "core/base/color.h"
#include "core/base/ray.h"
#include "core/base/transform.h"
#include "core/base/vec3.h"
#include "core/shape/mesh_data.h"
#include "parser/base/sparse.h"
#include "parser/descriptions/light.h"
#include "parser/descriptions/nesting.h"
#include "parser/descriptions/placement.h"
#include "parser/source/source.h"
#include "parser/values/value.h"

namespace lentray::core {
class Object;
class TriangleMesh;
}

namespace lentray::parser {

using core::Vec2;
using core::Vec3;

// ---- shapes of the first part -------------------------------------------------------------

struct SphereShape { Vec3 centre; double radius = 1.0; };
struct BoxShape { Vec3 corner1, corner2; };
struct PlaneShape { Vec3 normal; double distance = 0.0; };   ///< normal as written
struct CylinderShape { Vec3 base, cap; double radius = 1.0; bool open = false; };
struct ConeShape { Vec3 base, cap; double base_radius = 1.0, cap_radius = 0.0; bool open = false; };
struct TorusShape { double major = 1.0, minor = 0.25; };
struct DiscShape { Vec3 centre, normal{0, 0, 1}; double radius = 1.0, hole = 0.0; };
struct TriangleShape { std::array<Vec3, 3> p; };
struct SmoothTriangleShape { std::array<Vec3, 3> p, n; };    ///< n: weigh as they are long, see parser/stock/triangle_steps.h
struct PolygonShape { std::vector<Vec3> points; };           ///< closed sub-polygons, as written
/// a x2 + b y2 + c z2 + d xy + e xz + f yz + g x + h y + i z + j = 0
struct QuadricShape { std::array<double, 10> c{}; };

/// mesh and mesh2 alike.
struct MeshShape {
  std::vector<Vec3> vertices, normals;
  std::vector<Vec2> uvs;
  std::vector<Ref<TextureDesc>> textures;
  std::vector<core::MeshTriple> faces;     ///< into vertices
  core::MeshTriples face_normals;          ///< into normals; none: flat
  core::MeshTriples face_uvs;              ///< into uvs
  core::MeshTriples face_textures;         ///< into textures; none: the object's
  std::optional<Vec3> inside_vector;
  /// The triangles as the kernel has them, made when first asked; placed copies share them.
  mutable std::shared_ptr<const core::TriangleMesh> compiled;
};

enum class CsgOperation { kUnion, kMerge, kIntersection, kDifference, kLightGroup };
using Children = std::vector<Ref<ObjectDesc>>;
struct CsgShape {
  CsgOperation operation = CsgOperation::kUnion;
  std::shared_ptr<const Children> children;
  bool split_union = true;
  bool cutaway_textures = false;
  bool global_lights = false;      ///< light_group
  bool has_triangles = false;
};
struct LightShape { Ref<LightDesc> light; };

// ---- shapes that are read and kept; rendered later ----------------------------------------

struct BlobElement {
  enum class Kind { kSphere, kCylinder } kind = Kind::kSphere;
  Vec3 a, b;
  double radius = 1.0, strength = 1.0;
  core::Transform transform;
  Ref<TextureDesc> texture;
};
struct BlobShape { double threshold = 1.0; std::vector<BlobElement> elements; };
struct BicubicPatchShape {
  int type = 0, u_steps = 0, v_steps = 0;
  double flatness = 0.0;
  std::array<Vec3, 16> points;
  std::optional<std::array<Vec2, 4>> uv;
};
struct HeightFieldShape {
  std::string file_type;
  FoundFile file;
  std::optional<double> file_gamma;     ///< less than 0: sRGB
  Ref<FunctionDesc> function;           ///< instead of a file
  Ref<PigmentDesc> pigment;             ///< `function w, h { pigment {...} }`
  int width = 0, height = 0;            ///< of the function
  double water_level = 0.0;
  bool smooth = false;
};
/// `contained_by`
struct ContainerShape { bool sphere = false; Vec3 a{-1, -1, -1}, b{1, 1, 1}; double radius = 1.0; };
struct IsosurfaceShape {
  Ref<FunctionDesc> function;
  ContainerShape container;
  double threshold = 0.0, accuracy = 0.001, max_gradient = 1.1;
  std::optional<std::array<double, 3>> evaluate;
  int max_trace = 1;
  bool all_intersections = false, open = false;
};
struct JuliaFractalShape {
  std::array<double, 4> parameter{1, 0, 0, 0}, slice{0, 0, 0, 1};
  double slice_distance = 0.0, precision = 20.0;
  Vec2 exponent;
  int max_iteration = 20;
  bool hypercomplex = false;
  std::string function = "sqr";
};
enum class CurveKind { kLinear, kQuadratic, kCubic, kBezier, kB, kNatural };
struct LatheShape { CurveKind spline = CurveKind::kLinear; std::vector<Vec2> points; };
struct OvusShape { double bottom = 1.0, top = 0.5; };
struct ParametricShape {
  std::array<Ref<FunctionDesc>, 3> functions;
  Vec2 lo, hi;
  ContainerShape container;
  double max_gradient = 1.0, accuracy = 0.001;
  int precompute_depth = 0;
  std::array<bool, 3> precompute{false, false, false};
};
/// Coefficients in the order of the manual, "Poly, Cubic and Quartic".
struct PolyShape { int order = 2; std::vector<double> coefficients; };
struct PrismShape {
  CurveKind spline = CurveKind::kLinear;
  bool conic_sweep = false, open = false;
  double height1 = 0.0, height2 = 1.0;
  std::vector<Vec2> points;
};
struct SorShape { std::vector<Vec2> points; bool open = false; };
struct SphereSweepShape {
  CurveKind spline = CurveKind::kLinear;
  std::vector<Vec3> centres;
  std::vector<double> radii;
  double tolerance = 1e-6;
};
struct SuperellipsoidShape { double e = 1.0, n = 1.0; };
struct TextShape {
  FoundFile font;
  std::string text;      ///< UTF-8
  double thickness = 1.0;
  Vec3 offset;           ///< added after each glyph; its z means nothing
  bool unicode = false;  ///< charset utf8: a font's Unicode table comes before Macintosh's
};

/// Large ones apart: there may be a million of the small.
using ShapeDesc =
    std::variant<SphereShape, BoxShape, PlaneShape, CylinderShape, ConeShape, TorusShape, DiscShape,
                 TriangleShape, Sparse<SmoothTriangleShape>, PolygonShape, Sparse<QuadricShape>,
                 std::shared_ptr<const MeshShape>, CsgShape, LightShape,
                 std::shared_ptr<const BlobShape>, std::shared_ptr<const BicubicPatchShape>,
                 Sparse<HeightFieldShape>, Sparse<IsosurfaceShape>, Sparse<JuliaFractalShape>, LatheShape, OvusShape,
                 Sparse<ParametricShape>, PolyShape, PrismShape, SorShape, SphereSweepShape,
                 SuperellipsoidShape, Sparse<TextShape>>;

/// The object compiled for inside(), trace() and the extents; a copy starts without it.
struct CompiledSlot {
  struct Compiled {
    std::shared_ptr<const core::Object> object;
    bool is_whole = true;   ///< false: parts of it have no geometry yet
    double farthest = core::kFarthest;  ///< up to which trace() sees it
  };
  std::shared_ptr<const Compiled> made;   ///< null: not tried yet
  CompiledSlot() = default;
  CompiledSlot(const CompiledSlot&) {}
  CompiledSlot& operator=(const CompiledSlot&) {
    made.reset();
    return *this;
  }
};

/// What few objects have. Apart, as there may be a million objects; named in dumps as if it were not.
struct RareParts {
  Ref<TextureDesc> interior_texture;    ///< null: the same as `texture`
  Ref<InteriorDesc> interior;           ///< null: inherited
  std::vector<Ref<ObjectDesc>> clipped_by, bounded_by;
  std::optional<double> radiosity_importance;
  PhotonFlags photons;
};

struct ObjectDesc {
  Location where;
  std::string_view keyword;             ///< of the statement, for messages; a reserved word
  ShapeDesc shape;
  Sparse<Placement> transform;

  // Looks and bounds have been moved by the transforms that followed them in the statement.
  Ref<TextureDesc> texture;             ///< null: inherited, at last the default texture
  Sparse<RareParts> rare;
  bool bounds_are_clips = false;        ///< bounded_by { clipped_by } or the other way round

  bool inverse = false;
  bool no_shadow = false, no_image = false, no_reflection = false, no_radiosity = false;
  std::optional<bool> double_illuminate;   ///< of a CSG: holds for everything in it
  std::optional<bool> hollow;           ///< unset: a surrounding CSG may set it
  bool sturm = false, hierarchy = true, uv_mapping = false;
  bool reopened = false;                ///< went through the braces of object {}
  bool copied = false;                  ///< made from an identifier: of use to nested light groups

  Nesting nesting;                      ///< objects and looks in it

  mutable CompiledSlot compiled;

  bool is_light() const { return std::holds_alternative<LightShape>(shape); }
  const CsgShape* csg() const { return std::get_if<CsgShape>(&shape); }
};

}  // namespace lentray::parser
