// Radiance's pictures, each component of a row in runs of its own where the format has them.
// Source: Radiance's reference, "Picture file format" and its adaptive run-length encoding; measured on stock.
#include <cstdint>
#include <string>
#include <vector>

#include "core/image/byte_file.h"
#include "core/image/picture_encoder.h"

namespace lentray::core {
namespace {

constexpr std::uint32_t kLeastWidth = 8, kMostWidth = 32767;  ///< of rows in runs
constexpr std::size_t kShortestRun = 4, kLongestRun = 127, kLongestPlain = 128;

class RadianceEncoder final : public PictureEncoder {
 public:
  RadianceEncoder(const std::filesystem::path& path, const PictureSpec& spec)
      : m_file(path, spec.spare, spec.count), m_width(spec.width) {
    m_file.write("#?RADIANCE\n");
    if (!spec.metadata.software.empty()) m_file.write("SOFTWARE=" + spec.metadata.software + "\n");
    for (const auto& [name, value] : spec.metadata.fields) m_file.write(name + "=" + value + "\n");
    m_file.write("FORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(spec.height) + " +X " +
                 std::to_string(m_width) + "\n");
  }

  void put(const void* samples, std::uint32_t rows) override {
    const auto* from = static_cast<const std::uint8_t*>(samples);
    const std::size_t row_bytes = std::size_t{4} * m_width;
    if (m_width < kLeastWidth || m_width > kMostWidth) return m_file.write(from, row_bytes * rows);
    m_out.clear();
    for (std::uint32_t row = 0; row < rows; ++row, from += row_bytes) {
      const std::uint8_t head[] = {2, 2, static_cast<std::uint8_t>(m_width >> 8),
                                   static_cast<std::uint8_t>(m_width)};
      m_out.insert(m_out.end(), std::begin(head), std::end(head));
      for (int c = 0; c < 4; ++c) put_component(from + c);
    }
    m_file.write(m_out.data(), m_out.size());
  }

  void close() override { m_file.close(); }

 private:
  std::size_t equal_from(const std::uint8_t* row, std::size_t at) const {
    std::size_t end = at + 1;
    while (end < m_width && end - at < kLongestRun && row[4 * end] == row[4 * at]) ++end;
    return end - at;
  }

  /// Every fourth byte of a row.
  void put_component(const std::uint8_t* row) {
    for (std::size_t at = 0; at < m_width;) {
      const std::size_t run = equal_from(row, at);
      if (run >= kShortestRun) {
        m_out.push_back(static_cast<std::uint8_t>(128 + run));
        m_out.push_back(row[4 * at]);
        at += run;
        continue;
      }
      std::size_t end = at + 1;
      while (end < m_width && end - at < kLongestPlain && equal_from(row, end) < kShortestRun)
        ++end;
      m_out.push_back(static_cast<std::uint8_t>(end - at));
      for (; at < end; ++at) m_out.push_back(row[4 * at]);
    }
  }

  ByteFile m_file;
  const std::uint32_t m_width;
  std::vector<std::uint8_t> m_out;
};

}  // namespace

MakeEncoder* const make_radiance_encoder = encoder_of<RadianceEncoder>;

}  // namespace lentray::core
