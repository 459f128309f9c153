// What stock POV-Ray cannot antialias itself, as the mean of what it can render:
//   antialiased mesh_camera   n x n samples over each pixel's area (StockOptions::samples), for a
//                             mesh_camera has one ray a pixel, with or without antialiasing
//   Antialias_Angle=m         the views, or samples, of a sheet with m columns a pixel
// Errors: std::runtime_error. Threads: any number, each with a workshop of its own.
#pragma once

#include <optional>

#include "tools/lentray-diff/stock.h"
#include "tools/lentray-diff/workshop.h"

namespace lentray::diff {

/// How many places of a pixel the reference is the mean of; 1: stock's picture as it is.
int samples_a_pixel(Way way, const StockOptions& options);

/// The integral image; with `only`, that view of it and the others black.
core::StoredImage mean_of_views(Workshop& shop, const Sheet& sheet, Way way,
                                const StockOptions& options,
                                std::optional<std::uint32_t> only = std::nullopt);
core::StoredImage mean_of_samples(Workshop& shop, const Sheet& sheet, const StockOptions& options);

/// All lenses show a view alike when V is infinite: then it is dark as a whole or not at all.
bool is_dark(const Sheet& sheet, std::uint32_t view, Way way);

/// Image row k >= 1 of POV-Ray 3.7 shows row k - 1 of a mesh_camera; later ones are right.
bool mesh_rows_lag(const StockOptions& options);
/// Of mesh_scene() with so many offsets.
Shot mesh_shot(const Sheet& sheet, std::size_t offsets, bool lag);

/// The places of n x n samples and m turns, in lists for one mesh_camera each: all of a list are
/// equally far down, and have `most_columns` columns together unless it is a single one.
std::vector<std::vector<PixelOffset>> sample_places(const Sheet& sheet, int n, int m,
                                                    std::uint32_t most_columns);

}  // namespace lentray::diff
