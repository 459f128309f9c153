#include "core/shape/mesh.h"

#include "core/numeric/bounds_help.h"

namespace lentray::core {
namespace {
constexpr double kSelf = 1e-6;                // least depth of a mesh's crossings
constexpr std::size_t kLargestBaked = 20000;  // faces; building twice costs more than moving rays
}  // namespace

Mesh::Mesh(std::shared_ptr<const TriangleMesh> triangles, std::optional<Vec3> inside_vector,
           bool is_mesh2)
    : m_triangles(std::move(triangles)), m_is_mesh2(is_mesh2) {
  if (inside_vector && length_squared(*inside_vector) > 0.0)
    m_inside_vector = normalized(*inside_vector);
}

/// Where triangles are missing points beyond the box may count as inside, too.
ShapeTraits Mesh::traits() const {
  const bool is_solid = m_inside_vector.has_value();
  return {.name = m_is_mesh2 ? "mesh2" : "mesh",
          .is_solid = is_solid,
          .solid_is_unbounded = is_solid && m_triangles->data().is_open,
          .has_uv = true};
}

void Mesh::set_textures(std::vector<const Texture*> textures) { m_textures = std::move(textures); }

int Mesh::textures_at(const ShapeHit& hit, MeshTexture out[3]) const {
  const MeshTriple index = m_triangles->data().face_textures[hit.element];
  const auto texture = [&](std::uint32_t i) {
    return i < m_textures.size() ? m_textures[i] : nullptr;
  };
  if (index[0] == index[1] && index[0] == index[2]) {
    out[0] = {texture(index[0]), 1.0};
    return 1;
  }
  out[0] = {texture(index[0]), 1.0 - hit.u - hit.v};
  out[1] = {texture(index[1]), hit.u};
  out[2] = {texture(index[2]), hit.v};
  return 3;
}

Bounds Mesh::box_in(const Transform& t) const {
  Bounds b;
  const MeshData& data = m_triangles->data();
  for (const MeshTriple& f : data.faces) {
    for (const std::uint32_t v : f) b.include(t.point(data.vertices[v]));
  }
  return padded(b);
}

/// About the box's centre; of large meshes about the box: they look into it themselves.
Ball Mesh::ball() const {
  const MeshData& data = m_triangles->data();
  const Bounds box = bounds();
  if (!box.is_finite() || data.faces.size() > kLargestBaked) return Ball::around(box);
  double farthest2 = 0.0;
  for (const MeshTriple& f : data.faces) {
    for (const std::uint32_t v : f) {
      farthest2 = std::max(farthest2, length_squared(data.vertices[v] - box.centre()));
    }
  }
  return {box.centre(), std::sqrt(farthest2)};
}

bool Mesh::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  TriangleMesh::FaceHit found;
  if (!m_triangles->nearest(ray, t_min, t_max, found)) return false;
  hit = {found.t, found.face, found.wb, found.wc};
  return true;
}

void Mesh::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  m_triangles->all(ray, t_min, t_max, [&](const TriangleMesh::FaceHit& found) {
    hits.push_back({found.t, found.face, found.wb, found.wc});
  });
}

bool Mesh::any(const Ray& ray, double t_min, double t_max) const {
  return m_triangles->any(ray, t_min, t_max);
}

bool Mesh::within(const Vec3& p) const {
  return (m_triangles->data().is_open || bounds().contains(p)) &&
         m_triangles->odd_crossings({p, *m_inside_vector}, kSelf);
}

Vec3 Mesh::normal(const Vec3&, const ShapeHit& hit) const {
  const MeshData& data = m_triangles->data();
  const MeshTriple n = data.face_normals[hit.element];
  if (n[0] != kNoIndex && n[1] != kNoIndex && n[2] != kNoIndex) {
    return data.normals[n[0]] * (1.0 - hit.u - hit.v) + data.normals[n[1]] * hit.u +
           data.normals[n[2]] * hit.v;
  }
  const MeshTriple& f = data.faces[hit.element];
  const Vec3 &a = data.vertices[f[0]], &b = data.vertices[f[1]], &c = data.vertices[f[2]];
  return m_mirrored ? cross(b - a, c - a) : cross(c - a, b - a);
}

Vec2 Mesh::uv(const Vec3&, const ShapeHit& hit) const {
  const MeshData& data = m_triangles->data();
  const MeshTriple index = data.face_uvs[hit.element];
  if (index[0] == kNoIndex || index[1] == kNoIndex || index[2] == kNoIndex)
    return {};  // a face without uv vectors
  const Vec2 &a = data.uvs[index[0]], &b = data.uvs[index[1]], &c = data.uvs[index[2]];
  const double w = 1.0 - hit.u - hit.v;
  return {a.u * w + b.u * hit.u + c.u * hit.v, a.v * w + b.v * hit.u + c.v * hit.v};
}

std::unique_ptr<Shape> Mesh::baked(const Transform& t) const {
  if (m_triangles.use_count() > 1 || m_triangles->data().faces.size() > kLargestBaked)
    return nullptr;
  MeshData data = m_triangles->data();
  for (Vec3& p : data.vertices) p = t.point(p);
  for (Vec3& n : data.normals) n = t.normal(n);  // not unit any more: blending is linear
  std::optional<Vec3> inside_vector;
  if (m_inside_vector) inside_vector = t.vector(*m_inside_vector);
  auto moved = std::make_unique<Mesh>(std::make_shared<const TriangleMesh>(std::move(data)),
                                      inside_vector, m_is_mesh2);
  moved->m_textures = m_textures;
  const bool mirror =
      dot(cross(t.vector({1, 0, 0}), t.vector({0, 1, 0})), t.vector({0, 0, 1})) < 0.0;
  moved->m_mirrored = m_mirrored != mirror;
  return moved;
}

}  // namespace lentray::core
