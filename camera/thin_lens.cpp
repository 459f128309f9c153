#include "camera/thin_lens.h"

#include <cmath>

#include "camera/lens_request.h"

namespace lentray::camera {
namespace {

using core::Vec3;

/// Beyond it the squares of lengths are no numbers any more.
constexpr double kFarthest = 1e100;

struct Disc {
  Vec3 across, down;
};

/// Perpendicular to `axis`, along `up`.
Disc disc_of(const Vec3& up, const Vec3& axis, double aperture) {
  if (!(std::fabs(aperture) < kFarthest)) throw CameraError("the aperture is too large");
  const Vec3 across = core::normalized(core::cross(up, axis));
  const Vec3 upwards = core::normalized(core::cross(axis, across));
  return {across * (0.5 * aperture), upwards * (-0.5 * aperture)};
}

/// `camera_depth`: of an infinite viewing distance's discs; depths are behind the sheet.
ThinLens lens_of_sheet(const Lenticular& sheet, double aperture, double camera_depth,
                       double focus) {
  if (sheet.sheet().lens().model == LensModel::kThick) {
    throw CameraError(
        "the lens model thick has no focal blur: leave out the aperture, or take the model "
        "paraxial "
        "or pinhole",
        {"Lens_Model", kCameraToo});
  }
  const SheetPlacement& place = sheet.placement();
  const Disc disc = disc_of(place.up, place.normal, aperture);
  const double behind = sheet.has_near_eye() ? sheet.eye_distance() : -camera_depth;
  return {disc.across, disc.down, behind, focus, behind - place.front};
}

}  // namespace

ThinLens::ThinLens(const Vec3& across, const Vec3& down, double behind, double focus, double start)
    : m_across(across), m_down(down), m_behind(behind), m_reach(behind + focus),
      m_start(start / m_reach) {
  const double least = 1e-9 * (std::fabs(behind) + std::fabs(focus));
  if (!(std::fabs(m_reach) > least)) {
    throw CameraError("what is in focus lies in the plane of the aperture");
  }
  if (!(std::fabs(m_reach) < kFarthest)) throw CameraError("what is in focus lies too far away");
}

core::Ray ThinLens::through(const core::Ray& sight, double x, double y) const {
  const Vec3 off = m_across * x + m_down * y;
  const Vec3 to_focus = sight.direction * m_reach - off;
  const Vec3 point = sight.origin - sight.direction * m_behind + off;
  return {point + to_focus * m_start,
          m_reach < 0.0 ? -core::normalized(to_focus) : core::normalized(to_focus)};
}

ThinLens lens_of_camera(const Projection& projection, const BlurRequest& request) {
  const Disc disc = disc_of(projection.up, projection.direction, request.aperture);
  return {disc.across, disc.down, 0.0, request.focal_distance / core::length(projection.direction),
          0.0};
}

ThinLens lens_of_conversion(const Lenticular& sheet, const Projection& projection,
                            const BlurRequest& request) {
  const SheetPlacement& place = sheet.placement();
  const double camera = core::dot(projection.location - place.centre, place.normal);
  const double along = core::dot(core::normalized(projection.direction), place.normal);
  return lens_of_sheet(sheet, request.aperture, camera, camera + request.focal_distance * along);
}

ThinLens lens_of_statement(const Lenticular& sheet, const BlurRequest& request) {
  const SheetPlacement& place = sheet.placement();
  const Vec3 in_focus = request.focal_point.value_or(place.centre);
  return lens_of_sheet(sheet, request.aperture, -place.front,
                       core::dot(in_focus - place.centre, place.normal));
}

}  // namespace lentray::camera
