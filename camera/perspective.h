// The perspective camera. Pixel (i, k): x0 = (i+.5)/W - .5, y0 = .5 - (k+.5)/H, ray from location
// along direction + x0 right + y0 up; oblique, mirrored and skewed frames are used as given.
// Source: reference manual 3.7, "Perspective projection"; measured on stock, tests/image/rays_test.
#pragma once

#include "camera/camera.h"
#include "camera/projection.h"

namespace lentray::camera {

class Perspective final : public Camera {
 public:
  Perspective(const Projection& projection, std::uint32_t width, std::uint32_t height);
  bool ray(double column, double row, core::Ray& ray) const override;
  bool sight(const core::PixelPlace& place, core::Ray& out) const override;
  std::string_view name() const override { return "perspective"; }
  std::uint32_t width() const override { return m_width; }
  std::uint32_t height() const override { return m_height; }
  Properties describe() const override;

 private:
  core::Ray aim(double column, double row) const;

  Projection m_projection;
  std::uint32_t m_width, m_height;
};

}  // namespace lentray::camera
