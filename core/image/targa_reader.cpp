#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "core/image/file_bytes.h"
#include "core/image/format_readers.h"

namespace lentray::core {
namespace {

using TargaPixel = std::array<std::uint8_t, 4>;

enum class Kind { kPalette = 1, kColours = 2, kGreys = 3 };

struct Head {
  Kind kind{};
  bool runs = false, top_first = false;
  std::size_t width = 0, height = 0, bits = 0;
  std::size_t first_entry = 0, entries = 0, entry_bits = 0;
  std::size_t palette = 0, pixels = 0;  ///< where they begin in the file
};

bool is_one_of(std::size_t value, std::initializer_list<std::size_t> values) {
  return std::ranges::find(values, value) != values.end();
}

Head read_head(const Bytes& file) {
  constexpr std::size_t kLength = 18, kRuns = 8, kTopFirst = 0x20;
  Head head;
  const std::size_t type = file.byte(2);
  if (!is_one_of(type & ~kRuns, {1, 2, 3})) throw std::runtime_error("it is no TARGA file");
  head.kind = static_cast<Kind>(type & ~kRuns);
  head.runs = (type & kRuns) != 0;
  head.width = file.word(12);
  head.height = file.word(14);
  head.bits = file.byte(16);
  head.top_first = (file.byte(17) & kTopFirst) != 0;
  head.palette = kLength + file.byte(0);
  const bool has_palette = file.byte(1) != 0;
  if (has_palette) {
    head.first_entry = file.word(3);
    head.entries = file.word(5);
    head.entry_bits = file.byte(7);
  }
  head.pixels = head.palette + head.entries * ((head.entry_bits + 7) / 8);
  const bool good = head.kind == Kind::kPalette ? has_palette && head.bits == 8 &&
                                                      is_one_of(head.entry_bits, {15, 16, 24, 32})
                    : head.kind == Kind::kColours ? is_one_of(head.bits, {15, 16, 24, 32})
                                                  : is_one_of(head.bits, {8, 16});
  if (!good) throw std::runtime_error("a TARGA file of so many bits a pixel is not known");
  if (head.width == 0 || head.height == 0) throw std::runtime_error("the picture is empty");
  // A run's packet is a byte and its pixel, for 128 pixels at most.
  const std::size_t stored = file.size() > head.pixels ? file.size() - head.pixels : 0,
                    bytes = (head.bits + 7) / 8;
  if (head.width * head.height > (head.runs ? stored / (bytes + 1) * 128 : stored / bytes)) {
    throw std::runtime_error("the file ends early");
  }
  return head;
}

/// Five bits a colour are the upper ones of eight, the others 0.
TargaPixel pixel_at(const Bytes& file, std::size_t at, std::size_t bits) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(file.byte(at + i)); };
  if (bits >= 24) return {byte(2), byte(1), byte(0), bits == 32 ? byte(3) : std::uint8_t{255}};
  const std::size_t word = file.word(at);
  const auto five = [&](std::size_t shift) {
    return static_cast<std::uint8_t>((word >> shift & 31) << 3);
  };
  return {five(10), five(5), five(0), (word & 0x8000) != 0 ? std::uint8_t{255} : std::uint8_t{0}};
}

/// The place of each pixel in the file, in the order of the file, whatever is packed.
class Walk {
 public:
  Walk(const Bytes& file, const Head& head)
      : m_file(file), m_runs(head.runs), m_bytes((head.bits + 7) / 8), m_at(head.pixels) {}
  std::size_t next() {
    if (!m_runs) return step();
    if (m_left == 0) {
      const std::size_t packet = m_file.byte(m_at++);
      m_is_run = (packet & 0x80) != 0;
      m_left = (packet & 0x7f) + 1;
    }
    --m_left;
    return m_is_run && m_left > 0 ? m_at : step();
  }

 private:
  std::size_t step() {
    const std::size_t here = m_at;
    m_at += m_bytes;
    return here;
  }
  const Bytes& m_file;
  const bool m_runs;
  const std::size_t m_bytes;
  std::size_t m_at, m_left = 0;
  bool m_is_run = false;
};

/// Calls put(pixel of the picture, place in the file) for all, the picture's rows from the top.
template <typename Put>
void for_pixels(const Bytes& file, const Head& head, Put put) {
  Walk walk(file, head);
  for (std::size_t y = 0; y < head.height; ++y) {
    const std::size_t row = head.top_first ? y : head.height - 1 - y;
    for (std::size_t x = 0; x < head.width; ++x) {
      put(row * head.width + x, walk.next());
    }
  }
}

void read_palette(const Bytes& file, const Head& head, StoredImage& image) {
  Palette palette{};
  for (std::size_t i = 0; i < head.entries; ++i) {
    const std::size_t entry = head.first_entry + i;
    if (entry >= 256) break;
    const TargaPixel colour =
        pixel_at(file, head.palette + i * ((head.entry_bits + 7) / 8), head.entry_bits);
    for (std::size_t c = 0; c < 4; ++c) palette[4 * entry + c] = colour[c];
  }
  image.channels = head.entry_bits == 32 ? 4 : 3;
  check_picture_room(head.width, head.height, image.channels + 1, 1);
  image.entries.resize(head.width * head.height);
  for_pixels(file, head, [&](std::size_t pixel, std::size_t at) {
    image.entries[pixel] = static_cast<std::uint8_t>(file.byte(at));
  });
  fill_from_palette(image, palette);
}

}  // namespace

StoredImage read_targa(std::string_view bytes) {
  const Bytes file(bytes);
  const Head head = read_head(file);
  StoredImage image;
  image.width = static_cast<std::uint32_t>(head.width);
  image.height = static_cast<std::uint32_t>(head.height);
  if (head.kind == Kind::kPalette) {
    read_palette(file, head, image);
    return image;
  }
  const bool is_grey = head.kind == Kind::kGreys;
  const bool has_alpha = is_grey ? head.bits == 16 : head.bits == 32 || head.bits == 16;
  image.channels = (is_grey ? 1 : 3) + (has_alpha ? 1 : 0);
  const auto channels = static_cast<std::size_t>(image.channels);
  check_picture_room(head.width, head.height, image.channels, 1);
  std::vector<std::uint8_t>& samples =
      image.samples.store<std::uint8_t>(head.width * head.height * channels);
  for_pixels(file, head, [&](std::size_t pixel, std::size_t at) {
    std::uint8_t* to = samples.data() + pixel * channels;
    if (is_grey) {
      for (std::size_t c = 0; c < channels; ++c)
        to[c] = static_cast<std::uint8_t>(file.byte(at + c));
    } else {
      const TargaPixel colour = pixel_at(file, at, head.bits);
      for (std::size_t c = 0; c < channels; ++c) to[c] = colour[c];
    }
  });
  return image;
}

}  // namespace lentray::core
