// mesh_camera: every ray starts at a face of a mesh, along its normal. World space; the normal is
// that of (third - first corner) x (second - first corner), or blended from the corners' normals.
// Distribution 0 to 2 count faces along the rows of the picture; 3 finds them by texture
// coordinates. Several rays a pixel are for distribution 0: stock's others have one, or one repeated.
// As in stock 3.7, which renders row 0 twice and every other one a row later (3.8 does
// not): row k sees what row k - 1 should.
// Source: reference manual 3.7, "Mesh Camera"; compared with stock by tests/image/mesh_camera_test.cpp.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "camera/camera.h"
#include "core/base/transform.h"

namespace lentray::camera {

struct MeshCameraFace {
  std::array<core::Vec3, 3> corner;
  core::Vec3 normal;                  ///< unit
  std::array<core::Vec3, 3> normals;  ///< of the corners; all null where the face is flat
  std::array<core::Vec2, 3> uv;
};
/// Faces in the scene's order, degenerate ones left out; copies of a mesh share them.
using MeshCameraFaces = std::shared_ptr<const std::vector<MeshCameraFace>>;

struct MeshCameraPart {
  MeshCameraFaces faces;
  core::Transform to_world;
};

struct MeshCameraSetup {
  std::vector<MeshCameraPart> parts;  ///< at least one
  int distribution = 0;               ///< 0..3
  std::uint32_t rays = 1;  ///< of a pixel: distribution 0 has one of each part, up to so many
  bool smooth = false;     ///< distribution 3 follows the corners' normals
  double forward = 0.0;    ///< `location`'s z: starts so far along the normal
  bool backwards = false;  ///< `direction`'s z is negative: looks against the normal
};

class MeshCamera final : public Camera {
 public:
  /// Throws CameraError if a part is missing or has no faces.
  MeshCamera(MeshCameraSetup setup, std::uint32_t width, std::uint32_t height);
  ~MeshCamera() override;
  bool ray(double column, double row, core::Ray& ray) const override;
  std::uint32_t rays_a_place() const override;
  bool one_ray_at(const core::PixelPlace& place, const core::PlaceRay& which,
                  core::Ray& ray) const override;

 private:
  class UvIndex;
  /// Of the face that distribution 0 has there, in that part.
  bool from_part(const MeshCameraPart& part, double column, double row, core::Ray& ray) const;
  bool by_place(double x, double y, core::Ray& ray) const;
  bool from_face(const MeshCameraPart& part, std::size_t face, core::Ray& ray) const;
  void start(const MeshCameraPart& part, core::Vec3 origin, core::Vec3 direction,
             core::Ray& ray) const;

  MeshCameraSetup m_setup;
  std::unique_ptr<UvIndex> m_index;   ///< of the first part, for distribution 3
  std::vector<std::size_t> m_before;  ///< faces of the parts before each, for distribution 1
};

}  // namespace lentray::camera
