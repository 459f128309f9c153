#include "core/image/photo_tags.h"

#include <zlib.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>

#include "core/image/stream_bytes.h"
#include "core/image/tiff_tags.h"

namespace lentray::core {
namespace {

enum Tag : std::uint16_t {
  kNewSubfileType = 254,
  kOrientation = 274,
  kXResolution = 282,
  kYResolution = 283,
  kResolutionUnit = 296,
  kInteroperabilityIndex = 1,
  kExif = 34665,
  kProfile = 34675,
  kInteroperability = 40965
};

/// What a TIFF file and a block of Exif have both.
void take_directory(TiffTags& block, PhotoTags& tags) {
  const std::uint64_t first = block.first();
  const std::uint64_t orientation = block.number(first, kOrientation).value_or(1);
  if (orientation >= 1 && orientation <= 8) tags.orientation = static_cast<int>(orientation);
  const std::uint64_t exif = block.number(first, kExif).value_or(0);
  const std::uint64_t marks = block.number(exif, kInteroperability).value_or(0);
  tags.is_adobe_rgb = block.bytes(marks, kInteroperabilityIndex).value_or("").starts_with("R03");
}

void take_exif(std::string_view bytes, PhotoTags& tags) {
  constexpr std::string_view kMark("Exif\0\0", 6);
  if (bytes.starts_with(kMark)) bytes.remove_prefix(kMark.size());
  std::istringstream file{std::string(bytes)};
  TiffTags block(file);
  take_directory(block, tags);
  constexpr std::uint64_t kCentimetres = 3;
  const double scale =
      block.number(block.first(), kResolutionUnit).value_or(2) == kCentimetres ? 2.54 : 1.0;
  const auto x = block.fraction(block.first(), kXResolution),
             y = block.fraction(block.first(), kYResolution);
  if (x && y) {
    tags.dpi_x = *x * scale;
    tags.dpi_y = *y * scale;
  }
}

int pages_of(TiffTags& file) {
  constexpr std::uint64_t kSmallCopy = 1, kMask = 4;
  constexpr int kMost = 10000;  // a circle in a broken file
  int pages = 0;
  std::uint64_t at = file.first();
  for (int i = 0; i < kMost && at != 0; ++i, at = file.next(at)) {
    const std::uint64_t kind = file.number(at, kNewSubfileType).value_or(0);
    if (i == 0 || (kind & (kSmallCopy | kMask)) == 0) ++pages;
  }
  return pages;
}

PhotoTags tags_of_tiff(std::istream& file) {
  PhotoTags tags;
  TiffTags block(file);
  take_directory(block, tags);
  tags.pages = pages_of(block);
  tags.profile = block.bytes(block.first(), kProfile).value_or("");
  return tags;
}

/// Up to where the pixels begin.
class JpegSegments {
 public:
  explicit JpegSegments(std::istream& file) : m_file(file) {}

  PhotoTags tags() {
    constexpr int kScan = 0xda, kEnd = 0xd9;
    m_tags.is_jpeg = true;
    m_file.seekg(2);
    for (;;) {
      int mark = m_file.get();
      if (mark != 0xff) break;
      while (mark == 0xff) mark = m_file.get();
      if (mark == kScan || mark == kEnd || mark < 0) break;
      const std::string length = read_part(m_file, 2);
      if (length.size() < 2 || big_endian(length) < 2) break;
      take(mark, read_part(m_file, big_endian(length) - 2));
    }
    for (const auto& [number, part] : m_profile) m_tags.profile += part;
    return m_tags;
  }

