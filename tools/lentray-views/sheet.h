// The lens sheet that an integral image is printed for: what its file says of it, or what the user
// does. Lengths in mm. Errors: core::ImageError, worded for the user. Threads: any number.
#pragma once

#include <optional>
#include <string>

#include "camera/lens_sheet.h"
#include "camera/slanted_sheet.h"
#include "tools/lentray-views/picture.h"

namespace lentray::views {

/// What a user says of a sheet; it goes before what the file says.
struct SheetOptions {
  std::optional<double> pixels, pitch, focal_length, ior, view_distance;  ///< V: 0 is infinite
  std::optional<camera::LensModel> model;
  std::optional<double> slant;   ///< its tangent
  std::optional<double> aspect;  ///< width of the sheet by its height
  bool across = false;           ///< lenses lie across the upright picture
};

struct Sheet {
  camera::LensSheet lenses;
  std::string missing;  ///< of the optics, as the options that would say it; empty: all is known
  double aspect = 0.0;  ///< width of the sheet by its height; 0: unknown
  std::optional<camera::SlantedSheet> slanted{};  ///< where its lenses are
};

/// The aspect that is said, of the sheet as its strips are columns.
std::optional<double> said_aspect(const SheetOptions& options);

/// Where the lenses of a picture of that size are, if they are slanted. `aspect`: the sheet's width by its
/// height; 0: pixels are square.
std::optional<camera::SlantedSheet> slanted_sheet(const camera::LensParameters& lens,
                                                  std::uint32_t columns, std::uint32_t rows,
                                                  double aspect, double eye_slope_x = 0.0,
                                                  double eye_slope_y = 0.0);

/// `name` is the file's, for messages. Throws where N is not known, is beyond the picture's width,
/// or where the picture is a view or a quilt by its own words, or was resized or cropped and no option gives N.
Sheet sheet_of(const core::StoredImage& image, const SheetOptions& options,
               const std::string& name);

/// Throws if the optics of the sheet are not known.
void need_optics(const Sheet& sheet, const std::string& name);
/// Width by height. Throws if it is not known.
double need_aspect(const Sheet& sheet, const std::string& name);

}  // namespace lentray::views
