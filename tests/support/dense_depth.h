// What every pixel of a lens sheet shows, by how far it moves from view to view: eyes, rays and projections of the
// tests' own, beside which camera/depth_survey.h and camera/composition.h are held. Paraxial sheets of converted
// cameras. Lengths of a lens in mm, the rest in scene units. Threads: the machine's.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "camera/projection.h"
#include "core/scene/scene.h"

namespace lentray::test {

/// A sheet that stands `distance` before the camera, along its normal.
struct DenseSheet {
  double pitch = 1.124, focal_length = 3.03, index = 1.6, pixels = 15.0;
  double print_pitch = 1.124;  ///< P'
  int width = 0, height = 0;   ///< of the integral image
  double distance = 1.0;
  double factor = 1.0;  ///< of the way of the eyes
};

/// Parallax in pixels of a view, behind the sheet above 0.
struct DenseDepth {
  double least = 1e300, most = -1e300;  ///< of points
  double low = 0.0, high = 0.0;  ///< all but a twentieth of the pixels with points at either end
  double sky = 0.0;              ///< of what is infinitely far; 0: rays are parallel
  std::uint64_t rays = 0, background = 0;
  bool has_sky() const { return background > 0; }
};

class DenseScene {
 public:
  /// `width` and `height` as the scene is told them. Throws what reading does.
  DenseScene(const std::string& path, int width, int height);
  /// Along the sheet's normal, where the camera looks; 0: nowhere.
  double look_at_distance() const;
  /// The same in mm of such a sheet there.
  double look_at_millimetres(const DenseSheet& sheet) const;
  /// Of a point before the camera, along its normal.
  double distance_of(const core::Vec3& point) const {
    return core::dot(point - m_camera.location, m_normal);
  }
  DenseDepth look(const DenseSheet& sheet) const;

 private:
  struct Frame;

  bool m_is_perspective = true;
  std::unique_ptr<core::Scene> m_scene;
  camera::Projection m_camera;
  core::Vec3 m_normal;
};

}  // namespace lentray::test