 private:
  void take(int mark, std::string_view bytes) {
    constexpr std::string_view kJfif("JFIF\0", 5), kExifMark("Exif\0\0", 6),
        kIcc("ICC_PROFILE\0", 12);
    constexpr int kApp0 = 0xe0, kApp1 = 0xe1, kApp2 = 0xe2, kComment = 0xfe;
    if (mark == kComment && m_tags.description.empty()) {
      while (bytes.ends_with('\0')) bytes.remove_suffix(1);
      m_tags.description = bytes;
    } else if (mark == kApp1 && bytes.starts_with(kExifMark) && !m_has_exif) {
      m_has_exif = true;
      take_exif(bytes, m_tags);
    } else if (mark == kApp2 && bytes.starts_with(kIcc) && bytes.size() > kIcc.size() + 2) {
      // Each has its number; they need not come in order.
      m_profile[static_cast<unsigned char>(bytes[kIcc.size()])] = bytes.substr(kIcc.size() + 2);
    } else if (mark == kApp0 && bytes.starts_with(kJfif) && bytes.size() >= 12 && !m_has_exif) {
      const int unit = bytes[7];
      const double scale = unit == 1 ? 1.0 : unit == 2 ? 2.54 : 0.0;
      m_tags.dpi_x = static_cast<double>(big_endian(bytes.substr(8, 2))) * scale;
      m_tags.dpi_y = static_cast<double>(big_endian(bytes.substr(10, 2))) * scale;
    }
  }

  std::istream& m_file;
  PhotoTags m_tags;
  std::map<int, std::string> m_profile;
  bool m_has_exif = false;
};

/// Behind the profile's name and a byte for the method, of which there is one.
std::string unpacked_profile(std::string_view chunk) {
  const std::size_t name = chunk.find('\0');
  if (name == std::string_view::npos || name + 2 > chunk.size()) return "broken";
  chunk.remove_prefix(name + 2);
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return "broken";
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(chunk.data()));
  stream.avail_in = static_cast<uInt>(chunk.size());
  constexpr std::size_t kMost = std::size_t{1} << 26;
  std::array<char, 1 << 14> part{};
  std::string out;
  int status = Z_OK;
  while (status == Z_OK && out.size() < kMost) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    status = inflate(&stream, Z_NO_FLUSH);
    out.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return status == Z_STREAM_END ? out : "broken";
}

Chromaticities chromaticities_of(std::string_view chunk) {
  const auto at = [&](std::size_t i) {
    return static_cast<double>(big_endian(chunk.substr(4 * i, 4))) / 100000.0;
  };
  return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
}

PhotoTags tags_of_png(std::istream& file) {
  constexpr std::uint64_t kSignature = 8, kAround = 12;  // length, name and checksum of a chunk
  constexpr std::uint64_t kMost = std::uint64_t{1} << 26;
  PhotoTags tags;
  bool is_srgb = false;
  for (std::uint64_t at = kSignature;;) {
    const std::string head = read_part(file, at, 8);
    if (head.size() < 8) break;
    const std::uint64_t length = big_endian(std::string_view(head).substr(0, 4));
    const std::string_view name = std::string_view(head).substr(4);
    at += kAround + length;
    is_srgb = is_srgb || name == "sRGB";
    if (length > kMost) continue;
    if (name == "eXIf") {
      PhotoTags exif;
      take_exif(read_part(file, length), exif);
      tags.orientation = exif.orientation;
      tags.is_adobe_rgb = exif.is_adobe_rgb;
    } else if (name == "iCCP") {
      tags.profile = unpacked_profile(read_part(file, length));
    } else if (name == "cHRM" && length == 32) {
      tags.chromaticities = chromaticities_of(read_part(file, length));
    }
  }
  if (is_srgb || !tags.profile.empty()) tags.chromaticities.reset();
  return tags;
}

}  // namespace

PhotoTags photo_tags(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string begins = read_part(file, 8);
  file.clear();
  if (begins == "\x89PNG\r\n\x1a\n") return tags_of_png(file);
  if (begins.starts_with("\xff\xd8")) return JpegSegments(file).tags();
  if (begins.starts_with("II") || begins.starts_with("MM")) return tags_of_tiff(file);
  return {};
}

}  // namespace lentray::core
