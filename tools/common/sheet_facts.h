// What lentray wrote of a lens sheet into a picture, and whether the picture is still the one it wrote that of.
// Errors: none. Pure.
#pragma once

#include <map>
#include <string>

#include "core/image/reader.h"

namespace lentray::tool {

/// By name: "lens.pixels". PNG and OpenEXR files have it as texts of their own, TIFF and JPEG files as lines of their
/// description.
using Facts = std::map<std::string, std::string>;
Facts facts_of(const core::StoredImage& image);
/// 0: it is not there, or no number.
double number_of(const Facts& facts, const std::string& name);

/// Whether a picture is all views of a lens sheet behind its lenses, and none of what is taken out of one.
bool is_integral(const Facts& facts);

/// Whether the lenses lie across the picture as it is seen. What else is said of its sheet is of the sheet on its side,
/// whose strips are columns: a quarter turn clockwise makes it upright.
bool lies_across(const Facts& facts);

/// Why the strips of an integral image no longer lie behind its lenses: it was made larger or smaller, cut or turned
/// since it was rendered. Empty: they do, or it is unknown.
std::string damage_of(const core::StoredImage& image, const Facts& facts, const std::string& name);
/// What else of such a picture is no longer what it says: it is not as high as it was. Upright strips survive that.
std::string height_change_of(const core::StoredImage& image, const Facts& facts,
                             const std::string& name);

}  // namespace lentray::tool
