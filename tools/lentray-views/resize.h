// Pictures in another size: separable filters, in linear light, premultiplied by alpha.
// Errors: none. Threads: any number. Source: box and triangle as usual; Mitchell and Netravali,
// "Reconstruction Filters in Computer Graphics", SIGGRAPH 1988, B = C = 1/3; Lanczos' sinc window
// of three lobes.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/image/reader.h"

namespace lentray::views {

enum class Filter { kBox, kTriangle, kMitchell, kLanczos3 };
std::optional<Filter> filter_named(std::string_view name);
/// "box, triangle, mitchell, lanczos3".
inline constexpr std::string_view kFilterNames = "box, triangle, mitchell, lanczos3";

/// The picture in width x height pixels. `span`: the columns over which the picture is spread, if
/// the last one lies beyond its edge in part; 0: width. Where nothing changes, the samples stay the
/// same.
core::StoredImage resized(const core::StoredImage& image, std::uint32_t width, std::uint32_t height,
                          Filter filter, double span = 0.0);

}  // namespace lentray::views
