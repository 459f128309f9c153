// What a surface between interiors does to a ray that passes it. Pure but for the table's own
// numbers.
// Source: reference manual 3.7, "Interior"; the order of nested and overlapping ones is stock's.
#pragma once

#include <cmath>
#include <optional>

#include "core/base/color.h"
#include "core/base/tiny.h"
#include "core/base/vec3.h"
#include "core/trace/interior_table.h"

namespace lentray::core {

/// What refraction at a surface depends on: before it over behind it.
struct Bend {
  double ior = 1.0, dispersion = 1.0;
  int bands = kDefaultBands;  ///< that light is split into, if dispersion is not 1
};

/// Changes `inside` as a ray passes the surface of that interior. Nested objects count as cut out
/// of those around them. Where objects overlap, the one that was entered last fills the overlap,
/// and leaving the other one there bends nothing.
Bend enter(const InteriorEntry& entry, double atmosphere_ior, InteriorTable& table,
           InteriorsId& inside);

/// Whether each coordinate is the same but for kTiny.
inline bool nearly_equal(const Vec3& a, const Vec3& b) {
  return std::fabs(a.x - b.x) <= kTiny && std::fabs(a.y - b.y) <= kTiny &&
         std::fabs(a.z - b.z) <= kTiny;
}

/// The direction behind a surface of a unit direction before it; empty on total internal reflection. `ior`:
/// before the surface over behind it. Unit if the normal is.
inline std::optional<Vec3> refracted(const Vec3& incoming, Vec3 normal, double ior) {
  double cosine = dot(incoming, normal);
  if (cosine > 0.0) normal = -normal;
  cosine = std::fabs(cosine);
  const double under_root = 1.0 + ior * ior * (cosine * cosine - 1.0);
  if (under_root < 0.0) return std::nullopt;
  return incoming * ior + normal * (ior * cosine - std::sqrt(under_root));
}

/// For the Fresnel term: the ior behind the surface over the ior before it. Leaving a nested object
/// compares with the innermost interior, which is most often the object itself.
double relative_ior(const InteriorEntry& entry, const InteriorTable& table, InteriorsId inside,
                    double atmosphere_ior);

/// What is left of light after `depth` in an interior, as seen by rays (shadows need a fade power).
Rgb fade_in_interior(const Interior& interior, double depth);

}  // namespace lentray::core
