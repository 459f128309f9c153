#include "camera/bent.h"

namespace lentray::camera {

void Bent::bend(double column, double row, core::Ray& ray) const {
  const core::Vec3 place{column / width() - 0.5, 0.5 - row / height(), 0.0};
  ray.direction = normalized(m_normal->perturb(place, normalized(ray.direction), core::kNoSurface));
}

bool Bent::ray(double column, double row, core::Ray& ray) const {
  if (!m_straight->ray(column, row, ray)) return false;
  bend(column, row, ray);
  return true;
}

bool Bent::ray_at(const core::PixelPlace& place, core::Ray& out) const {
  if (!m_straight->ray_at(place, out)) return false;
  bend(place.column + 0.5 + place.across, place.row + 0.5 + place.down, out);
  return true;
}

bool Bent::lens_ray_at(const core::PixelPlace& place, double x, double y, core::Ray& out) const {
  if (!m_straight->lens_ray_at(place, x, y, out)) return false;
  bend(place.column + 0.5 + place.across, place.row + 0.5 + place.down, out);
  return true;
}

}  // namespace lentray::camera
