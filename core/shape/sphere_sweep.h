// sphere_sweep: what a sphere sweeps whose centre and radius follow a spline. Space: object.
// Source: reference manual 3.7, "Sphere Sweep"; compared with stock by tests/image/shapes_test.cpp.
//
// On a ray p + t d (d unit) the sphere of parameter u is met at t = -b -+ sqrt(b^2 - c), with
// b = d.(p - C(u)) and c = |p - C(u)|^2 - r(u)^2. The sweep's surface is where t is extreme over u:
// c' + 2 b' t = 0, a polynomial in u of order 10 once t is eliminated; and the first and last sphere.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/shape/shape.h"

namespace lentray::core {

/// Centre and radius over u = 0..1, coefficients of rising powers.
struct SweepPiece {
  std::array<Vec3, 4> centre{};
  std::array<double, 4> radius{};
  int order = 3;  ///< 1: straight, 3: a cubic

  Vec3 centre_at(double u) const {
    return centre[0] + (centre[1] + (centre[2] + centre[3] * u) * u) * u;
  }
  double radius_at(double u) const {
    return radius[0] + (radius[1] + (radius[2] + radius[3] * u) * u) * u;
  }
};

struct BoxRay;

class SphereSweep final : public Shape {
 public:
  /// `tolerance`: along rays, in the world; what they meet before it does not count.
  explicit SphereSweep(std::vector<SweepPiece> pieces, double tolerance = 0.0);

  ShapeTraits traits() const override {
    return {.name = "sphere_sweep", .tells_all = m_tolerance <= kFine};
  }
  Bounds box(const Transform* move) const override { return move ? box_in(*move) : m_bounds; }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool holds(const Vec3& p, bool inverse) const override { return within(p, 0.0) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;

 private:
  friend struct PlainShapes;  // tests/unit/shape/plain_shapes.h
  Bounds box_in(const Transform& t) const;
  struct Line;
  void crossings(const Ray& ray, double t_min, double t_max, ShapeHits& out) const;
  /// Of a piece of order kOrder, between two parameters; of a straight one with its end spheres.
  template <std::size_t kOrder>
  void piece_crossings(std::uint32_t index, const Line& line, double from, double to,
                       ShapeHits& out) const;
  void sphere_crossings(std::uint32_t index, double u, const Line& line, ShapeHits& out) const;
  /// Calls `visit` with each crossing in order, until it returns false.
  template <class Visit>
  void on_surface(const Ray& ray, double t_min, double t_max, Visit&& visit) const;
  bool within(const Vec3& p, double margin) const;

  static constexpr double kFine =
      1e-4;  ///< a tolerance below which rays that begin anew miss nothing
  std::vector<SweepPiece> m_pieces;
  static constexpr std::uint32_t kParts = 8;
  /// The first part that the ray may meet beyond t_min, and that after the last; both 0 if none.
  std::pair<std::uint32_t, std::uint32_t> parts_met(const BoxRay& ray, std::uint32_t piece,
                                                    double t_min) const;

  std::vector<Bounds> m_boxes;  ///< one a piece
  std::vector<Bounds> m_parts;  ///< kParts a piece, along it; asked for curved ones
  Bounds m_bounds;
  double m_tolerance;
};

}  // namespace lentray::core
