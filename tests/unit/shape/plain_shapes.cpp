#include "tests/unit/shape/plain_shapes.h"

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

using PlainHits = std::vector<Hit>;

Ray plain_ray(const Leaf& leaf, const Ray& ray) {
  const Transform* t = leaf.transform();
  return t ? Ray{t->inverse_point(ray.origin), t->inverse_vector(ray.direction)} : ray;
}

void plain_mesh_hits(const MeshData& data, const Ray& ray, double t_min, double t_max,
                     ShapeHits& hits) {
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

void plain_shape_hits(const Shape& shape, const Ray& ray, double t_min, double t_max,
                      ShapeHits& hits) {
  const auto* mesh = dynamic_cast<const Mesh*>(&shape);
  if (!mesh) return shape.all(ray, t_min, t_max, hits);
  plain_mesh_hits(mesh->triangles().data(), ray, t_min, t_max, hits);
}

bool plain_every_inside(const Object::Regions& regions, const Vec3& p);

bool plain_is_inside(const Leaf& leaf, const Vec3& p) {
  const Vec3 q = leaf.transform() ? leaf.transform()->inverse_point(p) : p;
  return leaf.shape().holds(q, leaf.is_inverse());
}

bool plain_joins(CsgKind kind) { return kind == CsgKind::kUnion || kind == CsgKind::kMerge; }

bool plain_is_inside(const Object& object, const Vec3& p) {
  if (const auto* gated = dynamic_cast<const Gated*>(&object))
    return plain_is_inside(gated->content(), p);
  if (!plain_every_inside(object.clips(), p)) return false;
  if (const auto* leaf = dynamic_cast<const Leaf*>(&object)) return plain_is_inside(*leaf, p);
  const auto& csg = dynamic_cast<const Csg&>(object);
  const auto holds = [&](const auto& child) { return plain_is_inside(*child, p); };
  return plain_joins(csg.kind()) ? std::ranges::any_of(csg.children(), holds)
                                 : std::ranges::all_of(csg.children(), holds);
}

bool plain_every_inside(const Object::Regions& regions, const Vec3& p) {
  return std::ranges::all_of(regions,
                             [&](const auto& region) { return plain_is_inside(*region, p); });
}

/// Of coinciding surfaces each may seem to hide the other, by rounding: the second then counts if the whole
/// begins or ends there.
class PlainCoinciding {
 public:
  PlainCoinciding(const Csg& csg, const Ray& ray) : m_csg(csg), m_ray(ray) {}
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
    const auto holds_it = [&](const auto& child) { return plain_is_inside(*child, m_ray.at(t)); };
    return plain_joins(m_csg.kind()) ? std::ranges::any_of(m_csg.children(), holds_it)
                                     : std::ranges::all_of(m_csg.children(), holds_it);
  }

  const Csg& m_csg;
  const Ray& m_ray;
  std::vector<double> m_hidden;
};

void plain_add_hits(const Object& object, const Ray& ray, double t_min, double t_max,
                    PlainHits& out);

bool plain_lets_pass(const Gated& object, const Ray& ray) {
  return std::ranges::all_of(object.gates(), [&](const auto& gate) {
    PlainHits met;
    plain_add_hits(*gate, ray, 0.0, Bounds::kInf, met);
    return !met.empty() || plain_is_inside(*gate, ray.origin);
  });
}

/// Before the clips of the whole; the last part first.
void plain_add_csg(const Csg& csg, const Ray& ray, double t_min, double t_max, PlainHits& out) {
  PlainCoinciding coinciding(csg, ray);
  const auto& parts = csg.children();
  for (std::size_t i = parts.size(); i-- > 0;) {
    PlainHits of_part;
    plain_add_hits(*parts[i], ray, t_min, t_max, of_part);
    for (const Hit& hit : of_part) {
      bool kept = true;
      for (std::size_t k = 0; k < parts.size() && csg.kind() != CsgKind::kUnion; ++k) {
        if (k != i && plain_is_inside(*parts[k], ray.at(hit.t)) == plain_joins(csg.kind()))
          kept = false;
      }
      if (kept || coinciding.counts(hit.t)) out.push_back(hit);
    }
  }
}

void plain_add_hits(const Object& object, const Ray& ray, double t_min, double t_max,
                    PlainHits& out) {
  if (const auto* gated = dynamic_cast<const Gated*>(&object)) {
    if (plain_lets_pass(*gated, ray)) plain_add_hits(gated->content(), ray, t_min, t_max, out);
    return;
  }
  PlainHits found;
  if (const auto* leaf = dynamic_cast<const Leaf*>(&object)) {
    ShapeHits hits;
    plain_shape_hits(leaf->shape(), plain_ray(*leaf, ray), t_min, t_max, hits);
    for (const ShapeHit& hit : hits) found.push_back({hit.t, leaf, nullptr, hit, 0});
  } else {
    plain_add_csg(dynamic_cast<const Csg&>(object), ray, t_min, t_max, found);
  }
  for (const Hit& hit : found) {
    if (plain_every_inside(object.clips(), ray.at(hit.t))) out.push_back(hit);
  }
}

/// Of equal distances the first in the list.
bool plain_take_nearest(const PlainHits& hits, Hit& hit) {
  const auto first = std::ranges::min_element(hits, {}, &Hit::t);
  if (first == hits.end()) return false;
  hit = *first;
  return true;
}

bool plain_find_nearest(const Object& object, const Ray& ray, double t_min, double t_max,
                        Hit& hit) {
  if (const auto* gated = dynamic_cast<const Gated*>(&object))
    return plain_lets_pass(*gated, ray) &&
           plain_find_nearest(gated->content(), ray, t_min, t_max, hit);
  const auto* leaf = dynamic_cast<const Leaf*>(&object);
  if (leaf && leaf->clips().empty() && !dynamic_cast<const Mesh*>(&leaf->shape())) {
    ShapeHit found;
    if (!leaf->shape().nearest(plain_ray(*leaf, ray), t_min, t_max, found)) return false;
    hit = {found.t, leaf, nullptr, found, 0};
    return true;
  }
  PlainHits hits;
  const auto* csg = dynamic_cast<const Csg*>(&object);
  if (csg && csg->kind() == CsgKind::kUnion && csg->clips().empty()) {
    for (std::size_t i = csg->children().size(); i-- > 0;) {
      Hit of_part;
      if (plain_find_nearest(*csg->children()[i], ray, t_min, t_max, of_part))
        hits.push_back(of_part);
    }
  } else {
    plain_add_hits(object, ray, t_min, t_max, hits);
  }
  return plain_take_nearest(hits, hit);
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
  plain_add_hits(m_object, ray, t_min, t_max, hits);
}

bool PlainObject::nearest(const Ray& ray, double t_min, double t_max, Hit& hit,
                          const RayQuery&) const {
  return plain_find_nearest(m_object, ray, t_min, t_max, hit);
}

bool PlainObject::any(const Ray& ray, double t_min, double t_max, const RayQuery& query) const {
  Hit hit;
  return nearest(ray, t_min, t_max, hit, query);
}

bool PlainObject::inside(const Vec3& p) const { return plain_is_inside(m_object, p); }

}  // namespace lentray::core
