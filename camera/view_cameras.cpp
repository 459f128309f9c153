#include "camera/view_cameras.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lentray::camera {
namespace {

using core::Vec3;

/// The slope of a view's line through the sheet's middle, as one of its rays gives it.
struct Slopes {
  double x, y;
};

/// From a grid of places over the view's picture.
std::vector<Slopes> slopes_of(const Lenticular& sheet, const Camera& view) {
  constexpr std::uint32_t kSide = 9;
  const SheetPlacement& place = sheet.placement();
  const double inverse = 1.0 / sheet.eye_distance();
  std::vector<Slopes> out;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    core::PixelPlace at;
    at.column = static_cast<std::int32_t>((view.width() - 1) * (i % kSide) / (kSide - 1));
    at.row = static_cast<std::int32_t>((view.height() - 1) * (i / kSide) / (kSide - 1));
    core::Ray ray;
    if (!view.sight(at, ray)) continue;
    const Vec3 from_middle = ray.origin - place.centre;
    const double ahead = dot(ray.direction, place.normal);
    out.push_back(
        {dot(ray.direction, place.right) / ahead - dot(from_middle, place.right) * inverse,
         dot(ray.direction, place.up) / ahead - dot(from_middle, place.up) * inverse});
  }
  return out;
}

}  // namespace

ViewCamera view_camera(const Lenticular& sheet, const Camera& view, double lenses) {
  const SheetPlacement& place = sheet.placement();
  ViewCamera out;
  const std::vector<Slopes> all = slopes_of(sheet, view);
  out.is_dark = all.empty();
  out.is_perspective = sheet.has_near_eye();
  Slopes mean{0.0, 0.0};
  for (const Slopes& one : all) {
    mean.x += one.x / static_cast<double>(all.size());
    mean.y += one.y / static_cast<double>(all.size());
  }
  for (const Slopes& one : all)
    out.miss = std::max({out.miss, std::fabs(one.x - mean.x), std::fabs(one.y - mean.y)});
  const double share = lenses / sheet.sheet().lenses();
  const Vec3 window = place.centre + place.right * (0.5 * (share - 1.0) * place.width);
  const Vec3 line = place.normal + place.right * mean.x + place.up * mean.y;
  out.normal = place.normal;
  out.right = place.right * (share * place.width);
  out.up = place.up * place.height;
  out.distance = out.is_perspective ? sheet.eye_distance() : place.front;
  out.start = out.is_perspective ? out.distance - place.front : 0.0;
  out.eye = (out.is_perspective ? place.centre : window) - line * out.distance;
  // Parallel rays may start in the sheet.
  out.towards = out.is_perspective ? window - out.eye : line;
  return out;
}

}  // namespace lentray::camera
