#include "core/image/palette_tiff.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string_view>

#include "core/image/format_readers.h"
#include "core/image/image_module.h"
#include "core/image/stream_bytes.h"
#include "core/image/tiff_tags.h"

namespace lentray::core {
namespace {

constexpr std::uint16_t kBits = 258, kMeaning = 262, kSamples = 277, kPalette = 320;
constexpr std::uint16_t kGreys = 1, kEntries = 3;

/// Three of each entry, 0 .. 65535.
std::vector<std::uint16_t> colours_of(std::istream& file) {
  const auto entries = static_cast<std::size_t>(tiff_palette_size(file));
  TiffTags tags(file);
  const std::vector<std::uint16_t> planes = tags.words(tags.first(), kPalette);
  if (entries == 0 || planes.size() != 3 * entries) return {};
  std::vector<std::uint16_t> colours(planes.size());
  for (std::size_t i = 0; i < entries; ++i) {
    for (std::size_t c = 0; c < 3; ++c) colours[3 * i + c] = planes[c * entries + i];
  }
  // Some writers put bytes there, as if all were so.
  if (*std::max_element(colours.begin(), colours.end()) < 256) {
    for (std::uint16_t& value : colours) value = static_cast<std::uint16_t>(value * 257);
  }
  return colours;
}

}  // namespace

/// OpenImageIO unpacks them, as if they were greys.
std::vector<std::uint8_t> tiff_entries(std::string file, std::uint32_t width,
                                       std::uint32_t height) {
  std::istringstream stream(file);
  const int most = tiff_palette_size(stream) - 1;
  if (most < 0) return {};
  TiffTags tags(stream);
  file[tags.place(tags.first(), kMeaning) + (file.starts_with('M') ? 1 : 0)] =
      static_cast<char>(kGreys);
  const StoredImage greys = image_module().read_tiff(file, check_picture_room);
  if (greys.width != width || greys.height != height || greys.channels != 1 || greys.bits != 8)
    return {};
  std::vector<std::uint8_t> entries;
  entries.reserve(greys.samples.size());
  for (std::size_t i = 0; i < greys.samples.size(); ++i) {
    entries.push_back(
        static_cast<std::uint8_t>((static_cast<int>(greys.samples[i]) * most + 127) / 255));
  }
  return entries;
}

int tiff_palette_size(std::istream& file) {
  const std::string order = read_part(file, 0, 4);
  if (order != std::string_view("MM\0*", 4) && order != std::string_view("II*\0", 4)) return 0;
  TiffTags tags(file);
  const std::uint64_t first = tags.first(), bits = tags.number(first, kBits).value_or(1);
  const bool has_palette = tags.words(first, kMeaning) == std::vector{kEntries} &&
                           tags.number(first, kSamples).value_or(1) == 1 && bits <= 8 &&
                           tags.place(first, kPalette) != 0;
  return has_palette ? 1 << bits : 0;
}

void restore_palette_colours(StoredImage& image, const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::vector<std::uint16_t> colours = colours_of(stream);
  if (image.entries.empty() || colours.empty()) return;
  image.channels = 3;
  image.bits = 16;
  std::vector<std::uint16_t>& samples =
      image.samples.store<std::uint16_t>(3 * image.entries.size());
  std::size_t to = 0;
  for (const std::uint8_t entry : image.entries) {
    for (std::size_t c = 0; c < 3; ++c) samples[to++] = colours[3u * entry + c];
  }
}

}  // namespace lentray::core
