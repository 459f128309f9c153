#include <gif_lib.h>

#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#include "core/image/format_readers.h"

namespace lentray::core {
namespace {

struct CloseGif {
  void operator()(GifFileType* gif) const { DGifCloseFile(gif, nullptr); }
};
using Gif = std::unique_ptr<GifFileType, CloseGif>;

int read_bytes(GifFileType* gif, GifByteType* to, int size) {
  return static_cast<int>(
      std::fread(to, 1, static_cast<std::size_t>(size), static_cast<std::FILE*>(gif->UserData)));
}

[[noreturn]] void fail_to_read_gif(int error) {
  const char* why = GifErrorString(error);
  throw std::runtime_error(why ? why : "it is no GIF file");
}
void check(const Gif& gif, int status) {
  if (status != GIF_OK) fail_to_read_gif(gif->Error);
}

/// Passes over the blocks before the first picture. The transparent entry, or NO_TRANSPARENT_COLOR.
int read_extensions(const Gif& gif) {
  GifRecordType record = UNDEFINED_RECORD_TYPE;
  int clear = NO_TRANSPARENT_COLOR;
  for (;;) {
    check(gif, DGifGetRecordType(gif.get(), &record));
    if (record == IMAGE_DESC_RECORD_TYPE) return clear;
    if (record != EXTENSION_RECORD_TYPE) throw std::runtime_error("the file has no picture");
    int code = 0;
    GifByteType* block = nullptr;
    check(gif, DGifGetExtension(gif.get(), &code, &block));
    while (block) {
      GraphicsControlBlock control;
      if (code == GRAPHICS_EXT_FUNC_CODE &&
          DGifExtensionToGCB(block[0], block + 1, &control) == GIF_OK) {
        clear = control.TransparentColor;
      }
      check(gif, DGifGetExtensionNext(gif.get(), &block));
    }
  }
}

/// Rows of an interlaced picture come in four passes.
void read_lines(const Gif& gif, StoredImage& image) {
  struct Pass {
    std::uint32_t first, step;
  };
  constexpr std::array<Pass, 4> kPasses{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
  const auto line = [&](std::uint32_t row) {
    GifPixelType* to = image.entries.data() + std::size_t{row} * image.width;
    check(gif, DGifGetLine(gif.get(), to, static_cast<int>(image.width)));
  };
  if (!gif->Image.Interlace) {
    for (std::uint32_t row = 0; row < image.height; ++row) line(row);
    return;
  }
  for (const Pass& pass : kPasses) {
    for (std::uint32_t row = pass.first; row < image.height; row += pass.step) line(row);
  }
}

}  // namespace

StoredImage read_gif(std::FILE* file) {
  int error = 0;
  const Gif gif(DGifOpen(file, read_bytes, &error));
  if (!gif) fail_to_read_gif(error);
  const int clear = read_extensions(gif);
  check(gif, DGifGetImageDesc(gif.get()));
  if (gif->Image.Width < 1 || gif->Image.Height < 1)
    throw std::runtime_error("the picture is empty");
  StoredImage image;
  image.width = static_cast<std::uint32_t>(gif->Image.Width);
  image.height = static_cast<std::uint32_t>(gif->Image.Height);
  image.channels = 4;
  check_picture_room(image.width, image.height, 5, 1);
  image.entries.resize(std::size_t{image.width} * image.height);
  read_lines(gif, image);
  const ColorMapObject* colours = gif->Image.ColorMap ? gif->Image.ColorMap : gif->SColorMap;
  Palette palette{};  // what lies beyond it is black
  for (int i = 0; i < 256; ++i) {
    std::uint8_t* entry = palette.data() + 4 * i;
    if (colours && i < colours->ColorCount) {
      entry[0] = colours->Colors[i].Red;
      entry[1] = colours->Colors[i].Green;
      entry[2] = colours->Colors[i].Blue;
    }
    entry[3] = i == clear ? 0 : 255;
  }
  fill_from_palette(image, palette);
  return image;
}

}  // namespace lentray::core
