// PPM and PGM, binary: numbers of 16 bits have their upper byte first. Source: ppm(5) and pgm(5) of Netpbm.
#include <string>
#include <vector>

#include "core/image/byte_file.h"
#include "core/image/picture_encoder.h"

namespace lentray::core {
namespace {

class PpmEncoder final : public PictureEncoder {
 public:
  PpmEncoder(const std::filesystem::path& path, const PictureSpec& spec)
      : m_file(path, spec.spare, spec.count),
        m_row(std::size_t{spec.width} * static_cast<std::size_t>(spec.channels)),
        m_wide(spec.bits == 16) {
    const int levels = spec.levels != 0 ? spec.levels : spec.bits;
    m_file.write(spec.channels == 1 ? "P5\n" : "P6\n");
    if (!spec.metadata.software.empty())
      m_file.write("# Software: " + spec.metadata.software + "\n");
    for (const auto& [name, value] : spec.metadata.fields)
      m_file.write("# " + name + "=" + value + "\n");
    m_file.write(std::to_string(spec.width) + " " + std::to_string(spec.height) + "\n" +
                 std::to_string((1u << levels) - 1u) + "\n");
  }

  void put(const void* samples, std::uint32_t rows) override {
    const std::size_t count = m_row * rows;
    if (!m_wide) return m_file.write(samples, count);
    const auto* words = static_cast<const std::uint16_t*>(samples);
    m_bytes.resize(2 * count);
    for (std::size_t i = 0; i < count; ++i) {
      m_bytes[2 * i] = static_cast<std::uint8_t>(words[i] >> 8);
      m_bytes[2 * i + 1] = static_cast<std::uint8_t>(words[i]);
    }
    m_file.write(m_bytes.data(), m_bytes.size());
  }

  void close() override { m_file.close(); }

 private:
  ByteFile m_file;
  const std::size_t m_row;  ///< samples
  const bool m_wide;
  std::vector<std::uint8_t> m_bytes;
};

}  // namespace

MakeEncoder* const make_ppm_encoder = encoder_of<PpmEncoder>;

}  // namespace lentray::core
