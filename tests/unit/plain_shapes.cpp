#include "tests/unit/plain_shapes.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/numeric/triangle_test.h"
#include "core/shape/blob.h"
#include "core/shape/lathe.h"
#include "core/shape/mesh.h"
#include "core/shape/prism.h"
#include "core/shape/sphere_sweep.h"
#include "core/shape/surface_of_revolution.h"

namespace lentray::core {
namespace {

using Hits = std::vector<Hit>;

Ray in_shape(const Leaf& leaf, const Ray& ray) {
  const Transform* t = leaf.transform();
  return t ? Ray{t->inverse_point(ray.origin), t->inverse_vector(ray.direction)} : ray;
}

void mesh_hits(const MeshData& data, const Ray& ray, double t_min, double t_max, ShapeHits& hits) {
  const ShearedRay sheared(ray);
  const auto& p = data.vertices;
  for (std::uint32_t face = 0; face < data.faces.size(); ++face) {
    const MeshTriple& v = data.faces[face];
    TriangleHit hit;
    if (intersect_triangle(sheared, p[v[0]], p[v[1]], p[v[2]], hit) && hit.t > t_min &&
        hit.t < t_max)
      hits.push_back({hit.t, face, hit.wb, hit.wc});
  }
}

void shape_hits(const Shape& shape, const Ray& ray, double t_min, double t_max, ShapeHits& hits) {
  const auto* mesh = dynamic_cast<const Mesh*>(&shape);
  if (!mesh) return shape.all(ray, t_min, t_max, hits);
  mesh_hits(mesh->triangles().data(), ray, t_min, t_max, hits);
}

bool every_inside(const Object::Regions& regions, const Vec3& p);

bool is_inside(const Leaf& leaf, const Vec3& p) {
  const Vec3 q = leaf.transform() ? leaf.transform()->inverse_point(p) : p;
  return leaf.is_inverse() ? leaf.shape().outside(q) : leaf.shape().inside(q);
}

bool joins(CsgKind kind) { return kind == CsgKind::kUnion || kind == CsgKind::kMerge; }

bool is_inside(const Object& object, const Vec3& p) {
  if (!every_inside(object.clips(), p)) return false;
  if (const auto* leaf = dynamic_cast<const Leaf*>(&object)) return is_inside(*leaf, p);
  const auto& csg = dynamic_cast<const Csg&>(object);
  const auto holds = [&](const auto& child) { return is_inside(*child, p); };
  return joins(csg.kind()) ? std::ranges::any_of(csg.children(), holds)
                           : std::ranges::all_of(csg.children(), holds);
}

bool every_inside(const Object::Regions& regions, const Vec3& p) {
  return std::ranges::all_of(regions, [&](const auto& region) { return is_inside(*region, p); });
}

/// Of coinciding surfaces each may seem to hide the other, by rounding: the second then counts if the whole
/// begins or ends there.
class Coinciding {
 public:
  Coinciding(const Csg& csg, const Ray& ray) : m_csg(csg), m_ray(ray) {}
  bool counts(double t) {
    if (m_csg.kind() == CsgKind::kDifference) return false;
    const Vec3& o = m_ray.origin;
    const double near = 1e-9 * (std::fabs(t) + std::fabs(o.x) + std::fabs(o.y) + std::fabs(o.z));
    if (std::ranges::any_of(m_hidden, [&](double at) { return std::fabs(at - t) < near; }))
      return holds(t - near) != holds(t + near);
    m_hidden.push_back(t);
    return false;
  }

 private:
  /// Without the clips of the whole.
  bool holds(double t) const {
    const auto holds_it = [&](const auto& child) { return is_inside(*child, m_ray.at(t)); };
    return joins(m_csg.kind()) ? std::ranges::any_of(m_csg.children(), holds_it)
                               : std::ranges::all_of(m_csg.children(), holds_it);
  }

