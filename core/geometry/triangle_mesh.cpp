#include "core/geometry/triangle_mesh.h"

#include <bit>
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
  std::vector<MeshFace> faces = std::move(m_data.faces);
  std::size_t kept = 0;
  for (const MeshFace& f : faces) {
    check(f.vertex, m_data.vertices.size(), false);
    check(f.normal, m_data.normals.size(), true);
    check(f.uv, m_data.uvs.size(), true);
    const auto& v = m_data.vertices;
    if (triangle_is_degenerate(v[f.vertex[0]], v[f.vertex[1]], v[f.vertex[2]])) {
      ++m_dropped;
    } else {
      faces[kept++] = f;
    }
  }
  faces.resize(kept);
  std::vector<Bounds> boxes(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const std::uint32_t v : faces[i].vertex) boxes[i].include(m_data.vertices[v]);
    m_bounds.include(boxes[i]);
  }
  m_bounds = padded(m_bounds);
  WideBvh::Options options;
  options.pack = options.max_leaf = kPack;
  m_bvh = WideBvh(boxes, options);
  boxes = {};  // their memory serves what is made next
  m_data.faces.clear();
  m_data.faces.reserve(faces.size());
  for (const std::uint32_t part : m_bvh.order()) m_data.faces.push_back(faces[part]);
  faces = {};
  fill_packs();
}

void TriangleMesh::fill_packs() {
  m_packs.reserve(m_bvh.statistics().leaves);
  m_leaves.reserve(m_bvh.statistics().leaves);
  m_bvh.relabel([&](std::uint32_t first, std::uint32_t count) {
    TrianglePack& pack = m_packs.emplace_back();
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      for (int corner = 0; corner < 3; ++corner) {
        const auto& vertex = m_data.faces[first + lane].vertex;
        const Vec3& p = m_data.vertices[vertex[static_cast<std::size_t>(corner)]];
        for (int axis = 0; axis < 3; ++axis) pack.corner[corner][axis][lane] = p[axis];
      }
    }
    m_leaves.push_back({first, count});
    return static_cast<std::uint32_t>(m_leaves.size() - 1);
  });
}

/// What is sought, and the best so far.
template <bool kAny>
struct TriangleMesh::Search {
  double t_min, t_max;
  FaceHit best;

  /// Whether the search is over.
  bool lanes(unsigned mask, const PackHits& hits, std::uint32_t first) {
    for (; mask != 0; mask &= mask - 1) {
      const int i = std::countr_zero(mask);
      const std::uint32_t face = first + static_cast<std::uint32_t>(i);
      const double t = hits.t[i];
      if (!(t < t_max || (best.face != kNone && t == t_max && face < best.face))) continue;
      best = {t, hits.u[i], hits.v[i], face};
      if (kAny) return true;
      t_max = t;
    }
    return false;
  }
};

// The same text twice, because a function does not take its caller's instruction set.
template <bool kAny>
struct TriangleMesh::PackLeaf {
  const TriangleMesh& mesh;
  Search<kAny>& what;
  const PackRay& ray;
  bool operator()(std::uint32_t code, double& t_max) {
    PackHits hits;
    const unsigned mask = intersect_portable(mesh.m_packs[code], ray, what.t_min, t_max, hits);
    const bool end = mask != 0 && what.lanes(mask, hits, mesh.m_leaves[code].first);
    t_max = what.t_max;
    return end;
  }
};

template <bool kAny>
struct TriangleMesh::PackLeafAvx2 {
  const TriangleMesh& mesh;
  Search<kAny>& what;
  const PackRay& ray;
  LENTRAY_AVX2 bool operator()(std::uint32_t code, double& t_max) {
    PackHits hits;
    const unsigned mask = intersect_avx2(mesh.m_packs[code], ray, what.t_min, t_max, hits);
    const bool end = mask != 0 && what.lanes(mask, hits, mesh.m_leaves[code].first);
    t_max = what.t_max;
    return end;
  }
};

template <bool kAny>
bool TriangleMesh::search(const Ray& ray, double t_min, double t_max, FaceHit& hit) const {
  if (m_bvh.empty()) return false;
  const PackRay pack_ray(ray, true);
  Search<kAny> what{t_min, t_max, {}};
  CountNothing nothing;
  if (has_avx2()) {
    PackLeafAvx2<kAny> leaf{*this, what, pack_ray};
    m_bvh.traverse_avx2<!kAny>(ray, t_min, t_max, leaf, nothing);
  } else {
    PackLeaf<kAny> leaf{*this, what, pack_ray};
    m_bvh.traverse_portable(ray, t_min, t_max, leaf, nothing);
  }
  hit = what.best;
  return hit.face != kNone;
}

bool TriangleMesh::nearest(const Ray& ray, double t_min, double t_max, FaceHit& hit) const {
  return search<false>(ray, t_min, t_max, hit);
}

bool TriangleMesh::any(const Ray& ray, double t_min, double t_max) const {
  FaceHit hit;
  return search<true>(ray, t_min, t_max, hit);
}

bool TriangleMesh::odd_crossings(const Ray& ray, double t_min) const {
  const ShearedRay s(ray);
  bool odd = false;
  for_faces_near(ray, t_min, Bounds::kInf, [&](std::uint32_t face) {
    double x[3], y[3], z[3];
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = m_data.vertices[m_data.faces[face].vertex[static_cast<std::size_t>(k)]] - s.origin;
      z[k] = p[s.kz];
      x[k] = p[s.kx] - s.sx * z[k];
      y[k] = p[s.ky] - s.sy * z[k];
    }
    if (!covers(x, y)) return;
    const double u = x[2] * y[1] - y[2] * x[1], v = x[0] * y[2] - y[0] * x[2];
    const double w = x[1] * y[0] - y[1] * x[0], det = (u + v) + w;
    if (det != 0.0 && ((u * z[0] + v * z[1]) + w * z[2]) * s.sz / det > t_min) odd = !odd;
  });
  return odd;
}

std::size_t TriangleMesh::memory() const {
  return sizeof(*this) + m_data.vertices.capacity() * sizeof(Vec3) +
         m_data.normals.capacity() * sizeof(Vec3) + m_data.uvs.capacity() * sizeof(Vec2) +
         m_data.faces.capacity() * sizeof(MeshFace) +
         m_packs.capacity() * sizeof(TrianglePack) + m_leaves.capacity() * sizeof(LeafFaces) +
         m_bvh.memory();
}

}  // namespace lentray::core
