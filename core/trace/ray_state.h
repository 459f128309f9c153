// A ray on its way through the scene, and a place on a surface that it has met. World space.
#pragma once

#include <cstdint>

#include "core/base/ray.h"
#include "core/object/leaf.h"
#include "core/pattern/surface_context.h"
#include "core/trace/interior_table.h"

namespace lentray::core {

/// A ray with what it carries: a value, to be followed now or later.
struct RayState {
  static constexpr double kWhite = 0.0;

  Ray ray;
  std::uint64_t key;           ///< of its random numbers (random_key.h): its place in the ray tree
  double wavelength = kWhite;  ///< nm, of the band of light that dispersion left
  float weight = 1.0f;         ///< its share of the pixel
  int level = 0;               ///< trace levels above it; a Surface's level counts from 1
  InteriorsId inside = InteriorsId::kOpen;  ///< of the thread's table
  std::uint32_t tree_place = 1;             ///< for caches: see ShadowQuery
  RayKind kind = RayKind::kCamera;
  /// Passed the last surface unrefracted: the next surface adds no trace level.
  bool straight_on = false;
  /// Translucent surfaces, from the camera to the ray, whose subsurface light the ray gathers.
  std::uint8_t scattered = 0;
};

/// Where a ray has met a surface.
struct MetPlace {
  MetPlace() {}  // not defaulted: that would clear all
  MetPlace(const Ray& ray, const Hit& hit)
      : point(ray.at(hit.t)), normal(hit.leaf->normal(point, hit.shape)),
        from_behind(dot(normal, ray.direction) > 0.0) {
    if (from_behind) normal = -normal;
  }
  Vec3 point;
  Vec3 normal;       ///< unit, facing the ray
  bool from_behind;  ///< the ray leaves the surface's solid
};

/// A place on a surface that is shaded. Members without initialisers: all are given.
struct Surface {
  const RayState& state;
  const Attributes& attributes;
  SurfaceContext context;  ///< what patterns see
  Vec3 normal;             ///< unit, facing the ray
  double texture_weight;   ///< of the texture that is shaded, among those that blend there
  int level;               ///< trace level, 1: camera ray
  std::uint32_t layer;     ///< layers shaded so far, of all textures
  bool from_behind;        ///< the ray leaves the surface's solid

  const Ray& ray() const { return state.ray; }
  const Vec3& point() const { return context.point; }
  const Hit& hit() const { return *context.hit; }
  InteriorEntry interior() const { return interior_of(attributes, context.hit->object); }
};

}  // namespace lentray::core
