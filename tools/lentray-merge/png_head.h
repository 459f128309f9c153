// What a PNG file that lentray wrote says before its pixels: size, kind of samples, gamma, resolution, texts.
// Errors: core::ImageError with the path and the reason: no PNG file, or one that lentray does not write.
// Threads: any number. Source: the format of PNG; core/image/png_encoder.cpp writes such files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/image/picture_encoder.h"
#include "tools/lentray-merge/rows.h"

namespace lentray::merge {

struct PngHead {
  struct Chunk {
    std::string type, data;
    bool operator==(const Chunk&) const = default;
  };
  std::vector<Chunk> chunks;  ///< in the file's order, without the text of `rows`
  std::optional<Rows> rows;   ///< those that the file says it has, "lentray:rows"
};

PngHead read_head(const std::filesystem::path& path);
/// What makes core::make_png_encoder() write the same head.
core::PictureSpec spec_of(const PngHead& head, const std::filesystem::path& path);
/// In what they differ, for a message: "size: 320 x 240 and 320 x 200". Empty: in nothing.
std::string difference(const PngHead& a, const PngHead& b);

}  // namespace lentray::merge
