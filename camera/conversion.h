// Lens sheets out of camera statements: `camera { lenticular ... }` as it stands, or the camera an
// existing scene has (`Lenticular=On`), with the report that goes with it. World space.
// Errors: CameraError. One thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "camera/composition.h"
#include "camera/lens_request.h"
#include "camera/lenticular.h"
#include "camera/projection.h"
#include "camera/scene_probe.h"

namespace lentray::camera {

/// Where the sheet of a converted camera stands.
struct SheetStand {
  double distance = 0.0;  ///< Sheet_Distance: scene units along the camera's direction
  double along = 1.0;     ///< of the sheet's normal in a unit of that
  bool grows = false;     ///< the sheet's size is proportional to the distance
};

/// A sheet and what is to be said about it: report lines and warnings.
struct Sheet {
  std::unique_ptr<Lenticular> camera;
  std::vector<std::string> report;
  std::size_t scene_lines = 0;  ///< of the report, that it begins with: what is seen of the scene
  std::vector<std::string> warnings;
  std::optional<Composition> composed{};  ///< with an eye of the scene's
  /// Where it stands from a camera, and whether its size grows with that distance (perspective); empty
  /// for `lenticular` in a scene.
  std::optional<SheetStand> stand{};
};

/// `camera { lenticular }`: location is the sheet's middle, right and up its size. A direction
/// oblique to the sheet is that of the middle of the viewing zone. lens_front defaults to the
/// sheet's width, or to the eye where that is nearer.
Sheet sheet_of_statement(const Projection& projection, const LensRequest& request,
                         std::uint32_t width, std::uint32_t height, const SceneProbe& probe);

struct Conversion {
  LensRequest lens;
  std::optional<double> sheet_distance{};   ///< scene units along the camera's direction
  std::string sheet_at{};                   ///< of an object: CompositionRequest::sheet_at
  std::optional<SceneDepths> depths{};      ///< of all of an animation
  std::uint64_t survey_rays = kSurveyRays;  ///< of a survey, where one is made
  /// Pixels a view beyond which things jump: the budget of DepthMode::kPrint where none is asked for.
  double most_parallax = kMostParallax;
};

/// The sheet of an ordinary camera. `kind` is SDL's word: "perspective" and "orthographic" have a
/// sheet, all others are refused by name. Perspective: the sheet stands where it is asked to, or
/// at look_at, or at the median depth of what a coarse grid of rays meets; the eye becomes the
/// viewing distance, so the middle view is the scene's ordinary picture. Orthographic: the sheet
/// is the picture plane and V infinite. With DepthMode::kPrint or kScene the scene is seen by an eye of its
/// own, and the sheet is composed (camera/composition.h); kScene without a viewing distance is the same as without it.
Sheet sheet_of_camera(std::string_view kind, const Projection& projection,
                      const Conversion& conversion, std::uint32_t width, std::uint32_t height,
                      const SceneProbe& probe);

}  // namespace lentray::camera
