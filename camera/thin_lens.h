// A camera's aperture: where the rays through a place start, and where they meet. World space.
//
// A sight (Camera::sight) is a ray with an un-normalised direction. The lens lies `behind` sights
// before the sight's origin and is in focus `focus` sights beyond it; for a flat picture that is a
// plane parallel to it.
// Immutable, any number of threads. Errors: CameraError.
// Source: reference manual 3.7, "Focal Blur"; the disc's size, its plane and the distance in focus
// were measured on stock and are compared with it by tests/image/focal_blur_test.cpp.
#pragma once

#include <optional>

#include "camera/lenticular.h"
#include "camera/projection.h"
#include "core/base/ray.h"
#include "core/render/focal_blur.h"

namespace lentray::camera {

/// What a camera statement says of focal blur.
struct BlurRequest {
  double aperture = 0.0;                  ///< scene units; the disc is half as wide
  double focal_distance = 1.0;            ///< from location, along direction; scene units, > 0
  std::optional<core::Vec3> focal_point;  ///< if the statement has one
  core::FocalBlurOptions samples;
};

class ThinLens {
 public:
  /// `across` and `down`: the aperture's plane, one of its units long each.
  ThinLens(const core::Vec3& across, const core::Vec3& down, double behind, double focus,
           double start);
  /// The ray along a sight that starts at a point of the aperture instead, unit.
  core::Ray through(const core::Ray& sight, double x, double y) const;

 private:
  core::Vec3 m_across, m_down;
  double m_behind;  ///< sights
  double m_reach;   ///< sights from the lens to where it is in focus, not 0
  double m_start;   ///< where the ray starts, as a share of the way from the lens to the focus
};

/// Of an ordinary camera: the disc is perpendicular to its direction, about where each ray starts.
ThinLens lens_of_camera(const Projection& projection, const BlurRequest& request);

/// Of a sheet that `Lenticular=On` makes of an ordinary camera. The disc is parallel to the sheet,
/// about the eye of each view; with an infinite viewing distance about where its rays pass the
/// camera's plane. In focus is what the camera has in focus.
ThinLens lens_of_conversion(const Lenticular& sheet, const Projection& projection,
                            const BlurRequest& request);
/// Of `camera { lenticular }`: as above, but with an infinite viewing distance about where the rays
/// start. In focus is the plane through focal_point; without one, the sheet.
ThinLens lens_of_statement(const Lenticular& sheet, const BlurRequest& request);

}  // namespace lentray::camera
