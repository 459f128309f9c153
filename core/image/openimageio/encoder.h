// TIFF, OpenEXR, JPEG and whatever else OpenImageIO writes. See core/image/picture_encoder.h.
#pragma once

#include "core/image/picture_encoder.h"

namespace lentray::core {

std::unique_ptr<PictureEncoder> make_openimageio_encoder(const std::filesystem::path& path,
                                                         const PictureSpec& spec);

}  // namespace lentray::core
