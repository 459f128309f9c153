// The part of a ray that a light can reach: all of it, or what lies in the light's cone or cylinder.
// World space. Pure functions. docs/media.md says where the samples in media lie.
// Source: geometry.
#pragma once

#include <optional>

#include "core/base/ray.h"
#include "core/light/light.h"

namespace lentray::core {

struct RayPart {
  double from, to;  ///< distances from the ray's origin
  bool holds(double distance) const { return distance >= from && distance <= to; }
};

/// Of the first `length` of the ray, whose direction is unit.
std::optional<RayPart> lit_part(const Light& light, const Ray& ray, double length);

}  // namespace lentray::core
