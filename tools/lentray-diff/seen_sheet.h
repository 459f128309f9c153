// The lens sheets of two integral images that lentray-diff --seen compares: what files and the
// user's words say of them.
// Errors: core::ImageError, worded for the user. Pure.
#pragma once

#include <string>

#include "core/image/reader.h"
#include "tools/lentray-diff/eye_measure.h"
#include "tools/lentray-diff/seen_arguments.h"

namespace lentray::diff {

struct SeenSheet {
  LensRows lenses;
  EyeBeforePrint eye;
  double columns_an_inch = 0.0;
  double slant = 0.0;  ///< degrees
  bool is_across = false;
};

/// Throws where the sheet is not known, or the picture is none of a whole sheet. `image`: its
/// strips are columns; `name`, for messages: its file's.
SeenSheet seen_sheet_of(const core::StoredImage& image, const SeenArguments& arguments,
                        const std::string& name);

/// Why what is seen through two sheets cannot be compared: "15 and 15.02 pixels a lens"; empty: it
/// can.
std::string other_sheet(const SeenSheet& a, const SeenSheet& b);

}  // namespace lentray::diff
