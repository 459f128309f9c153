#include "core/image/tiff_tags.h"

#include <algorithm>

#include "core/image/stream_bytes.h"

namespace lentray::core {
namespace {

enum Type : std::uint16_t {
  kByte = 1,
  kText = 2,
  kShort = 3,
  kLong = 4,
  kRational = 5,
  kUndefined = 7,
  kLong8 = 16
};

constexpr std::uint64_t kMostEntries = 4096;  // more: a broken file

/// 0: a type that is not asked for.
int size_of_type(std::uint16_t type) {
  switch (type) {
    case kByte:
    case kText:
    case kUndefined: return 1;
    case kShort: return 2;
    case kLong: return 4;
    case kRational:
    case kLong8: return 8;
    default: return 0;
  }
}

}  // namespace

TiffTags::TiffTags(std::istream& file) : m_file(file) {
  const std::uint64_t order = value(0, 2);
  m_is_big_endian = order == 0x4d4d;
  if (order != 0x4949 && order != 0x4d4d) return;
  constexpr std::uint64_t kClassic = 42, kWide = 43;
  const std::uint64_t version = value(2, 2);
  m_is_wide = version == kWide;
  if (version == kClassic) m_first = value(4, 4);
  if (m_is_wide) m_first = value(8, 8);
}

std::uint64_t TiffTags::value(std::uint64_t at, int size) {
  const std::string bytes = read_part(m_file, at, static_cast<std::size_t>(size));
  if (bytes.size() < static_cast<std::size_t>(size)) return 0;
  return m_is_big_endian ? big_endian(bytes) : little_endian(bytes);
}

std::uint64_t TiffTags::next(std::uint64_t directory) {
  const std::uint64_t head = m_is_wide ? 8 : 2, entry_size = m_is_wide ? 20 : 12;
  const std::uint64_t count = value(directory, static_cast<int>(head));
  if (count > kMostEntries) return 0;
  return value(directory + head + count * entry_size, m_is_wide ? 8 : 4);
}

std::optional<TiffTags::Entry> TiffTags::find(std::uint64_t directory, std::uint16_t tag) {
  if (directory == 0) return std::nullopt;
  const int wide = m_is_wide ? 8 : 4, head = m_is_wide ? 8 : 2;
  const std::uint64_t entry_size = m_is_wide ? 20 : 12;
  const std::uint64_t count = std::min(value(directory, head), kMostEntries);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t at = directory + static_cast<std::uint64_t>(head) + i * entry_size;
    if (value(at, 2) != tag) continue;
    Entry entry{static_cast<std::uint16_t>(value(at + 2, 2)), value(at + 4, wide), 0};
    const auto size = static_cast<std::uint64_t>(size_of_type(entry.type));
    if (size == 0 || entry.count == 0) return std::nullopt;
    entry.place = at + 4 + static_cast<std::uint64_t>(wide);
    if (entry.count > static_cast<std::uint64_t>(wide) / size)
      entry.place = value(entry.place, wide);
    return entry;
  }
  return std::nullopt;
}

std::optional<std::uint64_t> TiffTags::number(std::uint64_t directory, std::uint16_t tag) {
  const auto entry = find(directory, tag);
  if (!entry || entry->type == kRational || entry->type == kText) return std::nullopt;
  return value(entry->place, size_of_type(entry->type));
}

std::optional<double> TiffTags::fraction(std::uint64_t directory, std::uint16_t tag) {
  const auto entry = find(directory, tag);
  if (!entry || entry->type != kRational) return std::nullopt;
  const auto above = static_cast<double>(value(entry->place, 4)),
             below = static_cast<double>(value(entry->place + 4, 4));
  return below > 0.0 ? std::optional(above / below) : std::nullopt;
}

std::uint64_t TiffTags::place(std::uint64_t directory, std::uint16_t tag) {
  const auto entry = find(directory, tag);
  return entry ? entry->place : 0;
}

std::vector<std::uint16_t> TiffTags::words(std::uint64_t directory, std::uint16_t tag) {
  constexpr std::uint64_t kMost = 3 << 16;
  const auto entry = find(directory, tag);
  if (!entry || entry->type != kShort || entry->count > kMost) return {};
  const std::string bytes = read_part(m_file, entry->place, 2 * entry->count);
  std::vector<std::uint16_t> out;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const std::string_view word = std::string_view(bytes).substr(i, 2);
    out.push_back(
        static_cast<std::uint16_t>(m_is_big_endian ? big_endian(word) : little_endian(word)));
  }
  return out;
}

std::optional<std::string> TiffTags::bytes(std::uint64_t directory, std::uint16_t tag) {
  const auto entry = find(directory, tag);
  constexpr std::uint64_t kMost = std::uint64_t{1} << 26;
  if (!entry || size_of_type(entry->type) != 1 || entry->count > kMost) return std::nullopt;
  std::string out = read_part(m_file, entry->place, entry->count);
  while (entry->type == kText && out.ends_with('\0')) out.pop_back();
  return out;
}

}  // namespace lentray::core
