#include "core/image/palette_tiff.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

#include "core/image/file_bytes.h"
#include "core/image/format_readers.h"
#include "core/image/image_module.h"

namespace lentray::core {
namespace {

constexpr std::size_t kBits = 258, kMeaning = 262, kSamples = 277, kPalette = 320;
constexpr std::size_t kGreys = 1, kEntries = 3;

/// The fields of the first directory. Errors: std::runtime_error if it is no such file or ends early.
class Directory {
 public:
  explicit Directory(std::string_view file)
      : m_bytes(file), m_is_big(file.starts_with(std::string_view("MM\0*", 4))) {
    if (!m_is_big && !file.starts_with(std::string_view("II*\0", 4)))
      throw std::runtime_error("no TIFF file");
    const std::size_t start = number(4);
    for (std::size_t i = 0; i < word(start); ++i) {
      const std::size_t field = start + 2 + 12 * i;
      m_fields.emplace(word(field), field);
    }
  }
  std::size_t word(std::size_t at) const {
    return m_is_big ? 256 * m_bytes.byte(at) + m_bytes.byte(at + 1) : m_bytes.word(at);
  }
  std::size_t number(std::size_t at) const {
    return m_is_big ? 65536 * word(at) + word(at + 2) : word(at) + 65536 * word(at + 2);
  }
  /// Where the one word of a field stands; 0: there is no such field.
  std::size_t place(std::size_t tag) const {
    const auto found = m_fields.find(tag);
    return found == m_fields.end() ? 0 : found->second + 8;
  }
  std::size_t value(std::size_t tag, std::size_t unless_there) const {
    return place(tag) == 0 ? unless_there : word(place(tag));
  }
  bool is_big() const { return m_is_big; }
  bool has_palette() const {
    const std::size_t bits = value(kBits, 1);
    return value(kMeaning, 0) == kEntries && value(kSamples, 1) == 1 && bits <= 8 &&
           place(kPalette) != 0;
  }
  int entries() const { return 1 << value(kBits, 1); }

 private:
  Bytes m_bytes;
  bool m_is_big;
  std::map<std::size_t, std::size_t> m_fields;  ///< where each tag's begins
};

/// Three of each entry, 0 .. 65535.
std::vector<std::uint16_t> colours_of(const Directory& directory) {
  const std::size_t reds = directory.number(directory.place(kPalette));
  const auto entries = static_cast<std::size_t>(directory.entries());
  std::vector<std::uint16_t> colours(3 * entries);
  for (std::size_t i = 0; i < entries; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      colours[3 * i + c] = static_cast<std::uint16_t>(directory.word(reds + 2 * (c * entries + i)));
    }
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
  const Directory directory(file);
  if (!directory.has_palette()) return {};
  file[directory.place(kMeaning) + (directory.is_big() ? 1 : 0)] = static_cast<char>(kGreys);
  const StoredImage greys = image_module().read_tiff(file, check_picture_room);
  if (greys.width != width || greys.height != height || greys.channels != 1 || greys.bits != 8)
    return {};
  std::vector<std::uint8_t> entries;
  entries.reserve(greys.samples.size());
  const int most = directory.entries() - 1;
  for (std::size_t i = 0; i < greys.samples.size(); ++i) {
    entries.push_back(
        static_cast<std::uint8_t>((static_cast<int>(greys.samples[i]) * most + 127) / 255));
  }
  return entries;
}

int tiff_palette_size(std::string_view file) {
  try {
    const Directory directory(file);
    return directory.has_palette() ? directory.entries() : 0;
  } catch (const std::runtime_error&) {
    return 0;
  }
}

void restore_palette_colours(StoredImage& image, const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string file{std::istreambuf_iterator<char>(stream), {}};
  std::vector<std::uint16_t> colours;
  try {
    if (!image.entries.empty()) colours = colours_of(Directory(file));
  } catch (const std::runtime_error&) {
  }
  if (colours.empty()) return;
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
