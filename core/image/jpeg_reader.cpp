#include <cstdio>

#include <jpeglib.h>  // needs FILE

#include <array>
#include <cstddef>
#include <stdexcept>

#include "core/image/format_readers.h"

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

}  // namespace

std::optional<StoredImage> read_jpeg(std::FILE* file) {
  Decoder decoder;
  jpeg_decompress_struct& jpeg = decoder.jpeg;
  jpeg_stdio_src(&jpeg, file);
  jpeg_read_header(&jpeg, TRUE);
  const J_COLOR_SPACE space = jpeg.jpeg_color_space;
  if (space != JCS_GRAYSCALE && space != JCS_YCbCr && space != JCS_RGB) return std::nullopt;
  StoredImage image;
  image.width = jpeg.image_width;
  image.height = jpeg.image_height;
  image.channels = space == JCS_GRAYSCALE ? 1 : 3;
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

}  // namespace lentray::core
