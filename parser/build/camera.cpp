#include "parser/build/camera.h"

namespace lentray::parser {
namespace {

camera::LensModel model_of(LensModel model) {
  switch (model) {
    case LensModel::kParaxial: return camera::LensModel::kParaxial;
    case LensModel::kPinhole: return camera::LensModel::kPinhole;
    case LensModel::kThick: break;
  }
  throw camera::CameraError("lens_model thick: not yet (there are paraxial and pinhole)");
}

}  // namespace

CameraRequest camera_request(const CameraDesc& camera) {
  CameraRequest request;
  request.kind = camera_kind_name(camera.kind);
  request.projection = {camera.location, camera.direction, camera.right, camera.up, std::nullopt};
  if (camera.has_look_at) request.projection.look_at_distance = camera.look_at_distance();
  request.cylinder_type = camera.cylinder_type;
  request.angles = {camera.angle, camera.horizontal_angle, camera.vertical_angle};
  if (camera.kind != CameraKind::kLenticular) return request;
  const LensDesc& lens = camera.lens;
  request.lens.pitch = lens.pitch;
  request.lens.lpi = lens.lpi;
  request.lens.focal_length = lens.focal_length;
  request.lens.ior = lens.ior;
  request.lens.pixels = lens.pixels;
  request.lens.print_dpi = lens.print_dpi;
  request.lens.front = lens.front;
  request.lens.view_distance = lens.view_distance;
  if (lens.model) request.lens.model = model_of(*lens.model);
  return request;
}

}  // namespace lentray::parser
