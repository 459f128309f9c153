// Chunks of PNG files, from the heads of the file alone. Errors: none, files that cannot be read have no
// chunks. Threads: any number. Source: the format of PNG; compared with stock by tests/image/picture_gamma_test.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>
#include <string_view>

namespace lentray::core {

/// Length of the first chunk of that name before the pixels; the file then stands at its contents.
std::optional<std::uint32_t> find_png_chunk(std::istream& file, std::string_view name);

/// What the file says of its values: the power that makes them linear, less than 0 for sRGB's curve;
/// 0 if it says nothing.
double png_gamma(const std::filesystem::path& path);

}  // namespace lentray::core
