// polygon { n, points }: flat, any number of contours, concave and with holes, even-odd.
// A contour ends where its first point comes again; the last may be left open.
// Space: object, or world once baked. Source: reference manual 3.7, "Polygon".
#pragma once

#include <array>
#include <vector>

#include "core/shape/crossings.h"

namespace lentray::core {

/// Even-odd test in the plane. An edge counts if one end has v >= the point's and
/// the other has not, and the edge is at or right of the point. Edges are sorted into bands of v.
class EvenOdd {
 public:
  struct Edge {
    double u0, v0, u1, v1;  ///< v0 < v1, so that both neighbours of an edge compute the same bits
  };
  EvenOdd() = default;
  explicit EvenOdd(std::vector<Edge> edges);
  bool contains(double u, double v) const;

  static bool crosses(const Edge& e, double u, double v) {
    const bool spans = (e.v0 >= v) != (e.v1 >= v);  // both computed: cheaper than a wrong guess
    const bool right = (u - e.u1) * (e.v1 - e.v0) <= (e.v1 - v) * (e.u0 - e.u1);
    return spans & right;
  }

 private:
  int band(double v) const;

  double m_lo_v = 0.0, m_per_band = 0.0;
  int m_bands = 0;
  std::vector<std::uint32_t> m_first;  ///< of each band, in m_edges; one more at the end
  std::vector<Edge> m_edges;           ///< by band; an edge occurs in every band it touches
};

class Polygon final : public OneCrossing<Polygon> {
 public:
  /// Points as SDL lists them; a point within 1e-10 of a contour's first closes it, an unclosed
  /// last contour is closed. A degenerate polygon is allowed: nothing hits it. Degenerate:
  /// all sides' cross products shorter than 1e-5, or a point out of plane by 1e-10.
  explicit Polygon(std::vector<Vec3> points);

  const std::vector<Vec3>& points() const { return m_points; }
  bool is_degenerate() const { return m_degenerate; }

  ShapeTraits traits() const override {
    return {.name = "polygon", .convexity = Convexity::kFlat, .is_solid = false};
  }
  Bounds box(const Transform* move) const override { return moved_box(own_box(), move); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  std::unique_ptr<Shape> baked(const Transform& t) const override;

 private:
  friend struct PolygonPack;
  Bounds own_box() const;
  static constexpr std::uint32_t kFew = 4;  ///< edges that are simply looked through

  std::vector<EvenOdd::Edge> edges() const;
  void orient();
  void flatten();

  Vec3 m_normal;          ///< unit
  double m_offset = 0.0;  ///< of the plane, along the normal
  double m_lo_u = 0.0, m_hi_u = 0.0, m_lo_v = 0.0, m_hi_v = 0.0;
  int m_u = 0, m_v = 1;  ///< the axes of the projection that the test in 2D works in
  bool m_degenerate = false;
  std::uint32_t m_few_edges = 0;
  std::array<EvenOdd::Edge, kFew> m_few{};
  EvenOdd m_many;              ///< used where there are more edges than kFew
  std::vector<Vec3> m_points;  ///< the first of a contour repeated at its end, exactly
};

}  // namespace lentray::core
