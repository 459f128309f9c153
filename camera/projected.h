// Cameras of one frame and one projection: perspective, orthographic, fisheye, ultra_wide_angle,
// omnimax, panoramic, spherical and the four kinds of cylinder. Frames as given by the scene:
// right, up and direction need not be perpendicular. Pixels that a camera does not see have no ray.
//
// Pixel (i, k) lies at x = (i+.5)/W - .5, y = .5 - (k+.5)/H. Its perspective ray runs from location
// along direction + x right + y up. Its orthographic ray starts at location + x right + y up and runs
// along direction.
// Source: reference manual 3.7, "Types of Projection"; rays compared with stock by tests/image/rays_test.cpp.
#pragma once

#include <optional>

#include "camera/camera.h"
#include "camera/projection.h"

namespace lentray::camera {

enum class ProjectedKind {
  kPerspective,
  kOrthographic,
  kFisheye,
  kUltraWideAngle,
  kOmnimax,
  kPanoramic,
  kSpherical,
  kCylinder1,
  kCylinder2,
  kCylinder3,
  kCylinder4
};

/// Angles in degrees.
struct ProjectedAngles {
  double angle = 90.0;                          ///< of the kinds that have one angle
  double horizontal = 360.0, vertical = 180.0;  ///< spherical
};

class Projected final : public Camera {
 public:
  Projected(ProjectedKind kind, const Projection& projection, const ProjectedAngles& angles,
            std::uint32_t width, std::uint32_t height);
  bool ray(double column, double row, core::Ray& ray) const override;
  bool sight(const core::PixelPlace& place, core::Ray& out) const override;

 private:
  bool aim(double column, double row, core::Ray& ray) const;
  /// x, y: -1/2..1/2 across the picture and up it; the direction may have any length.
  bool fisheye(double x, double y, core::Vec3& direction) const;
  bool omnimax(double x, double y, core::Vec3& direction) const;
  bool around(double radius, double x, double y, double angle, core::Vec3& direction) const;
  core::Vec3 panoramic(double x, double y) const;
  core::Vec3 spherical(double x, double y) const;
  core::Vec3 frame(double right, double up, double direction) const;

  ProjectedKind m_kind;
  Projection m_projection;  ///< vectors made unit where stock does so
  ProjectedAngles m_angles;
  double m_wide, m_high;  ///< lengths of right and up
};

/// The kind of SDL's word and, for `cylinder`, its number; nullopt for cameras of other sorts.
std::optional<ProjectedKind> projected_kind(std::string_view word, int cylinder_type);

}  // namespace lentray::camera
