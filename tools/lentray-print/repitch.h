// An integral image for lenses of another pitch, made of the views that it has: for measured pitches that are a little
// off. A new render is exact; this is not.
// Units: pixels of the print. Errors: core::NoRoom, PageError. Pure.
#pragma once

#include <cstdint>
#include <string>

#include "core/image/reader.h"
#include "tools/lentray-print/lens_data.h"

namespace lentray::print {

struct Repitched {
  core::StoredImage image;
  double pixels = 0.0;  ///< N of the result
  /// How far the direction of a result's pixel is from the nearest that the picture has, at most, in its pixels.
  double largest_offset = 0.0;
  /// Of the interpolation beside a new render: if colours change smoothly from view to view, and if they change in
  /// steps. Estimated by how well each pixel follows from its neighbours behind the same lens. Infinite: no error.
  double smooth_psnr = 0.0, step_psnr = 0.0;
};

/// `image`: whole lenses of `from` pixels. Each lens keeps its strip, which gets `to` pixels: a pixel is the linear
/// mean of the two whose places under the lens are nearest, of the same lens.
Repitched repitched(const core::StoredImage& image, double from, double to);

/// The options of lentray that render a picture of `width` x `height` pixels whose strips have that pitch, for the lens
/// that the data tell of; empty if they tell of none. `lenses`: of the picture, the cut one by its share.
std::string render_options(const LensData& data, double print_pitch, double lenses,
                           std::uint32_t height);

}  // namespace lentray::print
