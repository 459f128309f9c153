// Stored pictures whose pixels are put elsewhere, and turned as they are shown. No sample is changed.
// Errors: NoRoom (core/base/memory_limit.h). Pure.
// Source: TIFF specification 6.0, Orientation; the tag of Exif is the same.
#pragma once

#include "core/image/reader.h"

namespace lentray::core {

/// Column x of the result is column `columns[x]` of the picture, and likewise rows.
StoredImage rearranged(const StoredImage& image, const std::vector<std::uint32_t>& columns,
                       const std::vector<std::uint32_t>& rows);

constexpr int kMirrored = 2;
constexpr int kTurned = 6;      ///< a quarter turn clockwise
constexpr int kTurnedBack = 8;  ///< and the other way round
/// `orientation` 1 to 8: what the stored row 0 and column 0 are to the eye; 5 to 8 exchange width and height.
/// Resolutions among the attributes are turned along.
StoredImage upright(StoredImage image, int orientation);

}  // namespace lentray::core
