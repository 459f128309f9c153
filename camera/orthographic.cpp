#include "camera/orthographic.h"

namespace lentray::camera {

Orthographic::Orthographic(const Projection& projection, std::uint32_t width, std::uint32_t height)
    : m_projection(projection), m_direction(core::normalized(projection.direction)), m_width(width),
      m_height(height) {}

core::Ray Orthographic::aim(double column, double row) const {
  const double x0 = column / m_width - 0.5;
  const double y0 = 0.5 - row / m_height;
  return {m_projection.location + m_projection.right * x0 + m_projection.up * y0,
          m_projection.direction};
}

bool Orthographic::ray(double column, double row, core::Ray& ray) const {
  ray = aim(column, row);
  ray.direction = m_direction;
  return true;
}

bool Orthographic::sight(const core::PixelPlace& place, core::Ray& out) const {
  out = aim(place.column + 0.5 + place.across, place.row + 0.5 + place.down);
  return true;
}

Properties Orthographic::describe() const { return {{"camera", std::string("orthographic")}}; }

}  // namespace lentray::camera
