// The triangles that mesh and mesh2 hold, and a bounding hierarchy over them. Built once, then
// shared const (by several placed copies too, and by threads). Space: object.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/bounds.h"
#include "core/bvh/wide_bvh.h"
#include "core/numeric/triangle_test.h"
#include "core/shape/mesh_data.h"
#include "core/shape/packs.h"

namespace lentray::core {

class TriangleMesh {
 public:
  /// Drops degenerate faces and reorders the rest. Throws std::out_of_range if an index is
  /// beyond its list.
  explicit TriangleMesh(MeshData data);

  struct FaceHit {
    double t = 0.0, wb = 0.0, wc = 0.0;
    std::uint32_t face = kNoIndex;
  };
  /// Of hits at equal t the one on the face first in order.
  bool nearest(const Ray& ray, double t_min, double t_max, FaceHit& hit) const;
  bool any(const Ray& ray, double t_min, double t_max) const;
  /// Calls `visit(const FaceHit&)` for every face that the ray meets, in any order.
  template <class Visit>
  void all(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
    const ShearedRay sheared(ray);
    for_faces_near(ray, t_min, t_max, [&](std::uint32_t face) {
      FaceHit hit;
      if (meets(sheared, face, hit) && hit.t > t_min && hit.t < t_max) visit(hit);
    });
  }
  /// Whether the ray crosses the surface an odd number of times beyond t_min. Edges and corners
  /// count once, so that the answer is right there too.
  bool odd_crossings(const Ray& ray, double t_min) const;

  const MeshData& data() const { return m_data; }
  std::size_t dropped() const { return m_dropped; }  ///< degenerate faces left out
  const Bounds& bounds() const { return m_bounds; }

 private:
  template <class Visit>
  void for_faces_near(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
    const auto leaf = [&](std::uint32_t code, double&) {
      const TrianglePack& pack = m_packs[code];
      for (std::uint32_t i = 0; i < pack.count; ++i) visit(pack.first + i);
      return false;
    };
    CountNothing nothing;
    if (has_avx2()) {
      m_bvh.traverse_avx2<false>(ray, t_min, t_max, leaf, nothing);
    } else {
      m_bvh.traverse_portable(ray, t_min, t_max, leaf, nothing);
    }
  }
  bool meets(const ShearedRay& ray, std::uint32_t face, FaceHit& hit) const {
    const MeshTriple& v = m_data.faces[face];
    TriangleHit found;
    if (!intersect_triangle(ray, m_data.vertices[v[0]], m_data.vertices[v[1]],
                            m_data.vertices[v[2]], found))
      return false;
    hit = {found.t, found.wb, found.wc, face};
    return true;
  }

  template <bool kAny>
  struct Search;
  template <bool kAny>
  struct PackLeaf;
  template <bool kAny>
  struct PackLeafAvx2;
  template <bool kAny>
  bool search(const Ray& ray, double t_min, double t_max, FaceHit& hit) const;
  void fill_packs();

  MeshData m_data;  ///< faces in the hierarchy's order
  WideBvh m_bvh;
  std::vector<TrianglePack> m_packs;  ///< one a leaf; the hierarchy's leaf codes count them
  Bounds m_bounds;
  std::size_t m_dropped = 0;
};

}  // namespace lentray::core
