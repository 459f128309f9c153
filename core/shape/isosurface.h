// isosurface: where a function equals its threshold, within a box or a sphere; inside it is less.
// Found by halving the way through the container, given that the function is never steeper than
// `max_gradient`, down to pieces shorter than `accuracy`: scenes are tuned to this search.
// Space: object.
// Source: reference manual 3.7, "Isosurface"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <memory>
#include <utility>

#include "core/function/program.h"
#include "core/numeric/slope_watch.h"
#include "core/shape/shape.h"

namespace lentray::core {

struct IsosurfaceSettings {
  std::shared_ptr<const Function> function;  ///< of x, y, z
  bool in_sphere = false;
  Vec3 lo{-1, -1, -1}, hi{1, 1, 1};  ///< container: box
  Vec3 centre;                       ///< container: sphere
  double radius = 1.0;
  double threshold = 0.0, accuracy = 0.001, max_gradient = 1.1;
  bool evaluates = false;                ///< `evaluate`: the gradient grows where it must
  double growth = 1.0, shrinking = 1.0;  ///< its second and third number
  int max_trace = 1;                     ///< surfaces looked for along a ray
  bool open = false;
};

class Isosurface final : public Shape {
 public:
  explicit Isosurface(IsosurfaceSettings settings);

  ShapeTraits traits() const override { return {.name = "isosurface", .tells_all = false}; }
  Bounds box(const Transform* move) const override { return move ? box_in(*move) : own_box(); }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool any(const Ray& ray, double t_min, double t_max) const override;
  bool holds(const Vec3& p, bool inverse) const override { return within(p) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override;

  /// Before rendering: who is told how steep the function is along rays; null: nobody.
  void set_watch(std::shared_ptr<SlopeWatch> watch) { m_watch = std::move(watch); }

 private:
  bool within(const Vec3& p) const;
  Bounds own_box() const;
  Bounds box_in(const Transform& t) const;
  class Field;
  struct Search;
  double value(const Vec3& p) const;
  bool through_container(const Ray& ray, double& from, double& to, std::uint32_t& side_in,
                         std::uint32_t& side_out) const;
  /// Calls visit(t, element) until that answers false.
  template <class Visit>
  void crossings(const Ray& ray, Visit&& visit) const;

  IsosurfaceSettings m_set;
  const Program* m_program;  ///< the function, if it is one
  std::shared_ptr<SlopeWatch> m_watch;
};

}  // namespace lentray::core
