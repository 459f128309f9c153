#include "core/geometry/triangle_mesh.h"

#include <stdexcept>

#include "core/geometry/bounds_help.h"

namespace lentray::core {
namespace {

void check(const std::array<std::uint32_t, 3>& index, std::size_t size, bool optional) {
  for (const std::uint32_t i : index) {
    if (i >= size && !(optional && i == kNone)) throw std::out_of_range("mesh index beyond its list");
  }
}

/// Even-odd test of the ray against the triangle seen along it. Shared edges give the same bits
/// to both neighbours, so that a crossing at an edge counts once.
bool covers(const double x[3], const double y[3]) {
  bool odd = false;
  for (int i = 0; i < 3; ++i) {
    int a = i, b = (i + 1) % 3;
    if ((y[a] >= 0.0) == (y[b] >= 0.0)) continue;
    if (y[a] > y[b]) std::swap(a, b);
    odd ^= -x[b] * (y[b] - y[a]) <= y[b] * (x[a] - x[b]);
  }
  return odd;
}

}  // namespace

TriangleMesh::TriangleMesh(MeshData data) : m_data(std::move(data)) {
  std::vector<MeshFace> faces;
  faces.reserve(m_data.faces.size());
  for (const MeshFace& f : m_data.faces) {
    check(f.vertex, m_data.vertices.size(), false);
    check(f.normal, m_data.normals.size(), true);
    check(f.uv, m_data.uvs.size(), true);
    const auto& v = m_data.vertices;
    if (triangle_is_degenerate(v[f.vertex[0]], v[f.vertex[1]], v[f.vertex[2]])) {
      ++m_dropped;
    } else {
      faces.push_back(f);
    }
  }
  std::vector<Bounds> boxes(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const std::uint32_t v : faces[i].vertex) boxes[i].include(m_data.vertices[v]);
    m_bounds.include(boxes[i]);
  }
  m_bounds = padded(m_bounds);
  WideBvh::Options options;
  options.max_leaf = 4;
  m_bvh = WideBvh(boxes, options);
  m_data.faces.clear();
  m_data.faces.reserve(faces.size());
  for (const std::uint32_t part : m_bvh.order()) m_data.faces.push_back(faces[part]);
}

bool TriangleMesh::nearest(const Ray& ray, double t_min, double t_max, FaceHit& hit) const {
  const ShearedRay sheared(ray);
  bool found = false;
  m_bvh.traverse(ray, t_min, t_max, [&](std::uint32_t first, std::uint32_t count, double& limit) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      FaceHit next;
      if (!meets(sheared, i, next) || !(next.t > t_min) || !(next.t <= limit)) continue;
      if (next.t == limit && !(found && i < hit.face)) continue;
      hit = next;
      limit = next.t;
      found = true;
    }
    return false;
  });
  return found;
}

bool TriangleMesh::any(const Ray& ray, double t_min, double t_max) const {
  const ShearedRay sheared(ray);
  return m_bvh.traverse(ray, t_min, t_max, [&](std::uint32_t first, std::uint32_t count, double&) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      FaceHit next;
      if (meets(sheared, i, next) && next.t > t_min && next.t < t_max) return true;
    }
    return false;
  });
}

bool TriangleMesh::odd_crossings(const Ray& ray, double t_min) const {
  const ShearedRay s(ray);
  bool odd = false;
  m_bvh.traverse(ray, t_min, Bounds::kInf, [&](std::uint32_t first, std::uint32_t count, double&) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      double x[3], y[3], z[3];
      for (int k = 0; k < 3; ++k) {
        const Vec3 p = m_data.vertices[m_data.faces[i].vertex[static_cast<std::size_t>(k)]] - s.origin;
        z[k] = p[s.kz];
        x[k] = p[s.kx] - s.sx * z[k];
        y[k] = p[s.ky] - s.sy * z[k];
      }
      if (!covers(x, y)) continue;
      const double u = x[2] * y[1] - y[2] * x[1], v = x[0] * y[2] - y[0] * x[2];
      const double w = x[1] * y[0] - y[1] * x[0], det = (u + v) + w;
      if (det != 0.0 && ((u * z[0] + v * z[1]) + w * z[2]) * s.sz / det > t_min) odd = !odd;
    }
    return false;
  });
  return odd;
}

std::size_t TriangleMesh::memory() const {
  return sizeof(*this) + m_data.vertices.capacity() * sizeof(Vec3) +
         m_data.normals.capacity() * sizeof(Vec3) + m_data.uvs.capacity() * sizeof(Vec2) +
         m_data.faces.capacity() * sizeof(MeshFace) + m_bvh.memory();
}

}  // namespace lentray::core
