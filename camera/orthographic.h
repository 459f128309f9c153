// The orthographic camera: parallel rays. Pixel (i, k) as in camera/perspective.h; the ray starts
// at location + x0 right + y0 up and runs along direction, oblique directions included.
// Source: reference manual 3.7, "Orthographic projection"; measured on stock, tests/image/rays_test.
#pragma once

#include "camera/camera.h"
#include "camera/projection.h"

namespace lentray::camera {

class Orthographic final : public Camera {
 public:
  Orthographic(const Projection& projection, std::uint32_t width, std::uint32_t height);
  bool ray(double column, double row, core::Ray& ray) const override;
  bool sight(const core::PixelPlace& place, core::Ray& out) const override;
  std::string_view name() const override { return "orthographic"; }
  std::uint32_t width() const override { return m_width; }
  std::uint32_t height() const override { return m_height; }
  Properties describe() const override;

 private:
  core::Ray aim(double column, double row) const;

  Projection m_projection;
  core::Vec3 m_direction;  ///< unit
  std::uint32_t m_width, m_height;
};

}  // namespace lentray::camera
