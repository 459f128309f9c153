// jpeg_of() of core/image/thumbnail.h.
#include <cstdio>

#include <jpeglib.h>  // needs FILE

#include <cstddef>
#include <cstdlib>

#include <array>
#include <stdexcept>

#include "core/image/thumbnail.h"

namespace lentray::core {
namespace {

/// Exceptions leave the library's frames, which hold nothing of their own.
[[noreturn]] void fails(j_common_ptr jpeg) {
  std::array<char, JMSG_LENGTH_MAX> text{};
  jpeg->err->format_message(jpeg, text.data());
  throw std::runtime_error(text.data());
}

struct Coder {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  Coder() {
    jpeg.err = jpeg_std_error(&errors);
    errors.error_exit = fails;
    jpeg_create_compress(&jpeg);
    jpeg_mem_dest(&jpeg, &bytes, &size);
  }
  ~Coder() {
    jpeg_destroy_compress(&jpeg);
    std::free(bytes);
  }
  Coder(const Coder&) = delete;
  Coder& operator=(const Coder&) = delete;
};

}  // namespace

std::string jpeg_of(const Thumbnail& thumbnail, int quality) {
  constexpr std::uint32_t kNarrow = 128;
  Coder coder;
  jpeg_compress_struct& jpeg = coder.jpeg;
  jpeg.image_width = thumbnail.width;
  jpeg.image_height = thumbnail.height;
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, quality, TRUE);
  jpeg.optimize_coding = TRUE;
  if (thumbnail.width < kNarrow)
    jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = 1;
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    // The library reads rows that it takes as variable.
    auto* row = const_cast<JSAMPROW>(thumbnail.rgb.data() +
                                     std::size_t{3} * thumbnail.width * jpeg.next_scanline);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  return {reinterpret_cast<const char*>(coder.bytes), coder.size};
}

}  // namespace lentray::core
