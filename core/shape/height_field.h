// height_field: a grid of heights as pairs of triangles over the unit square of x and z, heights
// 0..1. Below the water level there is nothing. No sides and no floor.
// Space: object, or any that a transform leads to. Grid space: one cell a unit, heights 0..65535.
// Source: reference manual 3.7, "Height Field"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/shape/shape.h"

namespace lentray::core {

/// Heights of the grid's corners, and normals there if it is smooth. Shared by placed copies.
class HeightGrid {
 public:
  /// Row 0 lies at z = 0; at least 2 x 2 heights.
  HeightGrid(int width, int depth, std::vector<std::uint16_t> heights, bool smooth);
  int width() const { return m_width; }
  int depth() const { return m_depth; }
  double height(int x, int z) const { return m_heights[index(x, z)]; }
  /// Where the height is kept: the next along x lies behind it, the next along z width() further.
  const std::uint16_t* corner(int x, int z) const { return &m_heights[index(x, z)]; }
  bool is_smooth() const { return !m_normals.empty(); }
  /// Grid space, of any length; rounded to few digits.
  Vec3 corner_normal(int x, int z) const;
  double lowest() const { return m_lowest; }
  double highest() const { return m_highest; }

  /// Cells come in blocks of kBlock x kBlock; their triangles, and a little beyond these, lie between
  /// low and high above the plane y = along_x * x + along_z * z.
  static constexpr int kBlock = 8;
  struct Slab {
    float along_x, along_z, low, high;
  };
  const Slab& block(int x, int z) const {
    return m_blocks[static_cast<std::size_t>(z) * static_cast<std::size_t>(m_blocks_across) +
                    static_cast<std::size_t>(x)];
  }

 private:
  std::size_t index(int x, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(m_width) +
           static_cast<std::size_t>(x);
  }
  Vec3 mean_normal(int x, int z) const;
  void find_blocks();
  Slab slab(int x, int z) const;

  int m_width, m_depth;
  std::vector<std::uint16_t> m_heights;
  std::vector<std::array<std::int16_t, 3>> m_normals;
  std::vector<Slab> m_blocks;
  int m_blocks_across = 0;
  double m_lowest = 65535.0, m_highest = 0.0;
};

class HeightField final : public Shape {
 public:
  /// `water_level` 0..1.
  HeightField(std::shared_ptr<const HeightGrid> grid, double water_level);

  ShapeTraits traits() const override {
    return {.name = "height_field", .solid_is_unbounded = true};
  }
  Bounds box(const Transform* move) const override { return moved_box(m_reach, move); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool any(const Ray& ray, double t_min, double t_max) const override;
  /// Everything below the surface, beyond the box too.
  bool holds(const Vec3& p, bool inverse) const override { return within(p) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  bool within(const Vec3& p) const;
  Bounds own_box() const;
  /// Calls visit(t, element) for the triangles met, cell by cell along the ray; element: 2 x cell,
  /// + 1 for the upper triangle. Stops where go_on, asked with t of the cell's start, returns false.
  template <class Visit, class GoOn>
  void walk(const Ray& ray, double t_min, double t_max, Visit&& visit, GoOn&& go_on) const;
  template <class Visit>
  void cell(int x, int z, const std::uint16_t* corner, const Ray& ray, double y_from, double y_to,
            Visit&& visit) const;
  Vec3 flat_normal(std::uint32_t element) const;

  std::shared_ptr<const HeightGrid> m_grid;
  Bounds m_box;          ///< grid space
  Transform m_to_space;  ///< from grid space
  Bounds m_reach;        ///< own_box(), which may look at every point of the grid
};

}  // namespace lentray::core
