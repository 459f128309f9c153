// An integral image for lenses of another pitch, made of the views that it has: for measured pitches that are a little
// off. A new render is exact; this is not.
// Units: pixels of the print. Errors: core::NoRoom, PageError. Pure.
#pragma once

#include <cstdint>
#include <string>

#include "core/image/reader.h"
#include "core/numeric/lens_columns.h"
#include "tools/lentray-print/lens_data.h"

namespace lentray::print {

struct Repitched {
  core::StoredImage image;
  /// How far the direction of a result's pixel is from the nearest that the picture has, at most, in its pixels.
  double largest_offset = 0.0;
  /// Of the interpolation beside a new render: if colours change smoothly from view to view, and if they change in
  /// steps. Estimated by how well each pixel follows from its neighbours behind the same lens. Infinite: no error.
  double smooth_psnr = 0.0, step_psnr = 0.0;
};

/// `image`: whole lenses of `from` pixels, the first of which begin with lens 0. Each lens keeps its strip, which gets
/// the columns that `to` has for it: a pixel is the linear mean of the two whose places under the lens are nearest, of
/// the same lens. Lens 0 begins at column 0, so to.origin is above -1/2 and 1/2 at most.
Repitched repitched(const core::StoredImage& image, double from, const core::LensColumns& to);

/// The options of lentray that render a picture of `width` x `height` pixels whose strips have that pitch, for the lens
/// that the data name; empty if they name none. `lenses`: of the picture, the cut one by its share.
/// `is_across`: they lie across, and the height is that of the sheet on its side.
std::string render_options(const LensData& data, double print_pitch, double lenses,
                           std::uint32_t height, bool is_across);

}  // namespace lentray::print
