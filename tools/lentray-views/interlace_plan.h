// What ready pictures become an integral image of: pixels, the lens sheet as its file says it, and how it moves.
// Errors: core::ImageError and parser::OptionError, worded for the user. One thread.
#pragma once

#include <string>
#include <vector>

#include "tools/common/photo_reader.h"
#include "tools/lentray-views/arguments.h"
#include "tools/lentray-views/interlace.h"
#include "tools/lentray-views/picture.h"

namespace lentray::views {

struct PlannedSheet {
  InterlacePlan plan;
  About about;
  std::vector<std::string> lines;  ///< of the report
  bool is_across = false;  ///< the plan is of the sheet on its side, whose strips are columns
};

/// The sheet of --like; or that of the lens data, which lentray's own rules make of them; or what --lens-pixels and
/// --size say alone.
PlannedSheet planned_sheet(const Arguments& arguments, tool::PhotoReader& reader);

/// Warns where the first picture has another shape than the sheet that it is to fill.
void warn_of_stretch(const Arguments& arguments, const PlannedSheet& sheet,
                     tool::PhotoReader& reader);

/// In which order an eye sees the pictures.
std::string motion_line(const Arguments& arguments, bool is_across);

/// Refuses a picture whose strips would be torn apart.
void check_no_integral(const core::StoredImage& picture, const std::string& name);

/// Reads back as the same number.
std::string exact(double value);

}  // namespace lentray::views
