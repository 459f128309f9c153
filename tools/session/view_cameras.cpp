#include "tools/session/view_cameras.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "camera/sheet_views.h"
#include "camera/view_cameras.h"
#include "tools/common/version.h"

namespace lentray::tool {
namespace {

using camera::Lenticular;
using camera::ViewCamera;
using core::Vec3;
using Json = nlohmann::ordered_json;

Json vector_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

/// Which views there are and how large their pictures are.
struct ViewSet {
  std::uint32_t count = 0;
  bool is_strips = false;  ///< a pixel a lens
  parser::PixelSize size{};
};

ViewSet views_of(const Lenticular& sheet, const CameraOptions& o) {
  if (o.views.quilt) return {o.views.quilt->views(), false, *o.views.size};
  if (o.views.count) {
    parser::PixelSize size = o.views.size.value_or(parser::PixelSize{o.width, o.height});
    if (o.views.size && o.is_on_its_side()) std::swap(size.width, size.height);
    return {*o.views.count, false, size};
  }
  return {camera::usual_views(sheet.sheet()), true, {0, sheet.height()}};
}

std::shared_ptr<const camera::Camera> camera_of(const Lenticular& sheet, const ViewSet& set,
                                                std::uint32_t view) {
  if (set.is_strips) return std::make_shared<camera::SheetView>(sheet, view);
  return camera::make_view(sheet, view, set.count, set.size.width, set.size.height);
}

/// A perspective's window seen from its eye: sides as slopes, angles, and the shift of the window
/// beside the line through the eye along the normal, in widths and heights of it.
void add_frustum(Json& out, const ViewCamera& camera) {
  const double width = core::length(camera.right), height = core::length(camera.up);
  const double ahead = dot(camera.towards, camera.normal);
  const double x = dot(camera.towards, camera.right) / width / ahead;
  const double y = dot(camera.towards, camera.up) / height / ahead;
  if (!camera.is_perspective) {
    out["slope"] = Json::array({x, y});
    return;
  }
  const double half_x = 0.5 * width / camera.distance, half_y = 0.5 * height / camera.distance;
  constexpr double kDegrees = 360.0 / std::numbers::pi;  // of half an angle
  out["frustum"] = {
      {"left", x - half_x}, {"right", x + half_x}, {"bottom", y - half_y}, {"top", y + half_y}};
  out["field_of_view_degrees"] =
      Json::array({kDegrees * std::atan(half_x), kDegrees * std::atan(half_y)});
  out["shift"] = Json::array({0.5 * x / half_x, 0.5 * y / half_y});
}

Json camera_json(const ViewCamera& camera) {
  const char* const kind = camera.is_perspective ? "perspective" : "orthographic";
  Json out{{"projection", kind},
           {"location", vector_json(camera.eye)},
           {"look_direction", vector_json(camera.normal)},
           {"right", vector_json(core::normalized(camera.right))},
           {"up", vector_json(core::normalized(camera.up))},
           {"distance", camera.distance},
           {"largest_miss", camera.miss},
           {"povray",
            {{"location", vector_json(camera.eye)},
             {"direction", vector_json(camera.towards)},
             {"right", vector_json(camera.right)},
             {"up", vector_json(camera.up)}}}};
  if (camera.start > 1e-12 * camera.distance) out["near"] = camera.start;
  add_frustum(out, camera);
  return out;
}

/// Upright again, of a sheet on its side.
void stand_up(Vec3& right, Vec3& up) {
  const Vec3 down = right;
  right = up;
  up = down * -1.0;
}

Json sheet_json(const CameraSetup& setup) {
  camera::SheetPlacement place = setup.sheet->placement();
  if (setup.is_on_its_side) {
    stand_up(place.right, place.up);
    std::swap(place.width, place.height);
  }
  return {{"centre", vector_json(place.centre)},
          {"normal", vector_json(place.normal)},
          {"right", vector_json(place.right)},
          {"up", vector_json(place.up)},
          {"width", place.width},
          {"height", place.height}};
}

Json quilt_json(const CameraOptions& o, const Lenticular& sheet) {
  const camera::SheetPlacement& place = sheet.placement();
  const parser::QuiltGrid& grid = *o.views.quilt;
  Json out{{"columns", grid.columns},
           {"rows", grid.rows},
           {"width", grid.columns * o.views.size->width},
           {"height", grid.rows * o.views.size->height},
           {"aspect", o.views.aspect.value_or(place.width / place.height)}};
  if (!o.views.count) {
    out["view_cone_degrees"] = o.views.cone.value_or(parser::kUsualViewCone);
  }
  return out;
}

/// Where camera `number`, the leftmost one 0, has its tile: from the lower left, and in pixels from
/// the upper left.
Json tile_json(const CameraOptions& o, std::uint32_t number) {
  const parser::QuiltGrid& grid = *o.views.quilt;
  const std::uint32_t column = number % grid.columns, row = number / grid.columns;
  return {{"column", column},
          {"row", row},
          {"left", column * o.views.size->width},
          {"top", (grid.rows - 1 - row) * o.views.size->height}};
}

}  // namespace

Json view_cameras(const CameraSetup& setup, const CameraOptions& o, const std::string& scene) {
  const Lenticular& sheet = *setup.sheet;
  const camera::SheetPlacement& place = sheet.placement();
  const ViewSet set = views_of(sheet, o);
  const bool is_left = dot(cross(place.right, place.up), place.normal) > 0.0;
  Json out{{"program", std::string("lentray ") + kVersion},
           {"scene", scene},
           {"units", "scene units"},
           {"handedness", is_left ? "left" : "right"},
           {"sheet", sheet_json(setup)}};
  if (o.views.quilt) out["quilt"] = quilt_json(o, sheet);
  Json cameras = Json::array();
  for (std::uint32_t number = 0; number < set.count; ++number) {
    const std::uint32_t view = set.count - 1 - number;
    const auto picture = camera_of(sheet, set, view);
    const double lenses = set.is_strips ? picture->width() : sheet.sheet().lenses();
    ViewCamera camera = camera::view_camera(sheet, *picture, lenses);
    Json one{{"number", number}, {"view", view}};
    one["size"] = Json::array({picture->width(), picture->height()});
    if (setup.is_on_its_side) {
      stand_up(camera.right, camera.up);
      one["size"] = Json::array({picture->height(), picture->width()});
    }
    if (o.views.quilt) one["tile"] = tile_json(o, number);
    if (camera.is_dark) {
      one["dark"] = true;
    } else {
      one.update(camera_json(camera));
    }
    cameras.push_back(std::move(one));
  }
  out["cameras"] = std::move(cameras);
  return out;
}

}  // namespace lentray::tool
