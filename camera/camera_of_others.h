// A camera whose pixels are those of other cameras. Immutable, any number of threads.
#pragma once

#include <algorithm>
#include <cmath>

#include "camera/camera.h"

namespace lentray::camera {

class CameraOfOthers : public Camera {
 public:
  /// `one`: of the others, which are alike.
  CameraOfOthers(const Camera& one, std::string_view name, std::uint32_t width,
                 std::uint32_t height)
      : Camera(name, width, height), m_one(one) {}

  bool ray(double column, double row, core::Ray& ray) const override {
    core::PixelPlace place;
    place.column = static_cast<std::int32_t>(std::floor(column));
    place.row = static_cast<std::int32_t>(std::floor(row));
    place.across = column - place.column - 0.5;
    place.down = row - place.row - 0.5;
    return ray_at(place, ray);
  }
  bool ray_at(const core::PixelPlace& place, core::Ray& out) const override {
    const Found found = find(place);
    return found.camera.ray_at(found.place, out);
  }
  bool one_ray_at(const core::PixelPlace& place, const core::PlaceRay& which,
                  core::Ray& out) const override {
    const Found found = find(place);
    return found.camera.one_ray_at(found.place, which, out);
  }
  bool sight(const core::PixelPlace& place, core::Ray& out) const override {
    const Found found = find(place);
    return found.camera.sight(found.place, out);
  }
  core::EyePlace eye_place(std::uint32_t column, std::uint32_t row) const override {
    const Found found =
        find({.column = static_cast<std::int32_t>(column), .row = static_cast<std::int32_t>(row)});
    return found.camera.eye_place(static_cast<std::uint32_t>(std::max(found.place.column, 0)),
                                  static_cast<std::uint32_t>(std::max(found.place.row, 0)));
  }
  std::uint32_t rays_a_place() const override { return m_one.rays_a_place(); }
  bool missing_rays_are_black() const override { return m_one.missing_rays_are_black(); }

 protected:
  struct Found {
    const Camera& camera;
    core::PixelPlace place;
  };
  virtual Found find(const core::PixelPlace& place) const = 0;

 private:
  const Camera& m_one;
};

}  // namespace lentray::camera
