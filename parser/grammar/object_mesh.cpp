// mesh and mesh2. Source: reference manual 3.7, "Mesh", "Mesh2".
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <unordered_map>
#include <utility>

#include "parser/grammar/helpers.h"
#include "parser/grammar/object_shapes.h"
#include "parser/values/arithmetic.h"

namespace lentray::parser {
namespace {

constexpr core::MeshTriple kNoTriple{core::kNoIndex, core::kNoIndex, core::kNoIndex};

std::uint64_t bits_of(double x) {
  if (x == 0.0) x = 0.0;  // -0 is 0
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

/// Items with one key are one.
std::array<std::uint64_t, 3> key_of(const Vec3& p) {
  return {bits_of(p.x), bits_of(p.y), bits_of(p.z)};
}
const TextureDesc* key_of(const Ref<TextureDesc>& texture) { return texture.get(); }

struct KeyHash {
  std::size_t operator()(const TextureDesc* texture) const {
    return std::hash<const TextureDesc*>()(texture);
  }
  std::size_t operator()(const std::array<std::uint64_t, 3>& bits) const {
    std::uint64_t h = 0x9e3779b97f4a7c15u;
    for (const std::uint64_t b : bits) h = (h ^ b) * 0xff51afd7ed558ccdu ^ (h >> 29);
    return h;
  }
};

/// Gives equal items of a mesh one index.
template <typename Item>
class Pool {
 public:
  explicit Pool(std::vector<Item>& items) : m_items(items) {}
  std::uint32_t index(const Item& item) {
    const auto [it, fresh] =
        m_index.try_emplace(key_of(item), static_cast<std::uint32_t>(m_items.size()));
    if (fresh) m_items.push_back(item);
    return it->second;
  }

 private:
  std::vector<Item>& m_items;
  std::unordered_map<decltype(key_of(std::declval<Item>())), std::uint32_t, KeyHash> m_index;
};

/// Reads normals. Those of no length become <1, 0, 0>, as in stock, with one warning a mesh.
class NormalReader {
 public:
  Vec3 read(Parser& parser) {
    constexpr double kNothing = 1e-10;
    const Location where = parser.location();
    const Vec3 normal = parser.parse_vector();
    const bool is_null = std::fabs(normal.x) < kNothing && std::fabs(normal.y) < kNothing &&
                         std::fabs(normal.z) < kNothing;
    if (!is_null) return normal;
    if (m_null++ == 0) m_first = where;
    return {1.0, 0.0, 0.0};
  }
  void report(Parser& parser) const {
    if (m_null == 0) return;
    const std::string which =
        m_null == 1 ? "a normal of a mesh has no length"
                    : std::to_string(m_null) + " normals of a mesh have no length, the first here";
    parser.warn_at(m_first, which + ": <1, 0, 0> instead");
  }

 private:
  std::size_t m_null = 0;
  Location m_first;
};

/// What is under construction while a `mesh` is read.
struct MeshReader {
  MeshShape mesh;
  NormalReader normal_reader;
  Pool<Vec3> vertices{mesh.vertices}, normals{mesh.normals};
  Pool<Ref<TextureDesc>> textures{mesh.textures};

  void parse_face(Parser& parser, Context& context, bool smooth) {
    parser.expect(Punct::kLeftCurly);
    core::MeshTriple corners, corner_normals = kNoTriple, corner_uvs = kNoTriple,
                              corner_textures = kNoTriple;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = vertices.index(parser.parse_vector());
      parser.parse_comma();
      if (!smooth) continue;
      corner_normals[i] = normals.index(normal_reader.read(parser));
      parser.parse_comma();
    }
    if (parser.accept(Keyword::kUvVectors)) {
      for (std::uint32_t& uv : corner_uvs) {
        uv = static_cast<std::uint32_t>(mesh.uvs.size());
        mesh.uvs.push_back(parse_uv(parser));
        parser.parse_comma();
      }
    }
    Ref<TextureDesc> texture;  // the last one alone counts, as in stock
    while (parser.accept(Keyword::kTexture)) texture = parse_texture(parser, context.materials);
    if (texture) corner_textures.fill(textures.index(texture));
    if (parser.accept(Keyword::kTextureList)) corner_textures = parse_corner_textures(parser);
    end_block(parser, "one of uv_vectors, texture, texture_list");
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
      return;  // degenerate: stock leaves it out
    }
    const std::size_t face = mesh.faces.size();
    mesh.faces.push_back(corners);
    mesh.face_normals.set(face, corner_normals);
    mesh.face_uvs.set(face, corner_uvs);
    mesh.face_textures.set(face, corner_textures);
  }

