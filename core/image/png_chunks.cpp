#include "core/image/png_chunks.h"

#include <array>
#include <fstream>

namespace lentray::core {
namespace {

std::uint32_t big(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

}  // namespace

std::optional<std::uint32_t> find_png_chunk(std::istream& file, std::string_view name) {
  constexpr std::streamoff kSignature = 8, kAround = 12;  ///< length, name and checksum of a chunk
  file.clear();
  for (std::streamoff at = kSignature;;) {
    std::array<char, 8> head{};
    file.seekg(at);
    if (!file.read(head.data(), head.size())) return std::nullopt;
    const std::uint32_t length = big(head.data());
    const std::string_view found(head.data() + 4, 4);
    if (found == name) return length;
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
  const std::uint32_t value = big(gamma.data());
  return value > 0 ? kWhole / value : 0.0;
}

}  // namespace lentray::core
