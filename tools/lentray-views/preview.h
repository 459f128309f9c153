// An integral image as an HTML page that holds everything it needs and works from a file: the sheet as eyes see it, from
// any angle and distance.
//
// What an eye sees is computed in the page by the same formula, and in the same order, as seen_by() (strips.h) does.
// The picture goes in as strips: strip j has the j-th column behind each lens, so that neighbours are alike and pack
// well. Where pixels as they are take more than the page may have they become JPEG, and then fewer rows; columns never
// change. Transparent parts stand before black. Lengths in mm, angles in degrees, sizes in bytes.
// Errors: core::ImageError, worded for the user. Threads: any number.
#pragma once

#include <string>

#include "tools/lentray-views/arguments.h"
#include "tools/lentray-views/source.h"

namespace lentray::views {

struct Preview {
  std::string page;
  std::string told;  ///< what it has become, in a line
};

/// Of the arguments: `eye` for the beginning, `eyes` and `page_limit`.
Preview preview_of(const Integral& integral, const Arguments& arguments);

}  // namespace lentray::views
