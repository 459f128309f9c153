// A camera whose rays a normal statement bends: `normal` of a camera. World space.
// Source: reference manual 3.7, "Camera Ray Perturbation"; compared with stock by
// tests/image/mesh_camera_test.cpp.
#pragma once

#include <memory>

#include "camera/camera.h"
#include "core/material/normal.h"

namespace lentray::camera {

class Bent final : public Camera {
 public:
  /// The pattern lies over the picture, which is 1 x 1 about the origin of its x-y plane.
  Bent(std::unique_ptr<Camera> straight, std::shared_ptr<const core::NormalPerturbation> normal)
      : Camera(*straight), m_straight(std::move(straight)), m_normal(std::move(normal)) {}
  bool ray(double column, double row, core::Ray& ray) const override;
  bool ray_at(const core::PixelPlace& place, core::Ray& out) const override;
  const core::FocalBlur* blur() const override { return m_straight->blur(); }
  bool lens_ray_at(const core::PixelPlace& place, double x, double y,
                   core::Ray& out) const override;
  core::PixelLattice lattice(std::uint32_t width) const override {
    return m_straight->lattice(width);
  }
  Properties describe() const override { return m_straight->describe(); }

 private:
  void bend(double column, double row, core::Ray& ray) const;

  std::unique_ptr<Camera> m_straight;
  std::shared_ptr<const core::NormalPerturbation> m_normal;
};

}  // namespace lentray::camera
