#include "parser/shapes/shapes.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/shape/bicubic_patch.h"
#include "core/shape/blob.h"
#include "core/shape/box.h"
#include "core/shape/cone.h"
#include "core/shape/cylinder.h"
#include "core/shape/disc.h"
#include "core/shape/double_cone.h"
#include "core/shape/height_field.h"
#include "core/shape/isosurface.h"
#include "core/shape/julia_fractal.h"
#include "core/shape/lathe.h"
#include "core/shape/ovus.h"
#include "core/shape/parametric.h"
#include "core/shape/plane.h"
#include "core/shape/poly.h"
#include "core/shape/polygon.h"
#include "core/shape/prism.h"
#include "core/shape/quadric.h"
#include "core/shape/smooth_triangle.h"
#include "core/shape/sphere.h"
#include "core/shape/sphere_sweep.h"
#include "core/shape/superellipsoid.h"
#include "core/shape/surface_of_revolution.h"
#include "core/shape/torus.h"
#include "core/shape/triangle.h"
#include "core/shape/triangle_mesh.h"
#include "parser/shapes/blob_fields.h"
#include "parser/shapes/height_grid.h"
#include "parser/shapes/spline_pieces.h"
#include "parser/shapes/sweep_pieces.h"

namespace lentray::parser {
namespace {

using ShapePointer = std::unique_ptr<core::Shape>;

/// Equal normals are no normals: the triangle's own counts then, in stock, which points where the
/// order of the vertices says. The distance squared as stock's.
bool is_flat(const core::MeshData& data, const core::MeshTriple& normals) {
  constexpr double kEqual = 1e-10;
  if (normals[0] == core::kNoIndex) return false;
  const Vec3 &a = data.normals[normals[0]], &b = data.normals[normals[1]],
             &c = data.normals[normals[2]];
  return length_squared(a - b) <= kEqual && length_squared(a - c) <= kEqual;
}

/// Whether some edge, by where it is, has an odd number of faces.
bool has_open_edges(const core::MeshData& data) {
  const auto key = [](const Vec3& p) {
    return std::array<double, 3>{p.x + 0.0, p.y + 0.0, p.z + 0.0};
  };
  std::map<std::array<double, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> place_of;
  place_of.reserve(data.vertices.size());
  for (const Vec3& p : data.vertices) {
    place_of.push_back(
        places.try_emplace(key(p), static_cast<std::uint32_t>(places.size())).first->second);
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(data.faces.size() * 3);
  for (const core::MeshTriple& face : data.faces) {
    for (const std::uint32_t v : face) {
      if (v >= place_of.size()) return false;  // refused later
    }
    for (std::size_t i = 0; i < 3; ++i) {
      edges.push_back(std::minmax(place_of[face[i]], place_of[face[(i + 1) % 3]]));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    while (end < edges.size() && edges[end] == edges[first]) ++end;
    if ((end - first) % 2 != 0) return true;
  }
  return false;
}

/// The kernel's form of a mesh.
core::MeshData mesh_data(const MeshShape& mesh) {
  core::MeshData data;
  data.vertices = mesh.vertices;
  data.uvs = mesh.uvs;
  data.normals.reserve(mesh.normals.size());
  for (const Vec3& n : mesh.normals) data.normals.push_back(normalized(n));
  data.faces = mesh.faces;
  data.face_normals = mesh.face_normals;
  data.face_uvs = mesh.face_uvs;
  data.face_textures = mesh.face_textures;
  for (core::MeshTriple& normals : data.face_normals.list) {
    if (is_flat(data, normals)) normals = {core::kNoIndex, core::kNoIndex, core::kNoIndex};
  }
  data.is_open = mesh.inside_vector && has_open_edges(data);
  return data;
}

core::JuliaFunction julia_function(std::string_view name) {
  using F = core::JuliaFunction;
  static const std::map<std::string_view, F> kFunctions{
      {"sqr", F::kSqr},     {"cube", F::kCube},   {"reciprocal", F::kReciprocal},
      {"exp", F::kExp},     {"ln", F::kLn},       {"sin", F::kSin},
      {"asin", F::kAsin},   {"cos", F::kCos},     {"acos", F::kAcos},
      {"tan", F::kTan},     {"atan", F::kAtan},   {"sinh", F::kSinh},
      {"asinh", F::kAsinh}, {"cosh", F::kCosh},   {"acosh", F::kAcosh},
      {"tanh", F::kTanh},   {"atanh", F::kAtanh}, {"pwr", F::kPwr}};
  return kFunctions.at(name);
}

std::pair<Vec3, Vec3> sorted(const ContainerShape& box) {
  std::pair<Vec3, Vec3> corners;
  for (int i = 0; i < 3; ++i) {
    corners.first[i] = std::min(box.a[i], box.b[i]);
    corners.second[i] = std::max(box.a[i], box.b[i]);
  }
  return corners;
}

/// How near a lathe's curve comes to the axis, in stock; of Bezier curves their control points count.
double hole_of(const LatheShape& s, const std::vector<core::CurvePiece>& pieces) {
  double least = core::Bounds::kInf;
  if (s.spline == CurveKind::kBezier) {
    for (const core::Vec2& p : s.points) least = std::min(least, p.u);
  } else {
    for (const core::CurvePiece& piece : pieces)
      least = std::min(least, -piece.farthest({-1.0, 0.0}));
  }
  return least;
}

struct ShapeMaker {
  const ObjectDesc& object;

  ShapePointer operator()(const SphereShape& s) const {
    return std::make_unique<core::Sphere>(s.centre, s.radius);
  }
  ShapePointer operator()(const BoxShape& s) const {
    return std::make_unique<core::Box>(s.corner1, s.corner2);
  }
  ShapePointer operator()(const PlaneShape& s) const {
    return std::make_unique<core::Plane>(s.normal, s.distance);
  }
  ShapePointer operator()(const CylinderShape& s) const {
    return std::make_unique<core::Cylinder>(s.base, s.cap, s.radius, s.open);
  }
  ShapePointer operator()(const ConeShape& s) const {
    // Stock goes by the end of the larger radius, below zero or not. Both below: a cylinder.
    const double larger = std::max(s.base_radius, s.cap_radius),
                 smaller = std::min(s.base_radius, s.cap_radius);
    if (larger < 0.0) return std::make_unique<core::Cone>(s.base, larger, s.cap, larger, s.open);
    if (larger > 0.0 && smaller < 0.0) {
      return std::make_unique<core::DoubleCone>(s.base, s.base_radius, s.cap, s.cap_radius, s.open);
    }
    return std::make_unique<core::Cone>(s.base, s.base_radius, s.cap, s.cap_radius, s.open);
  }
  ShapePointer operator()(const TorusShape& s) const {
    return std::make_unique<core::Torus>(s.major, s.minor);
  }
  ShapePointer operator()(const DiscShape& s) const {
    return std::make_unique<core::Disc>(s.centre, s.normal, s.radius, s.hole);
  }
  ShapePointer operator()(const TriangleShape& s) const {
    return std::make_unique<core::Triangle>(s.p[0], s.p[1], s.p[2]);
  }
  ShapePointer operator()(const Sparse<SmoothTriangleShape>& shape) const {
    const SmoothTriangleShape& s = *shape;
    return std::make_unique<core::SmoothTriangle>(s.p[0], s.n[0], s.p[1], s.n[1], s.p[2], s.n[2]);
  }
  ShapePointer operator()(const PolygonShape& s) const {
    return std::make_unique<core::Polygon>(s.points);
  }
  ShapePointer operator()(const Sparse<QuadricShape>& s) const {
    return std::make_unique<core::Quadric>(s->c);
  }
  ShapePointer operator()(const Sparse<HeightFieldShape>& shape) const {
    return std::make_unique<core::HeightField>(build_height_grid(shape), shape->water_level);
  }
  ShapePointer operator()(const std::shared_ptr<const BicubicPatchShape>& s) const {
    return std::make_unique<core::BicubicPatch>(s->points, s->u_steps, s->v_steps, s->flatness,
                                                s->uv.value_or(core::BicubicPatch::kUnitSquare));
  }
  ShapePointer operator()(const std::shared_ptr<const BlobShape>& s) const {
    return std::make_unique<core::Blob>(s->threshold, blob_fields(*s));
  }
  ShapePointer operator()(const Sparse<IsosurfaceShape>& shape) const {
    const IsosurfaceShape& s = *shape;
    constexpr int kMostSurfaces = 10;
    core::IsosurfaceSettings set;
    set.function = s.function->function;
    set.in_sphere = s.container.sphere;
    std::tie(set.lo, set.hi) = sorted(s.container);
    set.centre = s.container.a;
    set.radius = s.container.radius;
    set.threshold = s.threshold;
    set.accuracy = s.accuracy;
    set.max_gradient = s.max_gradient;
    if (s.evaluate) {
      set.evaluates = true;
      set.max_gradient =
          std::max(s.max_gradient, (*s.evaluate)[0]);  // stock's first ray begins there
      set.growth = (*s.evaluate)[1];
      set.shrinking = (*s.evaluate)[2];
    }
    set.max_trace = s.all_intersections ? kMostSurfaces : s.max_trace;
    set.open = s.open;
    return std::make_unique<core::Isosurface>(std::move(set));
  }
  ShapePointer operator()(const Sparse<JuliaFractalShape>& shape) const {
    const JuliaFractalShape& s = *shape;
    core::JuliaSettings set;
    set.hypercomplex = s.hypercomplex;
    set.function = julia_function(s.function);
    set.parameter = s.parameter;
    set.slice = s.slice;
    set.slice_distance = s.slice_distance;
    set.precision = s.precision;
    set.max_iteration = std::max(s.max_iteration, 1);
    set.exponent = s.exponent;
    return core::make_julia_fractal(set);
  }
  ShapePointer operator()(const LatheShape& s) const {
    auto pieces = spline_pieces(s.spline, s.points, false);
    const double hole = hole_of(s, pieces);
    return std::make_unique<core::Lathe>(std::move(pieces), hole);
  }
  ShapePointer operator()(const OvusShape& s) const {
    // The lower sphere is then within the upper one, as stock has it.
    if (s.top >= 2.0 * s.bottom) {
      return std::make_unique<core::Sphere>(Vec3{0.0, s.bottom, 0.0}, s.top);
    }
    return std::make_unique<core::Ovus>(s.bottom, s.top);
  }
  ShapePointer operator()(const SorShape& s) const {
    return std::make_unique<core::SurfaceOfRevolution>(s.points, s.open);
  }
  ShapePointer operator()(const SphereSweepShape& s) const {
    return std::make_unique<core::SphereSweep>(sweep_pieces(s), s.tolerance);
  }
  ShapePointer operator()(const Sparse<ParametricShape>& shape) const {
    const ParametricShape& s = *shape;
    core::ParametricSettings set;
    for (std::size_t i = 0; i < 3; ++i) set.functions[i] = s.functions[i]->function;
    set.lo = s.lo;
    set.hi = s.hi;
    set.in_sphere = s.container.sphere;
    std::tie(set.box_lo, set.box_hi) = sorted(s.container);
    set.centre = s.container.a;
    set.radius = s.container.radius;
    set.accuracy = s.accuracy;
    set.max_gradient = s.max_gradient;
    set.precompute_depth = s.precompute_depth;
    set.precompute = s.precompute;
    return std::make_unique<core::Parametric>(std::move(set));
  }
  ShapePointer operator()(const PolyShape& s) const {
    const std::string_view name = s.order == 3 ? "cubic" : s.order == 4 ? "quartic" : "poly";
    return std::make_unique<core::Poly>(name, s.order, s.coefficients);
  }
  ShapePointer operator()(const SuperellipsoidShape& s) const {
    return std::make_unique<core::Superellipsoid>(s.e, s.n);
  }
  ShapePointer operator()(const PrismShape& s) const {
    auto outline = std::make_shared<core::Outline>(spline_pieces(s.spline, s.points, true));
    using Sweep = core::Prism::Sweep;
    return std::make_unique<core::Prism>("prism", std::move(outline),
                                         s.conic_sweep ? Sweep::kConic : Sweep::kAlongY, s.height1,
                                         s.height2, s.open);
  }
  ShapePointer operator()(const std::shared_ptr<const MeshShape>&) const {
    return build_mesh(object);
  }
  /// Everything else is kept for later.
  template <typename Other>
  ShapePointer operator()(const Other&) const {
    return nullptr;
  }
};

}  // namespace

std::unique_ptr<core::Mesh> build_mesh(const ObjectDesc& object, const core::Transform& to_world) {
  const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&object.shape);
  if (!mesh) return nullptr;
  if (!(*mesh)->compiled) {
    (*mesh)->compiled = std::make_shared<const core::TriangleMesh>(mesh_data(**mesh));
  }
  // Stock does not turn it with the mesh.
  std::optional<Vec3> inside_vector = (*mesh)->inside_vector;
  if (inside_vector) inside_vector = to_world.inverse_vector(*inside_vector);
  return std::make_unique<core::Mesh>((*mesh)->compiled, inside_vector, object.keyword == "mesh2");
}

ShapePointer build_shape(const ObjectDesc& object) {
  return std::visit(ShapeMaker{object}, object.shape);
}

}  // namespace lentray::parser
