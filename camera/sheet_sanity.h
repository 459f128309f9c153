// What is odd about a sheet's data, before anybody prints it: sizes and numbers that a slip of a unit or of an option
// makes. Each line says what to do. Lengths in mm. Errors: none. Pure; any number of threads.
#pragma once

#include <string>
#include <vector>

#include "camera/lens_request.h"
#include "camera/lens_sheet.h"

namespace lentray::camera {

/// Empty where nothing of a print was asked for: its size, resolution or strips an inch, or a sheet by name.
/// `height` 0: not known.
std::vector<std::string> sheet_sanity(const LensParameters& lens, const LensRequest& asked,
                                      double width, double height);

/// How a lens gets so many pixels: "at least 360 dpi, or at most 100 lpi".
std::string resolution_for(const LensParameters& lens, double pixels);

}  // namespace lentray::camera
