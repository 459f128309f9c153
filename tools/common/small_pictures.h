// Pictures of limited size for pages: how large they become, and their JPEG in no more than so many bytes.
// Sizes in pixels and bytes. Errors: those of core/image/thumbnail.h. Threads: any number; all functions are pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/image/thumbnail.h"

namespace lentray::tool {

/// As large as fits into a square of `side`, at most what the picture has; `across`: columns it has, of the view if it
/// is one.
core::ThumbnailSize size_within(std::uint32_t width, std::uint32_t height, std::uint32_t across,
                                std::uint32_t side);

/// `bytes`, or less where a JPEG of that many pixels looks well with less.
std::size_t bytes_within(std::size_t bytes, std::size_t pixels);

/// Coarser where it must be, from quality `best` on, until it has the size that is allowed; at last nothing.
std::string jpeg_within(const core::Thumbnail& thumbnail, std::size_t most, int best = 84);

/// Bytes in base64, with what JSON puts around it.
std::size_t bytes_in_page(std::size_t bytes);

}  // namespace lentray::tool
