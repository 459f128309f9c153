// The views of an integral image, taken apart: view j is what is seen through all lenses in the same direction, columns
// j, j + N, j + 2N ...; where N is fractional, the nearest column. View 0, at the left behind each lens, is what the eye
// farthest to the right sees.
// Errors: core::ImageError. Threads: any number.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/image/reader.h"

namespace lentray::batch {

/// Whole pixels a lens.
std::uint32_t view_count(double lens_pixels);
/// L x H pixels, L the whole lenses.
core::StoredImage view_of(const core::StoredImage& integral, double lens_pixels,
                          std::uint32_t view);

/// "a/b-views/view00.png" for the picture "a/b.png", ...
std::vector<std::string> view_names(const std::string& picture, double lens_pixels);
/// Writes them below `folder`. Says what went wrong on standard error, and returns an exit status.
int write_views(const std::filesystem::path& picture, double lens_pixels,
                const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace lentray::batch
