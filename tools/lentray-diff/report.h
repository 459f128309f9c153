// What a comparison shows: a table for the terminal, JSON, a heat map, and ours | stock |
// difference x 8 side by side. Pure functions; errors: none.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/image/compare.h"
#include "core/image/reader.h"

namespace lentray::diff {

/// The largest difference of each pixel as a colour: black 0, then blue, green, yellow, red,
/// white from 32/255 on.
core::StoredImage heat_map(const core::StoredImage& a, const core::StoredImage& b);

/// The same of differences without sign in any unit: blue 1, green 2, yellow 4, red 12, white from
/// 32 on. A pixel each, row 0 on top.
core::StoredImage heat_map(const std::vector<float>& differences, std::uint32_t width,
                           std::uint32_t height);

core::StoredImage side_by_side(const core::StoredImage& ours, const core::StoredImage& stock);

/// With lenses: the whole, all views, the worst lenses (or all). Without: one line.
std::string table(const core::LensComparison& result, bool all_lenses);

/// Keys: whole, views[], lenses[]; each pixels, largest, mean (1/255), beyond_1, beyond_2 (shares),
/// psnr, smooth_psnr (dB, null: equal), block_rms, bias (1/255), grade; where stock's noise counts, noise_rms and
/// noise_bias.
nlohmann::json to_json(const core::LensComparison& result);

}  // namespace lentray::diff