 private:
  core::MeshTriple parse_corner_textures(Parser& parser) {
    core::MeshTriple list;
    parser.expect(Punct::kLeftCurly);
    for (std::uint32_t& texture : list) {
      const auto named = parser.accept_value<Ref<TextureDesc>>();
      if (!named) parser.fail_expected("three texture identifiers, one for each corner");
      texture = textures.index(*named);
      parser.parse_comma();
    }
    parser.expect(Punct::kRightCurly);
    return list;
  }
};

void check_index(Parser& parser, int index, std::size_t size, const char* what) {
  if (index < 0 || static_cast<std::size_t>(index) >= size) {
    parser.fail(std::string(what) + " index " + std::to_string(index) +
                " is out of range: there are " + std::to_string(size) + ".");
  }
}

/// `{ count, items }` into a list.
template <typename List, typename Read>
void parse_list(Parser& parser, List& list, Read read) {
  constexpr int kMostReserved = 1 << 20;  // the number is only what the scene says
  parser.expect(Punct::kLeftCurly);
  const int count = parser.parse_int();
  parser.parse_comma();
  list.reserve(static_cast<std::size_t>(std::clamp(count, 0, kMostReserved)));
  for (int i = 0; i < count; ++i) {
    list.push_back(read());
    parser.parse_comma();
  }
  parser.expect(Punct::kRightCurly);
}

std::array<int, 3> parse_triple(Parser& parser) {
  const Vec3 v = parser.parse_vector();
  return {to_int(v.x), to_int(v.y), to_int(v.z)};
}

core::MeshTriple checked(Parser& parser, const std::array<int, 3>& triple, std::size_t size,
                         const char* what) {
  for (const int i : triple) check_index(parser, i, size, what);
  return {static_cast<std::uint32_t>(triple[0]), static_cast<std::uint32_t>(triple[1]),
          static_cast<std::uint32_t>(triple[2])};
}

/// A face of mesh2: three vertices and up to three textures.
core::MeshTriple parse_indexed_face(Parser& parser, MeshShape& mesh) {
  const core::MeshTriple corners =
      checked(parser, parse_triple(parser), mesh.vertices.size(), "Mesh vertex");
  parser.parse_comma();
  core::MeshTriple textures = kNoTriple;
  std::size_t count = 0;
  while (count < 3 && at_float(parser)) {
    const int t = parser.parse_int();
    check_index(parser, t, mesh.textures.size(), "Mesh texture");
    textures[count++] = static_cast<std::uint32_t>(t);
    parser.parse_comma();
  }
  for (std::size_t i = count; count > 0 && i < 3; ++i) textures[i] = textures[0];
  mesh.face_textures.set(mesh.faces.size(), textures);
  return corners;
}

struct Mesh2Reader {
  MeshShape mesh;
  NormalReader normal_reader;
  std::vector<std::array<int, 3>> normal_indices, uv_indices;
  bool has_normal_indices = false, has_uv_indices = false;

