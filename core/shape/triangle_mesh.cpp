#include "core/shape/triangle_mesh.h"

#include <bit>
#include <stdexcept>

#include "core/numeric/bounds_help.h"

namespace lentray::core {
namespace {

void check(const std::vector<MeshTriple>& triples, std::size_t size, bool optional) {
  for (const MeshTriple& triple : triples) {
    for (const std::uint32_t i : triple) {
      if (i >= size && !(optional && i == kNoIndex))
        throw std::out_of_range("mesh index beyond its list");
    }
  }
}

MeshTriples in_order(const MeshTriples& triples, const std::vector<std::uint32_t>& order) {
  MeshTriples out;
  if (triples.empty()) return out;
  out.list.reserve(order.size());
  for (const std::uint32_t face : order) out.list.push_back(triples[face]);
  return out;
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
  check(m_data.faces, m_data.vertices.size(), false);
  check(m_data.face_normals.list, m_data.normals.size(), true);
  check(m_data.face_uvs.list, m_data.uvs.size(), true);
  std::vector<Bounds> boxes(m_data.faces.size());  // degenerate faces have none and are left out
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const MeshTriple& f = m_data.faces[i];
    const Vec3 &a = m_data.vertices[f[0]], &b = m_data.vertices[f[1]], &c = m_data.vertices[f[2]];
    if (triangle_is_degenerate(a, b, c)) continue;
    boxes[i].include(a);
    boxes[i].include(b);
    boxes[i].include(c);
    m_bounds.include(boxes[i]);
  }
  m_bounds = padded(m_bounds);
  WideBvh::Options options;
  options.pack = options.max_leaf = kPack;
  m_bvh = WideBvh(std::move(boxes), options);
  const std::vector<std::uint32_t>& order = m_bvh.order();
  m_dropped = m_data.faces.size() - order.size();
  std::vector<MeshTriple> faces;
  faces.reserve(order.size());
  for (const std::uint32_t face : order) faces.push_back(m_data.faces[face]);
  m_data.faces = std::move(faces);
  for (MeshTriples* list : {&m_data.face_normals, &m_data.face_uvs, &m_data.face_textures}) {
    *list = in_order(*list, order);
  }
  m_bvh.drop_order();
  fill_packs();
}

void TriangleMesh::fill_packs() {
  m_packs.reserve(m_bvh.statistics().leaves);
  m_bvh.relabel([&](std::uint32_t first, std::uint32_t count) {
    TrianglePack& pack = m_packs.emplace_back();
    pack.first = first;
    pack.count = count;
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      const MeshTriple& f = m_data.faces[first + lane];
      pack.set(static_cast<int>(lane), m_data.vertices[f[0]], m_data.vertices[f[1]],
               m_data.vertices[f[2]]);
    }
    return static_cast<std::uint32_t>(m_packs.size() - 1);
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
      if (!(t < t_max || (best.face != kNoIndex && t == t_max && face < best.face))) continue;
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
    const bool end = mask != 0 && what.lanes(mask, hits, mesh.m_packs[code].first);
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
    const bool end = mask != 0 && what.lanes(mask, hits, mesh.m_packs[code].first);
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
  return hit.face != kNoIndex;
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
      const Vec3 p = m_data.vertices[m_data.faces[face][static_cast<std::size_t>(k)]] - s.origin;
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

}  // namespace lentray::core
