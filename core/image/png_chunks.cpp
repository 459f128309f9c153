#include "core/image/png_chunks.h"

#include <array>
#include <fstream>

#include "core/image/stream_bytes.h"

namespace lentray::core {

std::optional<std::uint32_t> find_png_chunk(std::istream& file, std::string_view name) {
  constexpr std::streamoff kSignature = 8, kAround = 12;  ///< length, name and checksum of a chunk
  file.clear();
  for (std::streamoff at = kSignature;;) {
    std::array<char, 8> head{};
    file.seekg(at);
    if (!file.read(head.data(), head.size())) return std::nullopt;
    const std::uint64_t length = big_endian({head.data(), 4});
    const std::string_view found(head.data() + 4, 4);
    if (found == name) return static_cast<std::uint32_t>(length);
    if (found == "IDAT") return std::nullopt;
    at += kAround + static_cast<std::streamoff>(length);
  }
}

double png_gamma(const std::filesystem::path& path) {
  constexpr double kWhole = 100000.0;
  std::ifstream file(path, std::ios::binary);
  if (find_png_chunk(file, "sRGB")) return -1.0;
  std::array<char, 4> gamma{};
  if (!find_png_chunk(file, "gAMA") || !file.read(gamma.data(), gamma.size())) return 0.0;
  const std::uint64_t value = big_endian({gamma.data(), gamma.size()});
  return value > 0 ? kWhole / static_cast<double>(value) : 0.0;
}

}  // namespace lentray::core
