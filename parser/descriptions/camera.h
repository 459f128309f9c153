// A camera statement, read: vectors as stock computes them, after look_at, angle and transforms.
// World space. A converter needs no more than this: kind, the four vectors, look_at distance.
// Source: reference manual 3.7, "Camera"; order of operations and defaults measured on stock
// (tests/unit/parser/grammar_camera_test.cpp).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "camera/lens_sheet.h"
#include "core/base/transform.h"
#include "core/base/vec3.h"
#include "parser/source/source.h"
#include "parser/values/value.h"

namespace lentray::parser {

enum class CameraKind {
  kPerspective,
  kOrthographic,
  kFisheye,
  kUltraWideAngle,
  kOmnimax,
  kPanoramic,
  kSpherical,
  kCylinder,  ///< cylinder_type 1..4
  kMesh,
  kUserDefined,
  kLenticular,  ///< this program's own: a lens sheet
};

/// The SDL word of a kind ("ultra_wide_angle").
const char* camera_kind_name(CameraKind kind);

using camera::LensModel;

/// The words that `camera { lenticular ... }` adds; unset ones stay empty so that the converter
/// knows what the scene said. Lengths in mm except lens_front, which is in scene units.
struct LensDesc {
  std::optional<double> pitch, lpi, focal_length, ior, pixels, print_dpi;
  std::optional<double> front;          ///< scene units before the sheet
  std::optional<double> view_distance;  ///< mm; 0: infinity
  std::optional<LensModel> model;
  std::optional<int> rays;      ///< of the thick model
  std::optional<double> slant;  ///< degrees
};

struct CameraDesc {
  Location where;
  CameraKind kind = CameraKind::kPerspective;
  int cylinder_type = 0;  ///< 1..4 for kCylinder

  // Final: look_at, angle, orthographic resizing and all transforms are in here.
  core::Vec3 location{0.0, 0.0, 0.0};
  core::Vec3 direction{0.0, 0.0, 1.0};  ///< its length matters: distance of the picture plane
  core::Vec3 right{1.33, 0.0, 0.0};
  core::Vec3 up{0.0, 1.0, 0.0};
  core::Vec3 sky{0.0, 1.0, 0.0};      ///< as written: transforms do not touch it
  core::Vec3 look_at{0.0, 0.0, 1.0};  ///< after transforms; meaningful if has_look_at
  bool has_look_at = false;
  bool has_right = false, has_up = false, has_angle = false;  ///< the scene wrote them
  /// Distance from location to look_at after transforms; 0 without look_at. The sheet of a
  /// converted camera stands there by default.
  double look_at_distance() const { return has_look_at ? core::length(look_at - location) : 0.0; }

  double angle = 90.0;  ///< degrees, as written; used by the wide kinds
  double horizontal_angle = 360.0, vertical_angle = 180.0;  ///< spherical
  core::Transform transform;  ///< everything applied to the vectors above, for copies

  LensDesc lens;  ///< of kLenticular

  // Focal blur: there is some where both aperture and blur_samples are not 0.
  double aperture = 0.0;                       ///< scene units; the disc is half as wide
  int blur_samples = 0, blur_samples_min = 0;  ///< at most, at least
  double confidence = 0.9, variance = 1.0 / 10000.0;
  core::Vec3 focal_point{0.0, 0.0, 1.0};
  bool has_focal_point = false;
  double focal_distance = -1.0;  ///< from location, along direction
  Ref<PigmentDesc> bokeh;

  Ref<NormalDesc> normal;
  // mesh_camera
  int rays_per_pixel = 1, distribution = 0;
  double max_ray_distance = 0.0;
  bool smooth = false;
  std::vector<Ref<ObjectDesc>> meshes;
  // user_defined: three functions each, null where the scene gives a constant vector
  std::array<Ref<FunctionDesc>, 3> location_functions, direction_functions;
};

}  // namespace lentray::parser