  /// One block of the mesh; false if the next token starts none.
  bool accept_block(Parser& parser, Context& context) {
    if (parser.accept(Keyword::kInsideVector, mesh.inside_vector)) return true;
    if (parser.accept(Keyword::kVertexVectors)) {
      parse_list(parser, mesh.vertices, [&] { return parser.parse_vector(); });
      if (mesh.vertices.empty()) parser.fail("No vertices in triangle mesh.");
    } else if (parser.accept(Keyword::kNormalVectors)) {
      parse_list(parser, mesh.normals, [&] { return normal_reader.read(parser); });
    } else if (parser.accept(Keyword::kUvVectors)) {
      parse_list(parser, mesh.uvs, [&] { return parse_uv(parser); });
    } else if (parser.accept(Keyword::kTextureList)) {
      parse_list(parser, mesh.textures, [&] {
        Ref<TextureDesc> texture;
        if (parser.accept(Keyword::kTexture)) {
          texture = parse_texture(parser, context.materials);
        } else if (auto named = parser.accept_value<Ref<TextureDesc>>()) {
          texture = *named;
        } else {
          parser.fail_expected("texture");
        }
        return texture;
      });
    } else if (parser.accept(Keyword::kFaceIndices)) {
      parse_list(parser, mesh.faces, [&] { return parse_indexed_face(parser, mesh); });
      if (mesh.faces.empty()) parser.fail("No triangles in triangle mesh.");
    } else if (parser.accept(Keyword::kNormalIndices)) {
      has_normal_indices = true;
      parse_list(parser, normal_indices, [&] { return parse_triple(parser); });
    } else if (parser.accept(Keyword::kUvIndices)) {
      has_uv_indices = true;
      parse_list(parser, uv_indices, [&] { return parse_triple(parser); });
    } else {
      return false;
    }
    return true;
  }

  /// Gives the faces their normals and uv coordinates: without own indices those of the vertices.
  void connect(Parser& parser) {
    if (mesh.vertices.empty()) parser.fail_expected("vertex_vectors");
    if (mesh.faces.empty()) parser.fail_expected("face_indices");
    if (!mesh.normals.empty()) {
      mesh.face_normals =
          connected(parser, has_normal_indices, normal_indices, mesh.normals.size(), "Mesh normal");
    }
    if (!mesh.uvs.empty()) {
      mesh.face_uvs = connected(parser, has_uv_indices, uv_indices, mesh.uvs.size(), "Mesh uv");
    }
  }

 private:
  core::MeshTriples connected(Parser& parser, bool has_indices,
                              const std::vector<std::array<int, 3>>& indices, std::size_t size,
                              const char* what) const {
    core::MeshTriples triples;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
      std::array<int, 3> own{-1, -1, -1};
      if (!has_indices) {
        for (std::size_t k = 0; k < 3; ++k) own[k] = static_cast<int>(mesh.faces[i][k]);
      } else if (i < indices.size()) {
        own = indices[i];
      }
      if (own[0] >= 0) triples.set(i, checked(parser, own, size, what));
    }
    return triples;
  }
};

}  // namespace

ShapeDesc parse_mesh(Parser& parser, Context& context) {
  MeshReader reader;
  while (true) {
    if (parser.accept(Keyword::kInsideVector, reader.mesh.inside_vector)) continue;
    if (parser.accept(Keyword::kTriangle)) {
      reader.parse_face(parser, context, false);
    } else if (parser.accept(Keyword::kSmoothTriangle)) {
      reader.parse_face(parser, context, true);
    } else {
      break;
    }
  }
  reader.normal_reader.report(parser);
  if (reader.mesh.faces.empty()) parser.fail_expected("triangle or smooth_triangle");
  return std::make_shared<const MeshShape>(std::move(reader.mesh));
}

ShapeDesc parse_mesh2(Parser& parser, Context& context) {
  Mesh2Reader reader;
  while (reader.accept_block(parser, context)) {
  }
  reader.normal_reader.report(parser);
  reader.connect(parser);
  return std::make_shared<const MeshShape>(std::move(reader.mesh));
}

}  // namespace lentray::parser
