// parametric: the points <x(u, v), y(u, v), z(u, v)> of a rectangle of u and v, within a box or a
// sphere. Found by halving the rectangle, given that no function is steeper than `max_gradient`, down
// to pieces smaller than `accuracy`: scenes are tuned to this search. The surface so found
// lies lower by the accuracy on each axis, and only its first point is known.
// The boxes of the first halvings, which hold for every ray, are kept.
// Space: object.
// Source: reference manual 3.7, "Parametric"; compared with stock by tests/image/parametric_test.cpp.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/function/function.h"
#include "core/shape/crossings.h"

namespace lentray::core {

struct ParametricSettings {
  std::array<std::shared_ptr<const Function>, 3> functions;  ///< of u, v
  Vec2 lo, hi;                                               ///< the rectangle
  bool in_sphere = false;
  Vec3 box_lo{-1, -1, -1}, box_hi{1, 1, 1};  ///< container: box
  Vec3 centre;                               ///< container: sphere
  double radius = 1.0;
  double accuracy = 0.001, max_gradient = 1.0;
  int precompute_depth = 0;          ///< 1 .. 20 if any of ...
  std::array<bool, 3> precompute{};  ///< ... x, y, z is bounded by its parts from the start
};

class Parametric final : public OneCrossing<Parametric> {
 public:
  explicit Parametric(ParametricSettings settings);

  ShapeTraits traits() const override {
    return {.name = "parametric", .is_solid = false, .has_uv = true, .tells_all = false};
  }
  Bounds box(const Transform* move) const override { return moved_box(m_bounds, move); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;
  Vec2 uv(const Vec3&, const ShapeHit& hit) const override { return {hit.u, hit.v}; }

 private:
  struct Range {
    double lo, hi;
  };
  using Ranges = std::array<Range, 3>;
  /// A function at <lo, lo>, <lo, hi>, <hi, lo>, <hi, hi> of a piece.
  using Corners = std::array<double, 4>;
  struct Piece {
    double u_lo, u_hi, v_lo, v_hi;
    bool across_u() const { return !(v_hi - v_lo > u_hi - u_lo); }  ///< how it is halved
    double size() const { return across_u() ? u_hi - u_lo : v_hi - v_lo; }
    void halve(Piece& lower, Piece& upper) const;
  };
  /// A piece of the first halvings: the second and third are the halves of the first, and so on.
  struct Kept {
    Ranges tight;            ///< of all its parts: a ray to a hit passes these ...
    Ranges own;              ///< ... and these, as the search has them
    double narrowest = 0.0;  ///< of its own
    bool own_cuts = false;   ///< they do not hold its parts: the gradient given is too low
  };
  struct Bound;
  struct Entry;
  struct Search;

  double value(int axis, double u, double v) const;
  Corners corners(int axis, const Piece& piece) const;
  Range range(const Corners& f, const Piece& piece) const;
  static void halve(const Corners& f, const std::array<double, 2>& middle, bool across_u,
                    Corners& lower, Corners& upper);
  std::array<double, 2> between(int axis, const Piece& piece) const;
  Bound keep(std::size_t number, int level, const Piece& piece, const std::array<Corners, 3>& f,
             int levels);
  bool through_container(const Ray& ray, double& from, double& to) const;

  ParametricSettings m_set;
  int m_levels;                                   ///< kept
  std::vector<Kept> m_kept;                       ///< [0] is not used
  std::vector<std::array<Corners, 3>> m_corners;  ///< of the last level kept
  bool m_too_flat = false;                        ///< some own_cuts: hits can be anywhere
  Bounds m_bounds;
};

}  // namespace lentray::core
