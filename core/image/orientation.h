// Stored pictures turned as they are shown. Errors: NoRoom (core/base/memory_limit.h). Pure.
// Source: TIFF specification 6.0, Orientation; the tag of Exif is the same.
#pragma once

#include "core/image/reader.h"

namespace lentray::core {

/// `orientation` 1 to 8: what the stored row 0 and column 0 are to the eye; 5 to 8 exchange width and height. Samples
/// are moved, never changed. Resolutions among the attributes are turned along.
StoredImage upright(StoredImage image, int orientation);

}  // namespace lentray::core
