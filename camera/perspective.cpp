#include "camera/perspective.h"

namespace lentray::camera {

Perspective::Perspective(const Projection& projection, std::uint32_t width, std::uint32_t height)
    : m_projection(projection), m_width(width), m_height(height) {}

bool Perspective::ray(double column, double row, core::Ray& ray) const {
  const double x0 = column / m_width - 0.5;
  const double y0 = 0.5 - row / m_height;
  ray.origin = m_projection.location;
  ray.direction = core::normalized(m_projection.direction + m_projection.right * x0 +
                                   m_projection.up * y0);
  return true;
}

Properties Perspective::describe() const { return {{"camera", std::string("perspective")}}; }

}  // namespace lentray::camera
