// mesh {} and mesh2 {}: triangles with optional normals, uv vectors and textures a face.
// Space: object, or world once baked. A surface without solid unless inside_vector is given.
// Source: reference manual 3.7, "Mesh", "Mesh2".
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/shape/shape.h"
#include "core/shape/triangle_mesh.h"

namespace lentray::core {

class Texture;

/// A texture's share of a point of a mesh; null stands for the mesh's own texture.
struct MeshTexture {
  const Texture* texture = nullptr;
  double weight = 1.0;
};

class Mesh final : public Shape {
 public:
  /// Placed copies of one mesh share `triangles`. `is_mesh2` is for the name alone.
  /// inside_vector: parity of crossings along it decides inside; null vector or none: no solid.
  Mesh(std::shared_ptr<const TriangleMesh> triangles, std::optional<Vec3> inside_vector,
       bool is_mesh2);

  /// The textures that MeshData::face_textures counts in; borrowed, owned by the scene. Call before
  /// the mesh is given to a Leaf.
  void set_textures(std::vector<const Texture*> textures);
  const std::vector<const Texture*>& textures() const { return m_textures; }
  bool has_textures() const { return !m_textures.empty(); }
  /// The textures at a hit: one, or up to three that blend. Returns how many.
  int textures_at(const ShapeHit& hit, MeshTexture out[3]) const;

  const TriangleMesh& triangles() const { return *m_triangles; }

  ShapeTraits traits() const override;
  Bounds box(const Transform* move) const override {
    return move ? box_in(*move) : m_triangles->bounds();
  }
  Ball ball() const override;
  /// ShapeHit::element is the face, u and v the weights of its corners b and c.
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool any(const Ray& ray, double t_min, double t_max) const override;
  bool holds(const Vec3& p, bool inverse) const override {
    return m_inside_vector && within(p) != inverse;
  }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  Vec2 uv(const Vec3& p, const ShapeHit& hit) const override;
  /// Small ones whose triangles are not shared; else the object keeps the transform.
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  bool within(const Vec3& p) const;
  Bounds box_in(const Transform& t) const;
  std::shared_ptr<const TriangleMesh> m_triangles;
  std::optional<Vec3> m_inside_vector;  ///< unit
  std::vector<const Texture*> m_textures;
  bool m_is_mesh2;
  bool m_mirrored = false;  ///< baked through a mirror: the corners' order is the other way round
};

}  // namespace lentray::core
