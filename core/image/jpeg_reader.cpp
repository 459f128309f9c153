#include <cstdio>

#include <jpeglib.h>  // needs FILE

#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/image/format_readers.h"
#include "core/image/jpeg_inks.h"
#include "core/image/open_file.h"

namespace lentray::core {
namespace {

/// As with libpng, exceptions leave the library's frames, which hold nothing of their own.
[[noreturn]] void jpeg_fails(j_common_ptr jpeg) {
  std::array<char, JMSG_LENGTH_MAX> text{};
  jpeg->err->format_message(jpeg, text.data());
  throw std::runtime_error(text.data());
}
void jpeg_warns(j_common_ptr, int) {}

struct Decoder {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  Decoder() {
    jpeg.err = jpeg_std_error(&errors);
    errors.error_exit = jpeg_fails;
    errors.emit_message = jpeg_warns;
    jpeg_create_decompress(&jpeg);
  }
  ~Decoder() { jpeg_destroy_decompress(&jpeg); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
};

/// Of a decoder whose header is read and whose colours are chosen.
StoredImage read_scans(jpeg_decompress_struct& jpeg, int channels) {
  StoredImage image;
  image.width = jpeg.image_width;
  image.height = jpeg.image_height;
  image.channels = channels;
  // A progressive file is held as coefficients besides, of two bytes.
  check_picture_room(image.width, image.height, image.channels,
                     jpeg_has_multiple_scans(&jpeg) ? 3 : 1);
  const std::size_t row_bytes = std::size_t{image.width} * static_cast<std::size_t>(image.channels);
  std::vector<std::uint8_t>& samples = image.samples.store<std::uint8_t>(row_bytes * image.height);
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = samples.data() + jpeg.output_scanline * row_bytes;
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  return image;
}

}  // namespace

std::optional<StoredImage> read_jpeg(std::FILE* file) {
  Decoder decoder;
  jpeg_decompress_struct& jpeg = decoder.jpeg;
  jpeg_stdio_src(&jpeg, file);
  jpeg_read_header(&jpeg, TRUE);
  const J_COLOR_SPACE space = jpeg.jpeg_color_space;
  if (space != JCS_GRAYSCALE && space != JCS_YCbCr && space != JCS_RGB) return std::nullopt;
  return read_scans(jpeg, space == JCS_GRAYSCALE ? 1 : 3);
}

StoredImage read_jpeg_inks(const std::filesystem::path& path) try {
  const OpenFile file(std::fopen(path.c_str(), "rbe"));
  if (!file) throw std::runtime_error("it cannot be opened");
  Decoder decoder;
  jpeg_decompress_struct& jpeg = decoder.jpeg;
  jpeg_stdio_src(&jpeg, file.get());
  jpeg_read_header(&jpeg, TRUE);
  if (jpeg.num_components != 4) throw std::runtime_error("it has no four inks");
  jpeg.out_color_space = JCS_CMYK;
  StoredImage image = read_scans(jpeg, 4);
  // Files with Adobe's mark, which are nearly all of them, hold paper as 255.
  if (jpeg.saw_Adobe_marker != 0) {
    std::vector<std::uint8_t> samples = image.samples.take<std::uint8_t>();
    for (std::uint8_t& sample : samples) sample = static_cast<std::uint8_t>(255 - sample);
    image.samples.store(std::move(samples));
  }
  return image;
} catch (const std::exception& e) {
  throw ImageError("cannot read '" + path.string() + "': " + e.what());
}

}  // namespace lentray::core
