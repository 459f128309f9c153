// What a scene or a command line asked of a lens sheet, and how it becomes LensParameters.
// Lengths in mm, front in scene units; what was not said stays empty.
// Errors: CameraError, worded for the user. Pure; any number of threads.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "camera/lens_data.h"
#include "camera/lens_sheet.h"

namespace lentray::camera {

/// The part of a print pixel by which a lens model may differ from Snell's law and still be called
/// good enough, unless another is asked for.
inline constexpr double kModelTolerance = 0.25;

/// The size of the lens sheet that the picture's pixels were chosen for, mm.
struct SheetSize {
  double width = 0.0, height = 0.0;
  /// The print's rows an inch; empty: as many as there are columns an inch.
  std::optional<double> dpi_down{};
  /// The number of rows was asked for besides: they are as high as the sheet makes them.
  bool rows_fill_it = false;
};

/// Whose eye sees the scene through a sheet, and where the sheet stands in it. docs/depth.md.
enum class DepthMode {
  kPrint,  ///< the scene's; the sheet stands where it shows most, and depth is compressed until nothing jumps
  kScene,   ///< the scene's; depth is true
  kViewer,  ///< the viewer's; depth is true for things of the size of the print
};
const char* name_of(DepthMode mode);
/// Of a viewer who is not said to be elsewhere, where prints are composed (DepthMode::kPrint), mm.
inline constexpr double kUsualViewDistance = 400.0;

/// The most parallax that a visible point may have from one view to the next.
struct DepthBudget {
  double value = 0.0;
  bool is_mm = false;  ///< on the print; else pixels of a view, which are lens widths
};

struct LensRequest : LensData {
  /// Strips an inch of the print that fit the sheet from the viewing distance, as a pitch test finds
  /// them, instead of a pitch of the lenses.
  std::optional<double> print_lpi;
  std::optional<double> pixels, print_dpi;
  std::optional<double> slant;          ///< tan a of the lenses (LensParameters::slant)
  std::optional<double> front;          ///< scene units before the sheet
  std::optional<double> view_distance;  ///< mm; 0 or infinite: the paper's camera
  std::optional<LensModel> model;
  bool automatic_model = false;       ///< the cheapest one within the tolerance, instead of `model`
  std::optional<double> tolerance;    ///< of it, pixels of the print
  std::optional<std::uint32_t> rays;  ///< K of the thick model
  std::optional<SheetSize> size;
  std::optional<DepthBudget> depth_budget;
  std::optional<DepthMode> depth;  ///< empty: the viewer's
  std::string sheet_name;          ///< of the lens profile that data are from; empty: none
  /// The lenses lie across the upright picture. All else is then of the sheet turned by a quarter, its top to the left.
  std::optional<bool> across;
  bool sheet_is_nominal = false;  ///< that profile's data are computed, not measured

  /// What `other` says replaces what was said here; saying a pitch replaces a pitch given as lines
  /// an inch or as that of the print too, and N replaces a print resolution. Lens data:
  /// LensData::override_by().
  void override_by(const LensRequest& other);
  /// Data of a print were given: a size, a resolution, a measured pitch, or a sheet by its name.
  bool has_print_data() const { return size || print_dpi || print_lpi || !sheet_name.empty(); }
};

/// With the lenses' pitch P that print_lpi stands for, if it was said: P (1 + t/(nV)) is 25.4 mm over
/// print_lpi. The viewing distance V must be said too.
LensRequest with_lens_pitch(const LensRequest& request);

/// The eye of a camera that is made into a sheet: V follows from the scene instead of from mm.
struct EyeInScene {
  double distance = 0.0;     ///< to the sheet, scene units
  double sheet_width = 0.0;  ///< scene units
};

/// Pitch against LPI and N against DPI may both be given only if they agree.
/// `eye`: where V comes from when no view_distance was asked for (null: V is infinite then).
/// The model defaults to paraxial for a converted camera with finite V, to pinhole otherwise; an
/// automatic one is paraxial here.
LensParameters resolve(const LensRequest& request, std::uint32_t width, const EyeInScene* eye);

/// Columns and rows of the print of a sheet, not rounded. Where no view_distance is asked for, the
/// print is taken to be as large as the sheet.
struct ExactPixels {
  double columns = 0.0, rows = 0.0;
};
ExactPixels exact_pixels(const LensRequest& request, const SheetSize& size);

}  // namespace lentray::camera
