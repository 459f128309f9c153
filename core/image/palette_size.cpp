#include "core/image/palette_size.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string_view>

#include "core/image/png_chunks.h"

namespace lentray::core {
namespace {

using Head = std::array<unsigned char, 54>;  ///< as long as a bitmap's

std::uint32_t little(const Head& head, std::size_t at, std::size_t bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes; i-- > 0;) value = value << 8 | head[at + i];
  return value;
}

int of_png(std::ifstream& file, const Head& head) {
  constexpr std::size_t kColourType = 25;
  constexpr unsigned char kByPalette = 3;
  if (head[kColourType] != kByPalette) return 0;
  return static_cast<int>(find_png_chunk(file, "PLTE").value_or(0) / 3);
}

int of_gif(const Head& head) {
  const unsigned flags = head[10];
  return (flags & 0x80) != 0 ? 2 << (flags & 7) : 0;
}

int of_bitmap(const Head& head) {
  const bool is_old = little(head, 14, 4) == 12;  // OS/2's: shorter, and the palette is always full
  const std::uint32_t bits = little(head, is_old ? 24 : 28, 2), used = is_old ? 0 : little(head, 46, 4);
  if (bits > 8) return 0;
  return used > 0 && used < 1u << bits ? static_cast<int>(used) : 1 << bits;
}

int of_targa(const Head& head) {
  constexpr unsigned kEntries = 1, kEntriesInRuns = 9;
  return head[2] == kEntries || head[2] == kEntriesInRuns ? static_cast<int>(little(head, 5, 2)) : 0;
}

}  // namespace

int palette_size(const std::filesystem::path& path, bool is_targa) {
  std::ifstream file(path, std::ios::binary);
  Head head{};
  file.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
  const std::string_view begins(reinterpret_cast<const char*>(head.data()), head.size());
  if (begins.starts_with("GIF8")) return of_gif(head);
  if (begins.starts_with("\x89PNG")) return of_png(file, head);
  if (begins.starts_with("BM")) return of_bitmap(head);
  return is_targa ? of_targa(head) : 0;
}

}  // namespace lentray::core
