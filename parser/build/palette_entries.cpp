#include "parser/build/palette_entries.h"

#include <array>
#include <fstream>
#include <functional>
#include <map>
#include <utility>

#include "core/image/palette_indices.h"

namespace lentray::parser {
namespace {

using Palette = std::vector<std::array<std::uint8_t, 3>>;

using Head = std::function<std::size_t(std::size_t)>;  ///< a byte of the head of a file

/// Of a TARGA file of type 1 or 9: entries of 15 and 16 bits are five bits a colour.
Palette targa_palette(const Head& byte, std::size_t size) {
  Palette palette;
  const std::size_t count = byte(5) + 256 * byte(6), bytes = (byte(7) + 7) / 8, start = 18 + byte(0);
  if (byte(1) != 1 || (byte(2) != 1 && byte(2) != 9) || byte(16) != 8 || bytes < 2) return palette;
  for (std::size_t at = start; palette.size() < count && at + bytes <= size; at += bytes) {
    const std::size_t word = byte(at) + 256 * byte(at + 1);
    const auto five = [&](int shift) { return static_cast<std::uint8_t>((word >> shift & 31) << 3); };
    const auto whole = [&](std::size_t i) { return static_cast<std::uint8_t>(byte(at + i)); };
    if (bytes == 2) {
      palette.push_back({five(10), five(5), five(0)});
    } else {
      palette.push_back({whole(2), whole(1), whole(0)});
    }
  }
  return palette;
}

/// Of a BMP of up to 8 bits a pixel; OS/2's old heads are short, and so are their entries.
Palette bitmap_palette(const Head& byte, std::size_t size) {
  Palette palette;
  constexpr std::size_t kOldHead = 12;
  const std::size_t head = byte(14) + 256 * byte(15);
  const bool old = head == kOldHead;
  const std::size_t depth = byte(old ? 24 : 28), entry = old ? 3 : 4;
  if (depth > 8) return palette;
  std::size_t count = old ? 0 : byte(46) + 256 * byte(47);
  if (count == 0) count = std::size_t{1} << depth;
  for (std::size_t at = 14 + head; palette.size() < count && at + entry <= size; at += entry) {
    const auto part = [&](std::size_t i) { return static_cast<std::uint8_t>(byte(at + i)); };
    palette.push_back({part(2), part(1), part(0)});
  }
  return palette;
}

/// Of a BMP or TARGA, from the head of the file; empty if it has none. TARGA files are not marked: their
/// heads are looked at for what they are called.
Palette read_palette(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(4096, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  constexpr std::size_t kLeast = 54;
  if (head.size() <= kLeast) return {};
  const Head number = [&](std::size_t i) { return std::size_t{static_cast<std::uint8_t>(head[i])}; };
  if (head.rfind("BM", 0) == 0) return bitmap_palette(number, head.size());
  const std::string end = path.size() > 4 ? path.substr(path.size() - 4) : std::string();
  return end == ".tga" || end == ".TGA" ? targa_palette(number, head.size()) : Palette{};
}

/// The first entry of each pixel's colour: files are read with their palettes resolved.
std::vector<std::uint8_t> entries_of_colours(const core::StoredImage& stored, const Palette& palette) {
  std::vector<std::uint8_t> entries;
  if (palette.empty() || stored.channels == 2 || stored.bits != 8) return entries;
  std::map<std::array<std::uint8_t, 3>, std::uint8_t> numbers;
  for (std::size_t i = 0; i < palette.size() && i < 256; ++i) {
    numbers.try_emplace(palette[i], static_cast<std::uint8_t>(i));
  }
  for (std::uint32_t row = 0; row < stored.height; ++row) {
    for (std::uint32_t column = 0; column < stored.width; ++column) {
      std::array<std::uint8_t, 3> colour{};
      for (int c = 0; c < 3; ++c) {
        const int channel = stored.channels == 1 ? 0 : c;  // palettes of greys
        colour[static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(stored.at(column, row, channel));
      }
      const auto found = numbers.find(colour);
      entries.push_back(found == numbers.end() ? std::uint8_t{0} : found->second);
    }
  }
  return entries;
}

}  // namespace

std::vector<std::uint8_t> palette_entries(const core::StoredImage& stored, const std::string& path) {
  core::PaletteIndices indices = core::read_palette_indices(path);
  if (indices.width == stored.width && indices.height == stored.height) return std::move(indices.entries);
  return entries_of_colours(stored, read_palette(path));
}

}  // namespace lentray::parser
