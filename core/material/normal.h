// Perturbation of the shading normal. Points and normals in the space of what holds it: the world,
// or the space of the pattern whose map it is an entry of. Immutable; any number of threads.
#pragma once

#include "core/base/vec3.h"
#include "core/pattern/surface_context.h"

namespace lentray::core {

class NormalPerturbation {
 public:
  virtual ~NormalPerturbation() = default;
  /// A unit normal -> the unit normal that shades.
  virtual Vec3 perturb(const Vec3& point, const Vec3& normal,
                       const SurfaceContext& surface) const = 0;
};

}  // namespace lentray::core
