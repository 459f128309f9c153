// The views of a quilt, the leftmost camera's lower left, from there to the right and upwards. Its grid is what its file
// says, or the end of its name, as displays read it: name_qs8x6a0.75.png.
// Errors: core::ImageError, worded for the user. One thread.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "tools/lentray-views/source.h"

namespace lentray::views {

struct QuiltTiles {
  std::uint32_t columns = 0, rows = 0;
  double aspect = 0.0;  ///< of a tile as it is looked at, width by height; 0: unknown
};

/// Empty: the picture is no quilt.
std::optional<QuiltTiles> quilt_tiles(const std::filesystem::path& path, const Facts& facts);

/// `arguments` must outlive it.
std::unique_ptr<Source> quilt_source(const Arguments& arguments, core::StoredImage quilt,
                                     const QuiltTiles& tiles);

}  // namespace lentray::views
