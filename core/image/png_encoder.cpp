#include <png.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <string>

#include "core/image/byte_file.h"
#include "core/image/picture_encoder.h"
#include "core/image/png_errors.h"

namespace lentray::core {
namespace {

class PngEncoder final : public PictureEncoder {
 public:
  /// What throws here is followed by the destructor, for the other constructor is through.
  PngEncoder(const std::filesystem::path& path, const PictureSpec& spec)
      : PngEncoder(path, spec, spec.spare) {
    m_png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, png_fails, png_warns);
    m_info = m_png ? png_create_info_struct(m_png) : nullptr;
    if (!m_info) throw std::runtime_error("out of memory");
    png_set_write_fn(m_png, this, write, nullptr);
    start(spec);
  }
  ~PngEncoder() override { png_destroy_write_struct(&m_png, &m_info); }

  void put(const void* samples, std::uint32_t rows) override {
    const auto* from = static_cast<png_const_bytep>(samples);
    for (std::uint32_t row = 0; row < rows; ++row) png_write_row(m_png, from + row * m_row_bytes);
  }

  void close() override {
    png_write_end(m_png, m_info);
    m_file.close();
  }

 private:
  PngEncoder(const std::filesystem::path& path, const PictureSpec& spec, SpareRoom* spare)
      : m_row_bytes(std::size_t{spec.width} * static_cast<std::size_t>(spec.channels) *
                    static_cast<std::size_t>(spec.bits / 8)),
        m_file(path, spare, spec.count) {}

  static void write(png_structp png, png_bytep data, png_size_t size) {
    static_cast<PngEncoder*>(png_get_io_ptr(png))->m_file.write(data, size);
  }

  void start(const PictureSpec& spec) {
    constexpr int kTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                              PNG_COLOR_TYPE_RGB_ALPHA};
    png_set_user_limits(m_png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // its own are a million
    png_set_IHDR(m_png, m_info, spec.width, spec.height, spec.bits, kTypes[spec.channels - 1],
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    // Measured on integral images: the difference from the row above, in runs, takes a third of
    // the time of zlib's default and gives files of the same size.
    png_set_filter(m_png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_compression_strategy(m_png, Z_RLE);
    if (!spec.metadata.profile.empty()) {
      put_profile(spec.metadata.profile);
    } else if (spec.tagged) {
      constexpr double kLikeSrgb = 2.2;
      png_set_gAMA(m_png, m_info, 1.0 / (spec.srgb ? kLikeSrgb : spec.file_gamma));
      if (spec.srgb) png_set_sRGB(m_png, m_info, PNG_sRGB_INTENT_PERCEPTUAL);
    }
    if (spec.levels != 0 && spec.levels != spec.bits) {
      const auto bits = static_cast<png_byte>(spec.levels);
      const png_color_8 telling{
          .red = bits, .green = bits, .blue = bits, .gray = bits, .alpha = bits};
      png_set_sBIT(m_png, m_info, &telling);
    }
    const ImageMetadata& data = spec.metadata;
    if (data.dpi_x > 0.0 && data.dpi_y > 0.0) {
      const auto metric = [](double dpi) {
        return static_cast<png_uint_32>(std::lround(dpi / 0.0254));
      };
      png_set_pHYs(m_png, m_info, metric(data.dpi_x), metric(data.dpi_y), PNG_RESOLUTION_METER);
    }
    if (data.orientation != 1) put_orientation(data.orientation);
    if (!data.software.empty()) add_text("Software", data.software);
    if (!data.description.empty()) add_text("Description", data.description);
    for (const auto& [name, value] : data.fields) add_text(name, value);
    png_write_info(m_png, m_info);
    if (spec.bits == 16 && std::endian::native == std::endian::little) png_set_swap(m_png);
  }

  /// An Exif block of that tag alone: a TIFF head, a list of one short number, no other list.
  void put_orientation(int orientation) {
    png_byte exif[] = {'I',
                       'I',
                       42,
                       0,
                       8,
                       0,
                       0,
                       0,
                       1,
                       0,
                       0x12,
                       0x01,
                       3,
                       0,
                       1,
                       0,
                       0,
                       0,
                       static_cast<png_byte>(orientation),
                       0,
                       0,
                       0,
                       0,
                       0,
                       0,
                       0};
    png_set_eXIf_1(m_png, m_info, sizeof exif, exif);
  }

  /// libpng puts profiles to tests of its own, and leaves out with a warning what fails.
  void put_profile(const std::string& profile) {
    png_set_benign_errors(m_png, 1);
    png_set_iCCP(m_png, m_info, "ICC profile", PNG_COMPRESSION_TYPE_BASE,
                 reinterpret_cast<png_const_bytep>(profile.data()),
                 static_cast<png_uint_32>(profile.size()));
    if (png_get_valid(m_png, m_info, PNG_INFO_iCCP) == 0) {
      throw std::runtime_error("PNG does not take this colour profile; .tif and .jpg do");
    }
  }

  void add_text(const std::string& name, const std::string& value) {
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(name.c_str());
    text.text = const_cast<char*>(value.c_str());
    text.text_length = value.size();
    png_set_text(m_png, m_info, &text, 1);
  }

  const std::size_t m_row_bytes;
  ByteFile m_file;
  png_structp m_png = nullptr;
  png_infop m_info = nullptr;
};

}  // namespace

MakeEncoder* const make_png_encoder = encoder_of<PngEncoder>;

}  // namespace lentray::core
