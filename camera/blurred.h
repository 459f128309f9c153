// A camera with an aperture: focal blur. World space.
#pragma once

#include <memory>

#include "camera/camera.h"
#include "camera/thin_lens.h"
#include "core/render/focal_blur.h"

namespace lentray::camera {

class Blurred final : public Camera {
 public:
  Blurred(std::shared_ptr<const Camera> sharp, const ThinLens& lens,
          const core::FocalBlurOptions& samples)
      : Camera(*sharp), m_sharp(std::move(sharp)), m_lens(lens), m_blur(samples) {}
  /// Through the middle of the aperture.
  bool ray(double column, double row, core::Ray& ray) const override {
    return m_sharp->ray(column, row, ray);
  }
  bool ray_at(const core::PixelPlace& place, core::Ray& out) const override {
    return m_sharp->ray_at(place, out);
  }
  bool sight(const core::PixelPlace& place, core::Ray& out) const override {
    return m_sharp->sight(place, out);
  }
  const core::FocalBlur* blur() const override { return &m_blur; }
  bool lens_ray_at(const core::PixelPlace& place, double x, double y,
                   core::Ray& out) const override {
    core::Ray sight;
    if (!m_sharp->sight(place, sight)) return false;
    out = m_lens.through(sight, x, y);
    return true;
  }
  core::PixelLattice lattice(std::uint32_t width) const override { return m_sharp->lattice(width); }
  Properties describe() const override { return m_sharp->describe(); }

 private:
  std::shared_ptr<const Camera> m_sharp;
  ThinLens m_lens;
  core::FocalBlur m_blur;
};

}  // namespace lentray::camera
