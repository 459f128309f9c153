// polygon { n, points }: flat, any number of contours, concave and with holes, even-odd.
// A contour ends where its first point comes again; the last may be left open.
// Space: object, or world once baked. Source: reference manual 3.7, "Polygon".
#pragma once

#include <vector>

#include "core/geometry/shape.h"

namespace lentray::core {

/// Even-odd test in the plane with the rule: an edge counts if one end has v >= the point's and
/// the other has not, and the edge is at or right of the point. Edges sorted into bands of v.
class EvenOdd {
 public:
  struct Edge {
    double u0, v0, u1, v1;  ///< v0 < v1
  };
  explicit EvenOdd(std::vector<Edge> edges);
  bool contains(double u, double v) const;
  std::size_t memory() const;

 private:
  static bool crosses(const Edge& e, double u, double v);
  double m_lo_u, m_hi_u, m_lo_v, m_hi_v, m_scale;
  std::vector<std::uint32_t> m_first;  ///< of each band, in m_edges; one more at the end
  std::vector<Edge> m_edges;           ///< by band; an edge occurs in every band it touches
};

class Polygon final : public Shape {
 public:
  /// Points as SDL lists them. An unclosed last contour is closed. A degenerate polygon (fewer
  /// than three points, in a line, or out of its plane by 1e-10) is allowed: nothing meets it.
  explicit Polygon(std::vector<Vec3> points);

  const std::vector<Vec3>& points() const { return m_points; }
  bool is_degenerate() const { return m_degenerate; }

  std::string_view name() const override { return "polygon"; }
  Bounds bounds() const override;
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool inside(const Vec3&) const override { return false; }
  bool outside(const Vec3&) const override { return false; }
  bool is_solid() const override { return false; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  std::unique_ptr<Shape> baked(const Transform& t) const override;
  std::size_t memory() const override;

 private:
  Polygon(std::vector<Vec3> points, bool degenerate, const Vec3& normal);
  void build(bool check_flatness);

  std::vector<Vec3> m_points;
  Vec3 m_normal;             ///< unit, as stock orients it
  double m_offset = 0.0;     ///< of the plane, along the normal
  int m_u = 0, m_v = 1;      ///< the axes of the projection that the 2D test works in
  bool m_degenerate = false;
  std::vector<EvenOdd> m_test;  ///< one, none if degenerate
};

}  // namespace lentray::core
