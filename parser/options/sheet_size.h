// The picture's columns and rows from the size of the lens sheet it is for.
// Errors: OptionError. Any number of threads, each with options of its own.
#pragma once

#include "parser/options/options.h"

namespace lentray::parser {

/// Sheet_Width and Sheet_Height with Print_DPI, or with Lens_Pixels, give Width and Height, and
/// these with the size give the pixels a lens. Whatever is said twice must agree to a pixel.
/// Without a sheet's size nothing changes.
void fit_picture_to_sheet(RenderOptions& options);

}  // namespace lentray::parser
