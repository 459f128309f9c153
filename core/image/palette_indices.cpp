#include "core/image/palette_indices.h"

#include <gif_lib.h>
#include <png.h>

#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace lentray::core {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// libpng reports by a function that must not return.
[[noreturn]] void on_error(png_structp, png_const_charp message) { throw std::runtime_error(message); }
void on_warning(png_structp, png_const_charp) {}

struct PngReader {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, on_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  PngReader() = default;
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

PaletteIndices from_png(std::FILE* file) {
  PngReader reader;
  if (!reader.info) throw std::runtime_error("out of memory");
  png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_init_io(reader.png, file);
  png_read_info(reader.png, reader.info);
  if (png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_PALETTE) return {};
  png_set_packing(reader.png);  // a byte for each pixel of 1, 2 or 4 bits
  const int passes = png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  PaletteIndices read;
  read.width = png_get_image_width(reader.png, reader.info);
  read.height = png_get_image_height(reader.png, reader.info);
  read.entries.resize(std::size_t{read.width} * read.height);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::uint32_t row = 0; row < read.height; ++row) {
      png_read_row(reader.png, read.entries.data() + std::size_t{row} * read.width, nullptr);
    }
  }
  return read;
}

PaletteIndices from_gif(const std::filesystem::path& path) {
  int error = 0;
  const auto close = [](GifFileType* file) { DGifCloseFile(file, nullptr); };
  const std::unique_ptr<GifFileType, decltype(close)> gif(DGifOpenFileName(path.c_str(), &error), close);
  if (!gif || DGifSlurp(gif.get()) != GIF_OK || gif->ImageCount < 1) return {};
  const SavedImage& picture = gif->SavedImages[0];
  const GifImageDesc& place = picture.ImageDesc;
  PaletteIndices read{static_cast<std::uint32_t>(place.Width), static_cast<std::uint32_t>(place.Height), {}};
  read.entries.assign(picture.RasterBits, picture.RasterBits + std::size_t{read.width} * read.height);
  return read;
}

}  // namespace

PaletteIndices read_palette_indices(const std::filesystem::path& path) {
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rbe"));
  std::array<char, 6> head{};
  if (!file || std::fread(head.data(), 1, head.size(), file.get()) != head.size()) return {};
  const std::string_view begins(head.data(), head.size());
  try {
    if (begins.starts_with("GIF8")) return from_gif(path);
    std::rewind(file.get());
    if (begins.starts_with("\x89PNG")) return from_png(file.get());
  } catch (const std::runtime_error&) {
  }
  return {};
}

}  // namespace lentray::core
