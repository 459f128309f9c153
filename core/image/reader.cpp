#include "core/image/reader.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "core/base/ignored_error.h"
#include "core/base/lower_case.h"
#include "core/base/memory_limit.h"
#include "core/image/exr_head.h"
#include "core/image/format_readers.h"
#include "core/image/image_module.h"
#include "core/image/open_file.h"
#include "core/image/palette_bitmaps.h"
#include "core/image/palette_tiff.h"
#include "core/image/png_chunks.h"
#include "core/image/run_files.h"

namespace lentray::core {
namespace {

std::string all_of(std::FILE* file, const std::filesystem::path& path) {
  check_room(static_cast<double>(std::filesystem::file_size(path, ignored_error())));
  std::string bytes;
  std::array<char, 1 << 16> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), file))
    bytes.append(part.data(), size);
  return bytes;
}

bool is_targa_name(const std::filesystem::path& name) {
  return lower_case(name.extension().string()) == ".tga";
}

/// OpenImageIO reads palettes as colours.
void add_entries(StoredImage& image, std::string_view begins, std::FILE* file,
                 const std::filesystem::path& path) {
  try {
    if (begins.starts_with("BM")) {
      image.entries = bitmap_entries(all_of(file, path), image.width, image.height);
    } else if (begins.starts_with("II*") || begins.starts_with(std::string_view("MM\0*", 4))) {
      image.entries = tiff_entries(all_of(file, path), image.width, image.height);
    }
  } catch (const NoRoom&) {
    throw;
  } catch (const std::runtime_error&) {  // no TIFF file of those that have entries
  }
}

/// Before OpenEXR sees it.
void check_exr_room(std::FILE* file, const std::filesystem::path& path) {
  constexpr int kChannels = 3, kBytes = 2;  // at least
  std::string head(1 << 16, '\0');
  head.resize(std::fread(head.data(), 1, head.size(), file));
  std::rewind(file);
  const ExrWindow window = exr_window(head, std::filesystem::file_size(path));
  check_picture_room(window.width, window.height, kChannels, kBytes);
}

StoredImage by_openimageio(const NamedFile& named, std::string_view begins, std::FILE* file) {
  if (begins.starts_with("v/1\1")) check_exr_room(file, named.path);
  StoredImage image = image_module().read(named.path, named.name, check_picture_room);
  // Files of floats hold linear light.
  if (image.bits == 32) {
    image.gamma = 1.0;
    image.premultiplied = image.has_alpha();
  }
  add_entries(image, begins, file, named.path);
  return image;
}

StoredImage read(const NamedFile& named, std::FILE* file) {
  std::array<char, 8> head{};
  const std::size_t count = std::fread(head.data(), 1, head.size(), file);
  const std::string_view begins(head.data(), count);
  std::rewind(file);
  if (begins == "\x89PNG\r\n\x1a\n") {
    StoredImage image = read_png(file);
    image.gamma = png_gamma(named.path);  // PNG says what it holds
    return image;
  }
  if (begins.starts_with("GIF8")) return read_gif(file);
  if (begins.starts_with("\xff\xd8")) {
    if (auto image = read_jpeg(file)) return std::move(*image);
    std::rewind(file);
    return by_openimageio(named, begins, file);
  }
  if (named.is_targa || is_targa_name(named.name)) return read_targa(all_of(file, named.path));
  return by_openimageio(named, begins, file);
}

}  // namespace

void fill_from_palette(StoredImage& image, const Palette& palette) {
  const auto channels = static_cast<std::size_t>(image.channels);
  std::vector<std::uint8_t>& samples =
      image.samples.store<std::uint8_t>(image.entries.size() * channels);
  std::uint8_t* to = samples.data();
  for (const std::uint8_t entry : image.entries) {
    for (std::size_t c = 0; c < channels; ++c) *to++ = palette[4u * entry + c];
  }
}

void check_picture_room(std::uint64_t width, std::uint64_t height, int channels, int bytes) {
  check_room(static_cast<double>(width) * static_cast<double>(height) * channels * bytes);
}

StoredImage read_image(const NamedFile& file) {
  NamedFile named = file;
  if (named.name.empty()) named.name = named.path;
  const auto fail = [&](const std::string& why) {
    throw ImageError("cannot read '" + named.name.string() + "': " + why);
  };
  if (!std::filesystem::is_regular_file(named.path, ignored_error())) fail("there is no such file");
  const OpenFile opened(std::fopen(named.path.c_str(), "rbe"));
  if (!opened) fail(std::strerror(errno));
  // A handle's file is known already to whoever holds it.
  if (named.name == named.path) note_input(named.path);
  try {
    return read(named, opened.get());
  } catch (const std::exception& e) {
    fail(e.what());
  }
  return {};
}

StoredImage read_image(const std::filesystem::path& path) {
  return read_image(NamedFile{.path = path});
}

}  // namespace lentray::core
