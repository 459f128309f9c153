// The triangles that mesh and mesh2 hold, and a bounding hierarchy over them. Built once, then
// shared const (by several placed copies too, and by threads). Space: object.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/bounds.h"
#include "core/geometry/triangle_test.h"

namespace lentray::core {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// A face: corners, and for each corner its normal, uv vector and texture, kNone if it has none.
struct MeshFace {
  std::array<std::uint32_t, 3> vertex{};
  std::array<std::uint32_t, 3> normal{kNone, kNone, kNone};
  std::array<std::uint32_t, 3> uv{kNone, kNone, kNone};
  /// mesh: all three alike; mesh2 may give one a corner, blended over the face.
  std::array<std::uint32_t, 3> texture{kNone, kNone, kNone};
};

/// What the parser fills; indices are into these lists.
struct MeshData {
  std::vector<Vec3> vertices;
  std::vector<Vec3> normals;   ///< need not be unit
  std::vector<Vec2> uvs;
  std::vector<MeshFace> faces;
};

class TriangleMesh {
 public:
  /// Drops degenerate faces. Throws std::out_of_range if an index is beyond its list.
  explicit TriangleMesh(MeshData data);

  struct FaceHit {
    double t = 0.0, wb = 0.0, wc = 0.0;
    std::uint32_t face = kNone;
  };
  bool nearest(const Ray& ray, double t_min, double t_max, FaceHit& hit) const;
  bool any(const Ray& ray, double t_min, double t_max) const;
  /// Calls `visit(const FaceHit&)` for every face that the ray meets, in any order.
  template <class Visit>
  void all(const Ray& ray, double t_min, double t_max, Visit&& visit) const;

  const MeshData& data() const { return m_data; }
  std::size_t dropped() const { return m_dropped; }  ///< degenerate faces left out
  const Bounds& bounds() const { return m_bounds; }
  std::size_t memory() const;

 private:
  static constexpr int kWidth = 4;
  /// Boxes of up to four children, floats rounded outwards. child >= 0: inner node; child < 0:
  /// leaf, faces from ~child on, `count` of them (0: no child).
  struct alignas(64) Node {
    float lo[3][kWidth], hi[3][kWidth];
    std::int32_t child[kWidth];
    std::uint32_t count[kWidth];
  };
  struct Builder;
  struct NodeRay;
  template <class Leaf>
  void traverse(const Ray& ray, double t_min, double t_max, Leaf&& leaf) const;
  static int hit_boxes(const Node& node, const NodeRay& ray, double t_min, double t_max,
                       double entry[kWidth]);
  void test_faces(const ShearedRay& ray, std::uint32_t first, std::uint32_t count, double t_min,
                  double& t_max, FaceHit& hit) const;

  MeshData m_data;                     ///< faces in the hierarchy's order
  std::vector<Node> m_nodes;
  Bounds m_bounds;
  std::size_t m_dropped = 0;
};

}  // namespace lentray::core
