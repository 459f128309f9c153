// What a mesh is made of: points and the faces between them. Space: object.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/vec3.h"

namespace lentray::core {

inline constexpr std::uint32_t kNoIndex = 0xffffffffu;

/// Indices into some list, one for each corner of a face; kNoIndex: it has none there.
using MeshTriple = std::array<std::uint32_t, 3>;

/// A triple a face, of what most meshes have for no face: nothing is kept then.
struct MeshTriples {
  std::vector<MeshTriple> list;  ///< of the first faces; those behind have none

  bool empty() const { return list.empty(); }
  MeshTriple operator[](std::size_t face) const {
    return face < list.size() ? list[face] : MeshTriple{kNoIndex, kNoIndex, kNoIndex};
  }
  void set(std::size_t face, const MeshTriple& triple) {
    if (face >= list.size()) {
      if (triple == MeshTriple{kNoIndex, kNoIndex, kNoIndex}) return;
      list.resize(face + 1, {kNoIndex, kNoIndex, kNoIndex});
    }
    list[face] = triple;
  }
};

/// Indices are into these lists (textures: into the Mesh's own list).
struct MeshData {
  std::vector<Vec3> vertices;
  std::vector<Vec3> normals;  ///< unit
  std::vector<Vec2> uvs;
  std::vector<MeshTriple> faces;  ///< their corners: vertices
  MeshTriples face_normals, face_uvs;
  /// mesh: all three alike; mesh2 may give one a corner, blended over the face.
  MeshTriples face_textures;
  bool is_open =
      false;  ///< some edge has an odd number of faces; told where there is an inside_vector
};

}  // namespace lentray::core