  const Csg& m_csg;
  const Ray& m_ray;
  std::vector<double> m_hidden;
};

void add_hits(const Object& object, const Ray& ray, double t_min, double t_max, Hits& out);

bool is_let_through(const Object& object, const Ray& ray) {
  return std::ranges::all_of(object.gates(), [&](const auto& gate) {
    Hits met;
    add_hits(*gate, ray, 0.0, Bounds::kInf, met);
    return !met.empty() || is_inside(*gate, ray.origin);
  });
}

/// Before the clips of the whole; the last part first.
void add_csg(const Csg& csg, const Ray& ray, double t_min, double t_max, Hits& out) {
  Coinciding coinciding(csg, ray);
  const auto& parts = csg.children();
  for (std::size_t i = parts.size(); i-- > 0;) {
    Hits of_part;
    add_hits(*parts[i], ray, t_min, t_max, of_part);
    for (const Hit& hit : of_part) {
      bool kept = true;
      for (std::size_t k = 0; k < parts.size() && csg.kind() != CsgKind::kUnion; ++k) {
        if (k != i && is_inside(*parts[k], ray.at(hit.t)) == joins(csg.kind())) kept = false;
      }
      if (kept || coinciding.counts(hit.t)) out.push_back(hit);
    }
  }
}

void add_hits(const Object& object, const Ray& ray, double t_min, double t_max, Hits& out) {
  if (!is_let_through(object, ray)) return;
  Hits found;
  if (const auto* leaf = dynamic_cast<const Leaf*>(&object)) {
    ShapeHits hits;
    shape_hits(leaf->shape(), in_shape(*leaf, ray), t_min, t_max, hits);
    for (const ShapeHit& hit : hits) found.push_back({hit.t, leaf, nullptr, hit, 0});
  } else {
    add_csg(dynamic_cast<const Csg&>(object), ray, t_min, t_max, found);
  }
  for (const Hit& hit : found) {
    if (every_inside(object.clips(), ray.at(hit.t))) out.push_back(hit);
  }
}

/// Of equal distances the first in the list.
bool take_nearest(const Hits& hits, Hit& hit) {
  const auto first = std::ranges::min_element(hits, {}, &Hit::t);
  if (first == hits.end()) return false;
  hit = *first;
  return true;
}

bool find_nearest(const Object& object, const Ray& ray, double t_min, double t_max, Hit& hit) {
  const auto* leaf = dynamic_cast<const Leaf*>(&object);
  if (leaf && leaf->clips().empty() && !dynamic_cast<const Mesh*>(&leaf->shape())) {
    ShapeHit found;
    if (!is_let_through(object, ray) ||
        !leaf->shape().nearest(in_shape(*leaf, ray), t_min, t_max, found))
      return false;
    hit = {found.t, leaf, nullptr, found, 0};
    return true;
  }
  Hits hits;
  const auto* csg = dynamic_cast<const Csg*>(&object);
  if (csg && csg->kind() == CsgKind::kUnion && csg->clips().empty()) {
    if (!is_let_through(object, ray)) return false;
    for (std::size_t i = csg->children().size(); i-- > 0;) {
      Hit of_part;
      if (find_nearest(*csg->children()[i], ray, t_min, t_max, of_part)) hits.push_back(of_part);
    }
  } else {
    add_hits(object, ray, t_min, t_max, hits);
  }
  return take_nearest(hits, hit);
}

}  // namespace

void PlainShapes::open(Outline& outline) {
  outline.m_lo = {-Bounds::kInf, -Bounds::kInf};
  outline.m_hi = {Bounds::kInf, Bounds::kInf};
  outline.m_boxes.assign(outline.m_boxes.size(), {outline.m_lo, outline.m_hi});
  outline.fill_squares();
}

void PlainShapes::open(Shape& shape) {
  const Bounds all = Bounds::everything();
  if (auto* sweep = dynamic_cast<SphereSweep*>(&shape)) {
    sweep->m_boxes.assign(sweep->m_boxes.size(), all);
  } else if (auto* sor = dynamic_cast<SurfaceOfRevolution*>(&shape)) {
    sor->m_reach = all;  // its pieces' widths tell where roots are looked for: they stay
  } else if (auto* lathe = dynamic_cast<Lathe*>(&shape)) {
    lathe->m_reach = all;
    for (auto& p : lathe->m_pieces) p = {p.curve, -Bounds::kInf, Bounds::kInf, Bounds::kInf};
  } else if (auto* prism = dynamic_cast<Prism*>(&shape)) {
    auto outline = std::make_shared<Outline>(*prism->m_outline);
    open(*outline);
    prism->m_outline = std::move(outline);
    prism->m_reach = all;
  } else if (auto* blob = dynamic_cast<Blob*>(&shape)) {
    blob->m_fields.m_boxes.assign(blob->m_fields.m_boxes.size(), all);
    blob->m_fields.m_search = WideBvh();
  }
}

PlainObject::PlainObject(Object& object) : m_object(object) {
  std::vector<const Leaf*> leaves;
  object.leaves(leaves);
  // The object is the test's own, and may be written.
  for (const Leaf* leaf : leaves) PlainShapes::open(const_cast<Shape&>(leaf->shape()));
}

void PlainObject::all(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits,
                      const RayQuery&) const {
  add_hits(m_object, ray, t_min, t_max, hits);
}

bool PlainObject::nearest(const Ray& ray, double t_min, double t_max, Hit& hit,
                          const RayQuery&) const {
  return find_nearest(m_object, ray, t_min, t_max, hit);
}

bool PlainObject::any(const Ray& ray, double t_min, double t_max, const RayQuery& query) const {
  Hit hit;
  return nearest(ray, t_min, t_max, hit, query);
}

bool PlainObject::inside(const Vec3& p) const { return is_inside(m_object, p); }

}  // namespace lentray::core
