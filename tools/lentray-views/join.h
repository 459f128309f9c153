// Views put together into one picture: quilts, pairs side by side, anaglyphs.
// Errors: core::ImageError, worded for the user. Threads: any number; all functions are pure.
// Source of the anaglyph's matrices: E. Dubois, "Conversion of a Stereo Pair to Anaglyph with the
// Least-Squares Projection Method", 2009 (site.uottawa.ca/~edubois/anaglyph), for red and cyan.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/image/reader.h"

namespace lentray::views {

/// Throws unless both have one size and kind.
void check_alike(const core::StoredImage& a, const core::StoredImage& b);

/// Of that many columns: the first view lower left, from there to the right and upwards. All views
/// have one size and kind.
core::StoredImage quilt_of(const std::vector<core::StoredImage>& views, std::uint32_t columns);
/// "_qs8x6a0.75": what Looking Glass displays look for at the end of a quilt's name.
std::string quilt_suffix(std::uint32_t columns, std::uint32_t rows, double aspect);

/// The left eye's picture on the left.
core::StoredImage side_by_side(const core::StoredImage& left, const core::StoredImage& right);

enum class Anaglyph {
  kDubois,  ///< red and cyan with the least error of colour, by a matrix in linear light
  kPlain,   ///< the left eye's red, the right eye's green and blue
};
using ColourMatrix = std::array<std::array<float, 3>, 3>;
/// What an eye's red, green and blue add to those of the anaglyph, in linear light.
const ColourMatrix& matrix_of(Anaglyph way, bool is_left);
/// RGB; what is below or above the samples' range is cut.
core::StoredImage anaglyph(const core::StoredImage& left, const core::StoredImage& right,
                           Anaglyph way);

}  // namespace lentray::views
