// A ray on its way through the scene, and a place on a surface that it has met. World space.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/base/ray.h"
#include "core/object/leaf.h"
#include "core/pattern/surface_context.h"
#include "core/trace/interior_stack.h"
#include "core/trace/shadow_tester.h"

namespace lentray::core {

/// A ray with what it carries. The ray is borrowed: a copy made right after it was written would wait
/// for it.
struct RayState {
  explicit RayState(const Ray& r) : ray(r) {}
  /// Not an aggregate: that would clear the whole stack first.
  RayState(const Ray& r, const InteriorStack& in, std::uint32_t tree_place, RayKind ray_kind)
      : ray(r), inside(in), place(std::min(tree_place, kTreePlaces - 1)), kind(ray_kind) {}
  const Ray& ray;
  InteriorStack inside;
  std::uint32_t place = 1;  ///< in the ray tree, see ShadowQuery
  RayKind kind = RayKind::kCamera;
  double wavelength = kWhite;  ///< nm, of the band of light that dispersion left
  static constexpr double kWhite = 0.0;
};

/// A place on a surface that is shaded. Members without initialisers: all are given.
struct Surface {
  const RayState& state;
  const Attributes& looks;
  SurfaceContext context;  ///< patterns of a layer see the normal of the one above
  Vec3 normal;             ///< unit, facing the ray
  Vec3 texture_point;
  double texture_weight;  ///< of the texture that is shaded, among those that blend there
  float weight;           ///< the ray's share of the pixel
  int level;
  bool from_behind;  ///< the ray leaves the surface's solid

  const Ray& ray() const { return state.ray; }
  const Vec3& point() const { return context.point; }
  const Hit& hit() const { return *context.hit; }
  InteriorEntry interior() const { return interior_of(looks, context.hit->object); }
};

}  // namespace lentray::core
