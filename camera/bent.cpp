#include "camera/bent.h"

namespace lentray::camera {

bool Bent::ray(double column, double row, core::Ray& ray) const {
  if (!m_straight->ray(column, row, ray)) return false;
  const core::Vec3 place{column / width() - 0.5, 0.5 - row / height(), 0.0};
  ray.direction =
      normalized(m_normal->perturb(place, normalized(ray.direction), core::kNoSurface));
  return true;
}

}  // namespace lentray::camera
