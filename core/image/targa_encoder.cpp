// Truevision Targa 2.0 of 24 bits, or of 32 with alpha, the top row first; plain or in runs, which end with their
// row. The extension area gives the gamma and the software.
// Source: Truevision's TGA file format specification, version 2.0; measured on stock.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "core/image/byte_file.h"
#include "core/image/picture_encoder.h"

namespace lentray::core {
namespace {

constexpr std::size_t kLongestPacket = 128;

class TargaEncoder final : public PictureEncoder {
 public:
  TargaEncoder(const std::filesystem::path& path, const PictureSpec& spec)
      : m_file(path, spec.spare, spec.count), m_spec(spec),
        m_channels(static_cast<std::size_t>(spec.channels)),
        m_in_runs(spec.type == FileType::compressed_targa) {
    std::vector<std::uint8_t> head{0, 0, static_cast<std::uint8_t>(m_in_runs ? 10 : 2)};
    put_little(head, 0, 9);  // no palette, no offset
    put_little(head, spec.width, 2);
    put_little(head, spec.height, 2);
    constexpr std::uint8_t kTopFirst = 0x20, kAlphaBits = 8;
    head.push_back(static_cast<std::uint8_t>(8 * spec.channels));
    head.push_back(spec.channels == 4 ? kTopFirst | kAlphaBits : kTopFirst);
    write(head);
  }

  void put(const void* samples, std::uint32_t rows) override {
    const std::size_t row_bytes = m_spec.width * m_channels;
    const auto* from = static_cast<const std::uint8_t*>(samples);
    std::vector<std::uint8_t> pixels(from, from + row_bytes * rows), out;
    for (std::size_t i = 0; i < pixels.size(); i += m_channels) std::swap(pixels[i], pixels[i + 2]);
    if (!m_in_runs) return write(pixels);
    for (std::uint32_t row = 0; row < rows; ++row) put_runs(pixels.data() + row * row_bytes, out);
    write(out);
  }

  void close() override {
    std::vector<std::uint8_t> end;
    put_extension(end);
    put_little(end, m_size, 4);
    put_little(end, 0, 4);
    constexpr char kSignature[] = "TRUEVISION-XFILE.";
    end.insert(end.end(), kSignature, kSignature + sizeof kSignature);
    m_file.write(end.data(), end.size());
    m_file.close();
  }

 private:
  void write(const std::vector<std::uint8_t>& bytes) {
    m_file.write(bytes.data(), bytes.size());
    m_size += bytes.size();
  }

  bool is_same(const std::uint8_t* row, std::size_t a, std::size_t b) const {
    return std::memcmp(row + a * m_channels, row + b * m_channels, m_channels) == 0;
  }

  /// Pixels that are equal as one, between them stretches of others.
  void put_runs(const std::uint8_t* row, std::vector<std::uint8_t>& out) const {
    const std::size_t width = m_spec.width;
    for (std::size_t at = 0; at < width;) {
      const std::size_t most = std::min(width - at, kLongestPacket);
      std::size_t count = 1;
      while (count < most && is_same(row, at, at + count)) ++count;
      const bool is_run = count > 1;
      while (!is_run && count < most &&
             !(at + count + 1 < width && is_same(row, at + count, at + count + 1)))
        ++count;
      out.push_back(static_cast<std::uint8_t>((is_run ? 0x80 : 0) | (count - 1)));
      const std::uint8_t* from = row + at * m_channels;
      out.insert(out.end(), from, from + m_channels * (is_run ? 1 : count));
      at += count;
    }
  }

  void put_extension(std::vector<std::uint8_t>& out) const {
    constexpr std::size_t kSize = 495, kSoftware = 426, kSoftwareSize = 40, kGamma = 478,
                          kAlphaKind = 494;
    constexpr std::uint16_t kGammaUnit = 6553;  // gammas up to 10
    std::vector<std::uint8_t> area;
    put_little(area, kSize, 2);
    area.resize(kSize, 0);
    const std::string_view software =
        std::string_view(m_spec.metadata.software).substr(0, kSoftwareSize);
    std::copy(software.begin(), software.end(), area.begin() + kSoftware);
    const double gamma = m_spec.srgb ? 2.2 : m_spec.file_gamma;
    std::vector<std::uint8_t> ratio;
    put_little(ratio,
               static_cast<std::uint64_t>(std::clamp(std::lround(gamma * kGammaUnit), 1L, 65535L)),
               2);
    put_little(ratio, kGammaUnit, 2);
    std::copy(ratio.begin(), ratio.end(), area.begin() + kGamma);
    area[kAlphaKind] = m_spec.channels == 4 ? 3 : 0;  // alpha by which colours are not multiplied
    out.insert(out.end(), area.begin(), area.end());
  }

  ByteFile m_file;
  const PictureSpec m_spec;
  const std::size_t m_channels;
  const bool m_in_runs;
  std::uint64_t m_size = 0;  ///< of the file so far
};

}  // namespace

MakeEncoder* const make_targa_encoder = encoder_of<TargaEncoder>;

}  // namespace lentray::core
