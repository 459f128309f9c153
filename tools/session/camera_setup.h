// The camera of a picture: the scene's statement, and what is asked besides. World space.
// Errors: camera::CameraError. One thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "camera/camera.h"
#include "camera/conversion.h"
#include "camera/lenticular.h"
#include "camera/scene_probe.h"
#include "parser/compile/camera.h"
#include "parser/options/view_options.h"

namespace lentray::tool {

/// What is asked besides the scene's own statement. Lengths as camera::LensRequest has them.
struct CameraOptions {
  /// Pixels; of an integral image for a lens sheet, on its side as it is stored.
  std::uint32_t width = 160, height = 120;
  bool lenticular = false;  ///< a lens sheet is made of the scene's camera
  camera::LensRequest lens{};
  std::optional<double> sheet_distance{};  ///< scene units
  std::string sheet_at{};  ///< an object that the sheet is to stand at (camera::CompositionRequest)
  std::optional<camera::SceneDepths> depths{};  ///< of all of an animation
  std::optional<std::uint32_t> view{};          ///< that view of the sheet alone
  parser::ViewOptions views{};
  bool is_first_view =
      true;  ///< of pictures of one sheet; the first one's report describes the sheet
  bool is_animated = false;  ///< the sheet is made anew for every picture

  /// Whether there is a lens sheet whose lenses lie across the upright picture.
  bool is_on_its_side() const { return lenticular && lens.across.value_or(false); }
};

struct CameraSetup {
  std::unique_ptr<camera::Camera> ordinary;    ///< or
  std::shared_ptr<camera::Lenticular> sheet;   ///< a lens sheet, and perhaps
  std::shared_ptr<const camera::Camera> view;  ///< one view of it, or a quilt of them
  std::unique_ptr<camera::Camera> blurred;     ///< the sheet or its view with an aperture, or null
  std::optional<camera::SheetStand> stand{};   ///< of a sheet that was made of a camera
  std::shared_ptr<const camera::Composition> composed{};  ///< of a sheet with an eye of the scene's
  bool is_on_its_side = false;                            ///< the sheet: its lenses lie across
  std::vector<std::string> report, warnings;

  const camera::Camera& camera() const {
    if (blurred) return *blurred;
    if (view) return *view;
    if (sheet) return *sheet;
    return *ordinary;
  }
};

/// What is to be known of the camera, and how its sheet lies.
camera::Properties properties_of(const CameraSetup& setup);

CameraSetup make_camera(const parser::CameraRequest& request, const CameraOptions& options,
                        const camera::SceneProbe& probe);

/// Another view of a sheet that is there: no probe, no warnings, and a report of the view alone.
CameraSetup another_view(const CameraSetup& sheet, const parser::CameraRequest& request,
                         const CameraOptions& options);

}  // namespace lentray::tool
