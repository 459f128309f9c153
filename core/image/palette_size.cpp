#include "core/image/palette_size.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string_view>

#include "core/image/file_bytes.h"
#include "core/image/palette_tiff.h"
#include "core/image/png_chunks.h"

namespace lentray::core {
namespace {

int of_png(std::ifstream& file, const Bytes& head) {
  constexpr std::size_t kColourType = 25;
  constexpr std::size_t kByPalette = 3;
  if (head.byte(kColourType) != kByPalette) return 0;
  return static_cast<int>(find_png_chunk(file, "PLTE").value_or(0) / 3);
}

int of_gif(const Bytes& head) {
  const std::size_t flags = head.byte(10);
  return (flags & 0x80) != 0 ? 2 << (flags & 7) : 0;
}

int of_bitmap(const Bytes& head) {
  const bool is_old = head.number(14) == 12;  // OS/2's: shorter, and the palette is always full
  const std::size_t bits = head.word(is_old ? 24 : 28);
  const std::int32_t used = is_old ? 0 : head.number(46);
  if (bits > 8) return 0;
  return used > 0 && used < 1 << bits ? used : 1 << bits;
}

int of_targa(const Bytes& head) {
  constexpr std::size_t kEntries = 1, kEntriesInRuns = 9;
  const std::size_t type = head.byte(2);
  return type == kEntries || type == kEntriesInRuns ? static_cast<int>(head.word(5)) : 0;
}

}  // namespace

int palette_size(const std::filesystem::path& path, bool is_targa) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 54> start{};  // as long as a bitmap's head
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  const std::string_view begins(start.data(), start.size());
  const Bytes head(begins);
  if (begins.starts_with("GIF8")) return of_gif(head);
  if (begins.starts_with("\x89PNG")) return of_png(file, head);
  if (begins.starts_with("BM")) return of_bitmap(head);
  if (is_targa) return of_targa(head);
  return tiff_palette_size(file);
}

}  // namespace lentray::core
