// Windows bitmaps of 24 bits, or of 32 with alpha. Rows stand in the file from the lowest to the top one, each a
// whole number of 4 bytes. Source: the format's header BITMAPINFOHEADER; measured on stock.
#include <cstdint>
#include <vector>

#include "core/image/byte_file.h"
#include "core/image/picture_encoder.h"

namespace lentray::core {
namespace {

constexpr std::uint64_t kHead = 14 + 40;

class BmpEncoder final : public PictureEncoder {
 public:
  BmpEncoder(const std::filesystem::path& path, const PictureSpec& spec)
      : m_file(path, spec.spare, spec.count), m_width(spec.width), m_left(spec.height),
        m_channels(spec.channels),
        m_row((std::uint64_t{spec.width} * static_cast<std::uint64_t>(spec.channels) + 3) / 4 * 4) {
    const std::uint64_t pixels = m_row * spec.height;
    std::vector<std::uint8_t> head{'B', 'M'};
    put_little(head, kHead + pixels, 4);
    put_little(head, 0, 4);
    put_little(head, kHead, 4);
    put_little(head, 40, 4);
    put_little(head, spec.width, 4);
    put_little(head, spec.height, 4);
    put_little(head, 1, 2);  // planes
    put_little(head, static_cast<std::uint64_t>(8 * spec.channels), 2);
    put_little(head, 0, 4);  // not compressed
    put_little(head, pixels, 4);
    for (const double dpi : {spec.metadata.dpi_x, spec.metadata.dpi_y}) {
      put_little(head, static_cast<std::uint64_t>(dpi / 0.0254 + 0.5), 4);
    }
    put_little(head, 0, 8);  // no palette
    m_file.write(head.data(), head.size());
  }

  void put(const void* samples, std::uint32_t rows) override {
    const auto* from = static_cast<const std::uint8_t*>(samples);
    const auto channels = static_cast<std::size_t>(m_channels);
    std::vector<std::uint8_t> all(static_cast<std::size_t>(m_row) * rows);
    for (std::uint32_t row = 0; row < rows; ++row) {
      std::uint8_t* to = all.data() + m_row * (rows - 1 - row);
      for (std::uint32_t x = 0; x < m_width; ++x, from += channels, to += channels) {
        to[0] = from[2];
        to[1] = from[1];
        to[2] = from[0];
        if (channels == 4) to[3] = from[3];
      }
    }
    m_left -= rows;
    m_file.seek(kHead + m_row * m_left);
    m_file.write(all.data(), all.size());
  }

  void close() override { m_file.close(); }

 private:
  ByteFile m_file;
  const std::uint32_t m_width;
  std::uint32_t m_left;  ///< rows still to come
  const int m_channels;
  const std::uint64_t m_row;  ///< bytes
};

}  // namespace

MakeEncoder* const make_bmp_encoder = encoder_of<BmpEncoder>;

}  // namespace lentray::core
