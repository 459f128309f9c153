#include "camera/conversion.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "camera/depth_budget.h"
#include "camera/projected.h"
#include "camera/sheet_collisions.h"
#include "camera/sheet_report.h"
#include "camera/sheet_sanity.h"
#include "camera/slanted_lenticular.h"
#include "camera/text.h"
#include "camera/thick_lenticular.h"
#include "core/base/bounds.h"

namespace lentray::camera {
namespace {

using core::Vec3;

/// The sheet's axes from a camera's vectors; the normal is on direction's side.
SheetPlacement placement_of(const Projection& p) {
  const double width = core::length(p.right), height = core::length(p.up);
  if (!(width > 0.0) || !(height > 0.0) || !std::isfinite(width) || !std::isfinite(height)) {
    throw CameraError("a lens sheet needs `right` and `up` vectors of some length");
  }
  SheetPlacement place;
  place.right = p.right / width;
  place.up = p.up / height;
  if (std::fabs(core::dot(place.right, place.up)) > 1e-6) {
    throw CameraError("`right` is not perpendicular to `up`, so this camera has no lens sheet");
  }
  const Vec3 across = core::normalized(core::cross(place.right, place.up));
  const double along = core::dot(across, p.direction);
  if (std::fabs(along) <= 1e-9 * core::length(p.direction)) {
    throw CameraError("`direction` lies in the picture plane, so this camera has no lens sheet");
  }
  place.normal = along > 0.0 ? across : -across;
  place.centre = p.location;
  place.width = width;
  place.height = height;
  place.eye_slope_x = core::dot(p.direction, place.right) / std::fabs(along);
  place.eye_slope_y = core::dot(p.direction, place.up) / std::fabs(along);
  // A camera set up by look_at is straight up to rounding; its sheet is exactly so.
  if (std::fabs(place.eye_slope_x) < 1e-12) place.eye_slope_x = 0.0;
  if (std::fabs(place.eye_slope_y) < 1e-12) place.eye_slope_y = 0.0;
  return place;
}

/// Median depth, in multiples of `direction`, of what a coarse grid of the camera's rays meets.
std::optional<double> median_depth(const Projection& p, const Vec3& normal,
                                   const SceneProbe& probe) {
  constexpr std::uint32_t kColumns = 32, kRows = 24;
  if (!probe) return std::nullopt;
  const Projected camera(ProjectedKind::kPerspective, p, {}, kColumns, kRows);
  std::vector<double> depths;
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      core::Ray ray;
      camera.ray(column + 0.5, row + 0.5, ray);
      if (const auto hit = probe(ray, core::Bounds::kInf)) {
        depths.push_back(hit->distance * core::dot(ray.direction, normal) /
                         core::dot(p.direction, normal));
      }
    }
  }
  if (depths.empty()) return std::nullopt;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

/// The sheet's distance along direction, in scene units, and a line that says where it is from.
double sheet_distance(const Projection& p, const Conversion& conversion, const Vec3& normal,
                      const SceneProbe& probe, std::vector<std::string>& report) {
  double distance = 0.0;
  if (conversion.sheet_distance) {
    distance = *conversion.sheet_distance;
    report.push_back("Sheet distance " + format(distance) + ", as asked for");
  } else if (p.look_at_distance && *p.look_at_distance > 0.0) {
    distance = *p.look_at_distance;
    report.push_back("Sheet distance " + format(distance) + ", where the camera looks at");
  } else if (const auto depth = median_depth(p, normal, probe)) {
    distance = *depth * core::length(p.direction);
    report.push_back("Sheet distance " + format(distance) +
                     ", the median depth of what the camera sees (it has no look_at)");
  } else {
    throw CameraError(
        "the camera has no look_at and sees nothing, so the sheet's distance is "
        "unknown: give Sheet_Distance");
  }
  if (!(distance > 0.0) || !std::isfinite(distance)) {
    throw CameraError("Sheet_Distance must be greater than 0", {"Sheet_Distance"});
  }
  return distance;
}

/// The sheet's height in mm, where one was asked for: to a whole number of the print's rows.
void set_height(const LensParameters& lens, const SheetSize& size, std::uint32_t rows,
                SheetPlacement& place) {
  const double larger = lens.print_pitch() / lens.pitch;
  place.height_mm = size.rows_fill_it
                        ? size.height
                        : rows * 25.4 / size.dpi_down.value_or(lens.print_dpi()) / larger;
}

/// A sheet that is not as wide as asked for is of another lens than the picture's columns are.
void check_width(const Lenticular& camera, const LensRequest& asked) {
  const LensSheet& sheet = camera.sheet();
  const bool has_scenes_eye = sheet.lens().is_finite() && !asked.view_distance;
  const double pixel = sheet.sheet_width() / sheet.width();
  if (has_scenes_eye || std::fabs(sheet.sheet_width() - asked.size->width) <= 1.5 * pixel) return;
  throw CameraError(
      "the scene's own lens makes the sheet " + format(sheet.sheet_width()) + " mm wide, not " +
          format(asked.size->width) +
          " mm: give its lens data and view_distance as options, from which the picture's "
          "columns follow",
      {"Sheet_Width", "Sheet_Height", kCameraToo});
}

/// The picture fills the sheet, so one of another shape is stretched.
void warn_of_shape(const Projection& p, const SheetSize& size, std::uint32_t width,
                   std::uint32_t height, std::vector<std::string>& warnings) {
  constexpr double kNoticeable = 0.005;
  const double of_picture = core::length(p.right) / core::length(p.up);
  const double of_sheet = size.width / size.height;
  const double stretch = of_sheet / of_picture - 1.0;
  if (std::fabs(stretch) <= kNoticeable) return;
  const bool square = std::fabs(width / (height * of_sheet) - 1.0) <= kNoticeable;
  warnings.push_back("the camera's picture is " + brief(of_picture) +
                     " times as wide as high, the sheet " + brief(of_sheet) +
                     " times: things look " + brief(100.0 * std::fabs(stretch)) + " % too " +
                     (stretch > 0.0 ? "wide" : "narrow") + " (" +
                     (square ? std::string("right x*image_width/image_height")
                             : "up y right " + brief(of_sheet) + "*x") +
                     " in the camera would fit)");
}

/// What Lens_Model=auto stands for.
void choose_model(const LensRequest& asked, const SheetPlacement& place, std::uint32_t width,
                  LensParameters& lens) {
  if (!asked.automatic_model) return;
  lens.model = LensSheet(lens, width, place.eye_slope_x)
                   .cheapest_model(asked.tolerance.value_or(kModelTolerance));
}

std::unique_ptr<Lenticular> make_sheet(const LensParameters& lens, const SheetPlacement& place,
                                       std::uint32_t width, std::uint32_t height) {
  if (lens.slant != 0.0) {
    return std::make_unique<SlantedLenticular>(lens, place, width, height);
  }
  if (lens.model == LensModel::kThick) {
    return std::make_unique<ThickLenticular>(lens, place, width, height);
  }
  return std::make_unique<Lenticular>(lens, place, width, height);
}

Sheet finish(LensParameters lens, SheetPlacement place, const LensRequest& asked,
             std::uint32_t width, std::uint32_t height, std::vector<std::string> report,
             const SceneProbe& probe) {
  choose_model(asked, place, width, lens);
  if (asked.size) set_height(lens, *asked.size, height, place);
  constexpr double kFarthest = 1e30;  // scene units; squares of such numbers are finite
  for (const double size : {place.width, place.height, 1.0 / place.width, 1.0 / place.height,
                            place.front, core::length(place.centre)}) {
    if (!(std::fabs(size) < kFarthest)) {
      throw CameraError("the sheet is too large, too small or too far away to be computed",
                        {"Sheet_Distance", "Lens_Front", kCameraToo});
    }
  }
  if (asked.depth_budget) {
    FittedDepth fitted = fit_depth(
        *asked.depth_budget, lens,
        [&](const LensParameters& l) { return make_sheet(l, place, width, height); }, probe);
    lens.depth_factor = fitted.factor;
    for (std::string& line : fitted.report) report.push_back(std::move(line));
  }
  Sheet sheet;
  sheet.camera = make_sheet(lens, place, width, height);
  if (asked.size) check_width(*sheet.camera, asked);
  sheet.report = std::move(report);
  for (std::string& line : report_of(*sheet.camera, asked, probe)) {
    sheet.report.push_back(std::move(line));
  }
  sheet.warnings = sheet.camera->warnings();
  for (std::string& line : viewing_warnings(*sheet.camera, asked)) {
    sheet.warnings.push_back(std::move(line));
  }
  std::ranges::move(sheet_sanity(lens, asked, sheet.camera->sheet().sheet_width(), place.height_mm),
                    std::back_inserter(sheet.warnings));
  Collisions met = collisions_of(*sheet.camera, probe);
  for (std::string& line : met.notes) sheet.report.push_back(std::move(line));
  for (std::string& line : met.warnings) sheet.warnings.push_back(std::move(line));
  return sheet;
}

/// What was asked for in vain.
void add_warnings(const LensRequest& asked, const Projection& projection, Sheet& sheet) {
  if (asked.size) {
    warn_of_shape(projection, *asked.size, sheet.camera->width(), sheet.camera->height(),
                  sheet.warnings);
  }
  if (asked.tolerance && !asked.automatic_model) {
    sheet.warnings.push_back("Lens_Tolerance has no effect: it is what Lens_Model=auto goes by");
  }
  if (asked.rays && sheet.camera->sheet().lens().model != LensModel::kThick) {
    sheet.warnings.push_back(
        "the number of rays (lens_rays, Lens_Rays) has no effect: only the lens model thick has "
        "several");
  }
}

double eye_in_scene(const LensParameters& lens, const SheetPlacement& place, std::uint32_t width) {
  return lens.view_distance * place.width /
         (width / lens.pixels * lens.pitch / lens.slant_cosine());
}

}  // namespace

