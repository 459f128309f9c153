// How far a picture is from another one of its size, as viewers show both, at the bits of their files.
// Errors: core::ImageError for files that cannot be read, std::invalid_argument for other sizes.
// Threads: any number.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/image/reader.h"
#include "tools/lentray-chart/chart.h"

namespace lentray::chart {

/// As viewers show it.
core::StoredImage shown_picture(const std::filesystem::path& file);

/// Whether it is one that can be read.
bool is_picture(const std::filesystem::path& file);

/// All but `perceived` and `seen`.
Error error_of(const core::StoredImage& a, const core::StoredImage& b);

/// Eight times the difference of each channel, cut off at white; 8 bits.
core::StoredImage difference_of(const core::StoredImage& a, const core::StoredImage& b);

/// The 3-norm in what butteraugli_main prints; nothing where there is none.
std::optional<double> perceived_in(const std::string& output);

}  // namespace lentray::chart
