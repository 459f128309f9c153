// TIFF, OpenEXR, JPEG and whatever else OpenImageIO writes. See core/image/picture_encoder.h.
#pragma once

#include "core/image/picture_encoder.h"

namespace lentray::core {

MakeEncoder make_openimageio_encoder;

}  // namespace lentray::core
