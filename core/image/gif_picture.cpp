#include "core/image/gif_picture.h"

#include <gif_lib.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "core/image/open_file.h"

namespace lentray::core {
namespace {

int read_bytes(GifFileType* gif, GifByteType* to, int size) {
  return static_cast<int>(std::fread(to, 1, static_cast<std::size_t>(size), static_cast<std::FILE*>(gif->UserData)));
}

}  // namespace

GifPicture read_gif_picture(std::FILE* file) {
  int error = 0;
  const auto close = [](GifFileType* gif) { DGifCloseFile(gif, nullptr); };
  const std::unique_ptr<GifFileType, decltype(close)> gif(DGifOpen(file, read_bytes, &error), close);
  if (!gif || DGifSlurp(gif.get()) != GIF_OK || gif->ImageCount < 1) return {};
  const SavedImage& first = gif->SavedImages[0];
  GifPicture picture;
  picture.width = static_cast<std::uint32_t>(first.ImageDesc.Width);
  picture.height = static_cast<std::uint32_t>(first.ImageDesc.Height);
  picture.entries.assign(first.RasterBits, first.RasterBits + std::size_t{picture.width} * picture.height);
  const ColorMapObject* colours = first.ImageDesc.ColorMap ? first.ImageDesc.ColorMap : gif->SColorMap;
  for (int i = 0; colours && i < colours->ColorCount; ++i) {
    const GifColorType& c = colours->Colors[i];
    picture.palette.push_back({c.Red, c.Green, c.Blue});
  }
  return picture;
}

void restore_clear_colours(StoredImage& image, const std::filesystem::path& path) {
  constexpr std::size_t kChannels = 4;
  const OpenFile file(std::fopen(path.c_str(), "rbe"));
  std::array<char, 4> head{};
  if (image.channels != kChannels || !file || std::fread(head.data(), 1, head.size(), file.get()) != head.size()) return;
  if (std::string_view(head.data(), head.size()) != "GIF8") return;
  std::rewind(file.get());
  const GifPicture gif = read_gif_picture(file.get());
  if (gif.width != image.width || gif.height != image.height) return;
  for (std::size_t i = 0; i < gif.entries.size(); ++i) {
    const bool is_clear = image.samples[kChannels * i + 3] == 0.0f;
    if (!is_clear || gif.entries[i] >= gif.palette.size()) continue;
    std::copy_n(gif.palette[gif.entries[i]].begin(), 3, image.samples.begin() + static_cast<std::ptrdiff_t>(kChannels * i));
  }
}

}  // namespace lentray::core
