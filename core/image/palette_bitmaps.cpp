#include "core/image/palette_bitmaps.h"

#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "core/image/file_bytes.h"

namespace lentray::core {
namespace {

/// A picture to be filled row by row in the order of the file.
class Canvas {
 public:
  Canvas(std::size_t width, std::size_t height)
      : m_width(width), m_height(height), m_entries(width * height) {}
  void put_top_first(bool top_first) { m_top_first = top_first; }
  std::size_t width() const { return m_width; }
  std::size_t height() const { return m_height; }
  bool has_size(std::int64_t width, std::int64_t height) const {
    return static_cast<std::size_t>(width) == m_width &&
           static_cast<std::size_t>(height) == m_height;
  }
  /// What lies beside the picture is passed over.
  void put(std::size_t column, std::size_t row, std::size_t entry) {
    if (column >= m_width || row >= m_height) return;
    const std::size_t from_top = m_top_first ? row : m_height - 1 - row;
    m_entries[from_top * m_width + column] = static_cast<std::uint8_t>(entry);
  }
  std::vector<std::uint8_t> take() { return std::move(m_entries); }

 private:
  std::size_t m_width, m_height;
  std::vector<std::uint8_t> m_entries;
  bool m_top_first = false;
};

/// Of 4 or 8 bits: pairs of a count and an entry, or of 0 and what happens next.
void read_runs(const Bytes& file, std::size_t at, std::size_t bits, Canvas& canvas) {
  constexpr std::size_t kEndOfRow = 0, kEnd = 1, kMove = 2;
  std::size_t column = 0, row = 0;
  // Of 4 bits the high half of a byte comes first.
  const auto part = [&](std::size_t byte, std::size_t i) {
    return bits == 8 ? byte : i % 2 == 0 ? byte >> 4 : byte & 15;
  };
  while (row < canvas.height()) {
    const std::size_t count = file.byte(at), value = file.byte(at + 1);
    at += 2;
    if (count > 0) {
      for (std::size_t i = 0; i < count; ++i) canvas.put(column++, row, part(value, i));
    } else if (value == kEndOfRow) {
      column = 0;
      ++row;
    } else if (value == kEnd) {
      return;
    } else if (value == kMove) {
      column += file.byte(at);
      row += file.byte(at + 1);
      at += 2;
    } else {  // so many entries as they are, in whole words
      for (std::size_t i = 0; i < value; ++i) {
        canvas.put(column++, row, part(file.byte(bits == 8 ? at + i : at + i / 2), i));
      }
      at += ((value * bits + 7) / 8 + 1) / 2 * 2;
    }
  }
}

/// OS/2's old heads are short and have no runs.
bool read_bitmap(const Bytes& file, Canvas& canvas) {
  constexpr std::size_t kStart = 10, kHead = 14;
  constexpr std::int32_t kOldHead = 12, kPlain = 0, kRuns8 = 1, kRuns4 = 2;
  const bool old = file.number(kHead) == kOldHead;
  const std::size_t bits = file.word(old ? 24 : 28);
  const std::int64_t width = old ? static_cast<std::int64_t>(file.word(18)) : file.number(18);
  const std::int64_t height = old ? static_cast<std::int64_t>(file.word(20)) : file.number(22);
  if ((bits != 1 && bits != 4 && bits != 8) || !canvas.has_size(width, std::abs(height)))
    return false;
  canvas.put_top_first(height < 0);
  const auto start = static_cast<std::size_t>(static_cast<std::uint32_t>(file.number(kStart)));
  const std::int32_t packing = old ? kPlain : file.number(30);
  if ((packing == kRuns8 && bits == 8) || (packing == kRuns4 && bits == 4)) {
    read_runs(file, start, bits, canvas);
    return true;
  }
  if (packing != kPlain) return false;
  const std::size_t row_bytes = (canvas.width() * bits + 31) / 32 * 4;
  for (std::size_t row = 0; row < canvas.height(); ++row) {
    for (std::size_t column = 0; column < canvas.width(); ++column) {
      const std::size_t bit = column * bits, byte = file.byte(start + row * row_bytes + bit / 8);
      canvas.put(column, row, byte >> (8 - bits - bit % 8) & ((1u << bits) - 1));
    }
  }
  return true;
}

}  // namespace

std::vector<std::uint8_t> bitmap_entries(std::string_view file, std::uint32_t width,
                                         std::uint32_t height) {
  Canvas canvas(width, height);
  try {
    if (read_bitmap(Bytes(file), canvas)) return canvas.take();
  } catch (const std::runtime_error&) {
  }
  return {};
}

}  // namespace lentray::core
