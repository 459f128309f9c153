// What a scene or a command line asked of a lens sheet, and how it becomes LensParameters.
// Lengths in mm, front in scene units; what was not said stays empty.
// Errors: CameraError, worded for the user.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>

#include "camera/lens_sheet.h"

namespace lentray::camera {

/// A camera that cannot be had, and why.
class CameraError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct LensRequest {
  std::optional<double> pitch, lpi, focal_length, ior, pixels, print_dpi;
  std::optional<double> front;          ///< scene units before the sheet
  std::optional<double> view_distance;  ///< mm; 0 or infinite: the paper's camera
  std::optional<LensModel> model;
  std::optional<std::uint32_t> rays;  ///< K of the thick model

  /// What `other` says replaces what was said here; saying a pitch replaces a pitch given as lines
  /// an inch too, and N replaces a print resolution.
  void override_by(const LensRequest& other);
};

/// The eye of a camera that is made into a sheet: V follows from the scene instead of from mm.
struct EyeInScene {
  double distance = 0.0;     ///< to the sheet, scene units
  double sheet_width = 0.0;  ///< scene units
};

/// Pitch against LPI and N against DPI may both be given only if they agree.
/// `eye`: where V comes from when no view_distance was asked for (null: V is infinite then).
/// The model defaults to paraxial for a converted camera with finite V, to pinhole otherwise.
LensParameters resolve(const LensRequest& request, std::uint32_t width, const EyeInScene* eye);

}  // namespace lentray::camera
