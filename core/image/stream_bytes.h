// Pieces of a file that is read as a stream, and the numbers in them. Errors: what lies beyond the file's end is
// missing from the piece. One thread a stream.
#pragma once

#include <algorithm>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

namespace lentray::core {

/// The next `size` bytes, fewer where the file ends.
inline std::string read_part(std::istream& file, std::size_t size) {
  std::string out(size, '\0');
  file.read(out.data(), static_cast<std::streamsize>(size));
  out.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return out;
}

/// The same from a place on, also of a stream that has come to its end before.
inline std::string read_part(std::istream& file, std::uint64_t at, std::size_t size) {
  file.clear();
  file.seekg(static_cast<std::streamoff>(at));
  return read_part(file, size);
}

/// Of at most eight bytes.
inline std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

inline std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (; !bytes.empty(); bytes.remove_suffix(1))
    value = value << 8 | static_cast<unsigned char>(bytes.back());
  return value;
}

}  // namespace lentray::core
