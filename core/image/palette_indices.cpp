#include "core/image/palette_indices.h"

#include <png.h>

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "core/image/gif_picture.h"
#include "core/image/open_file.h"
#include "core/image/palette_bitmaps.h"
#include "core/image/palette_tiff.h"
#include "core/image/png_errors.h"

namespace lentray::core {
namespace {

using Entries = std::vector<std::uint8_t>;

struct PngReader {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, png_fails, png_warns);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  PngReader() = default;
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

Entries from_png(std::FILE* file, const StoredImage& stored) {
  PngReader reader;
  if (!reader.info) throw std::runtime_error("out of memory");
  png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_init_io(reader.png, file);
  png_read_info(reader.png, reader.info);
  if (png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_PALETTE) return {};
  if (png_get_image_width(reader.png, reader.info) != stored.width) return {};
  if (png_get_image_height(reader.png, reader.info) != stored.height) return {};
  png_set_packing(reader.png);  // a byte for each pixel of 1, 2 or 4 bits
  const int passes = png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  Entries entries(std::size_t{stored.width} * stored.height);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::uint32_t row = 0; row < stored.height; ++row) {
      png_read_row(reader.png, entries.data() + std::size_t{row} * stored.width, nullptr);
    }
  }
  return entries;
}

Entries from_gif(std::FILE* file, const StoredImage& stored) {
  GifPicture picture = read_gif_picture(file);
  if (picture.width != stored.width || picture.height != stored.height) return {};
  return std::move(picture.entries);
}

std::string all_of(std::FILE* file) {
  std::string bytes;
  std::array<char, 1 << 16> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), file)) bytes.append(part.data(), size);
  return bytes;
}

}  // namespace

Entries palette_entries(const StoredImage& stored, const std::filesystem::path& path, bool is_targa) {
  const OpenFile file(std::fopen(path.c_str(), "rbe"));
  std::array<char, 6> head{};
  if (!file || std::fread(head.data(), 1, head.size(), file.get()) != head.size()) return {};
  const std::string_view begins(head.data(), head.size());
  std::rewind(file.get());
  try {
    if (begins.starts_with("GIF8")) return from_gif(file.get(), stored);
    if (begins.starts_with("\x89PNG")) return from_png(file.get(), stored);
    if (begins.starts_with("BM")) return bitmap_entries(all_of(file.get()), stored.width, stored.height);
    if (begins.starts_with("II*") || begins.starts_with(std::string_view("MM\0*", 4))) {
      return tiff_entries(all_of(file.get()), stored.width, stored.height);
    }
    if (is_targa) return targa_entries(all_of(file.get()), stored.width, stored.height);
  } catch (const std::runtime_error&) {
  }
  return {};
}

}  // namespace lentray::core
