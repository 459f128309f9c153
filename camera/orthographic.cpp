#include "camera/orthographic.h"

namespace lentray::camera {

Orthographic::Orthographic(const Projection& projection, std::uint32_t width, std::uint32_t height)
    : m_projection(projection),
      m_direction(core::normalized(projection.direction)),
      m_width(width),
      m_height(height) {}

bool Orthographic::ray(double column, double row, core::Ray& ray) const {
  const double x0 = column / m_width - 0.5;
  const double y0 = 0.5 - row / m_height;
  ray.origin = m_projection.location + m_projection.right * x0 + m_projection.up * y0;
  ray.direction = m_direction;
  return true;
}

Properties Orthographic::describe() const { return {{"camera", std::string("orthographic")}}; }

}  // namespace lentray::camera