Sheet sheet_of_statement(const Projection& projection, const LensRequest& request,
                         std::uint32_t width, std::uint32_t height, const SceneProbe& probe) {
  SheetPlacement place = placement_of(projection);
  LensRequest asked = request;
  if (!asked.view_distance) asked.view_distance = 0.0;
  if (!asked.model && !asked.automatic_model) asked.model = LensModel::kPinhole;
  const LensParameters lens = resolve(asked, width, nullptr);
  place.front = asked.front.value_or(std::min(place.width, eye_in_scene(lens, place, width)));
  Sheet sheet = finish(lens, place, request, width, height, {}, probe);
  add_warnings(request, projection, sheet);
  return sheet;
}

Sheet sheet_of_camera(std::string_view kind, const Projection& projection,
                      const Conversion& conversion, std::uint32_t width, std::uint32_t height,
                      const SceneProbe& probe) {
  if (kind != "perspective" && kind != "orthographic") {
    throw CameraError("a `" + std::string(kind) +
                          "` camera has no lens sheet: only perspective and orthographic ones have",
                      {"Lenticular", "Quilt", kCameraToo});
  }
  SheetPlacement place = placement_of(projection);
  const double size = core::length(projection.direction);
  std::vector<std::string> report;
  double distance = 0.0;  // along direction
  LensParameters lens;
  if (kind == "orthographic") {
    distance = conversion.sheet_distance.value_or(0.0);
    if (distance < 0.0)
      throw CameraError("Sheet_Distance must not be negative", {"Sheet_Distance"});
    LensRequest asked = conversion.lens;
    if (!asked.view_distance) asked.view_distance = 0.0;
    lens = resolve(asked, width, nullptr);
  } else {
    distance = sheet_distance(projection, conversion, place.normal, probe, report);
    place.width *= distance / size;
    place.height *= distance / size;
  }
  place.centre = projection.location + projection.direction * (distance / size);
  const double depth = core::dot(place.centre - projection.location, place.normal);
  if (kind == "perspective") {
    const EyeInScene eye{depth, place.width};
    lens = resolve(conversion.lens, width, &eye);
  }
  place.front = conversion.lens.front.value_or(std::min(depth, eye_in_scene(lens, place, width)));
  Sheet sheet = finish(lens, place, conversion.lens, width, height, std::move(report), probe);
  sheet.stand = SheetStand{distance, core::dot(projection.direction, place.normal) / size,
                           kind == "perspective"};
  add_warnings(conversion.lens, projection, sheet);
  return sheet;
}

}  // namespace lentray::camera
