// The pixels of an integral image for a page: a picture for each place behind the lenses, within so many bytes.
// Errors: core::ImageError, worded for the user. Threads: any number.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "camera/lens_sheet.h"
#include "core/image/reader.h"

namespace lentray::views {

struct PageStrips {
  std::vector<std::string> links;  ///< data URLs; strip j has the j-th column behind each lens
  std::uint32_t rows = 0;  ///< of each; fewer than the picture's where `limit` asks for that
  int quality = 0;         ///< of JPEG; 0: pixels as they are
};

/// `limit`: bytes of all links together.
PageStrips page_strips(const core::StoredImage& integral, const camera::LensSheet& sheet,
                       std::size_t limit);

}  // namespace lentray::views
