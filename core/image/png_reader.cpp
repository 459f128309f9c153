#include <png.h>

#include <bit>
#include <stdexcept>
#include <string>

#include "core/image/format_readers.h"
#include "core/image/png_errors.h"

namespace lentray::core {
namespace {

class PngReader {
 public:
  explicit PngReader(std::FILE* file) : m_input(file) {}

  /// Apart from the constructor, for what throws there is not taken apart again.
  StoredImage image() {
    png_read_info(m_png, m_info);
    StoredImage image;
    image.width = png_get_image_width(m_png, m_info);
    image.height = png_get_image_height(m_png, m_info);
    image.bits = png_get_bit_depth(m_png, m_info) == 16 ? 16 : 8;
    read_texts(image);
    if (png_get_color_type(m_png, m_info) == PNG_COLOR_TYPE_PALETTE) {
      read_palette(image);
    } else if (image.bits == 16) {
      if (std::endian::native == std::endian::little) png_set_swap(m_png);
      read_samples<std::uint16_t>(image);
    } else {
      read_samples<std::uint8_t>(image);
    }
    return image;
  }

 private:
  void read_texts(StoredImage& image) {
    constexpr double kInch = 0.0254;
    png_uint_32 x = 0, y = 0;
    int unit = 0;
    if (png_get_pHYs(m_png, m_info, &x, &y, &unit) && unit == PNG_RESOLUTION_METER) {
      image.attributes["XResolution"] = std::to_string(x * kInch);
      image.attributes["YResolution"] = std::to_string(y * kInch);
    }
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(m_png, m_info, &texts, &count);
    for (int i = 0; i < count; ++i) {
      const std::string name = texts[i].key;
      image.attributes[name == "Description" ? "ImageDescription" : name] = texts[i].text;
    }
  }

  template <typename Value>
  void read_rows(const StoredImage& image, std::size_t row_values, std::vector<Value>& values) {
    const int passes = png_set_interlace_handling(m_png);
    png_read_update_info(m_png, m_info);
    if (png_get_rowbytes(m_png, m_info) != row_values * sizeof(Value)) {
      throw std::runtime_error("rows of another length");
    }
    for (int pass = 0; pass < passes; ++pass) {
      for (std::uint32_t row = 0; row < image.height; ++row) {
        png_read_row(m_png, reinterpret_cast<png_bytep>(values.data() + row * row_values), nullptr);
      }
    }
  }

  template <typename Value>
  void read_samples(StoredImage& image) {
    const bool is_clear = png_get_valid(m_png, m_info, PNG_INFO_tRNS) != 0;
    if (image.bits == 8) png_set_expand_gray_1_2_4_to_8(m_png);
    if (is_clear) png_set_tRNS_to_alpha(m_png);
    const int type = png_get_color_type(m_png, m_info);
    const bool has_alpha = is_clear || (type & PNG_COLOR_MASK_ALPHA) != 0;
    image.channels = ((type & PNG_COLOR_MASK_COLOR) != 0 ? 3 : 1) + (has_alpha ? 1 : 0);
    check_picture_room(image.width, image.height, image.channels, sizeof(Value));
    const std::size_t row_values =
        std::size_t{image.width} * static_cast<std::size_t>(image.channels);
    read_rows(image, row_values, image.samples.store<Value>(row_values * image.height));
  }

  void read_palette(StoredImage& image) {
    Palette palette{};  // what lies beyond it is black
    png_colorp colours = nullptr;
    png_bytep alphas = nullptr;
    int count = 0, clear = 0;
    png_get_PLTE(m_png, m_info, &colours, &count);
    if (png_get_tRNS(m_png, m_info, &alphas, &clear, nullptr) == 0) clear = 0;
    for (int i = 0; i < 256; ++i) {
      std::uint8_t* entry = palette.data() + 4 * i;
      if (i < count) {
        entry[0] = colours[i].red;
        entry[1] = colours[i].green;
        entry[2] = colours[i].blue;
      }
      entry[3] = i < clear ? alphas[i] : 255;
    }
    image.channels = clear > 0 ? 4 : 3;
    check_picture_room(image.width, image.height, image.channels + 1, 1);
    image.entries.resize(std::size_t{image.width} * image.height);
    png_set_packing(m_png);  // a byte for each pixel of 1, 2 or 4 bits
    read_rows(image, image.width, image.entries);
    fill_from_palette(image, palette);
  }

  const PngInput m_input;
  const png_structp m_png = m_input.png;
  const png_infop m_info = m_input.info;
};

}  // namespace

StoredImage read_png(std::FILE* file) { return PngReader(file).image(); }

}  // namespace lentray::core
