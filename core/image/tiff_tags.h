// Tags of a TIFF or BigTIFF file, or of a block of Exif, which is built like one. Errors: none, what cannot be read is not
// there. One thread. Source: TIFF specification 6.0, section 2; BigTIFF.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace lentray::core {

class TiffTags {
 public:
  /// `file` must outlive it.
  explicit TiffTags(std::istream& file);
  /// Where the first directory is; 0: this is no such file.
  std::uint64_t first() const { return m_first; }
  /// Where the directory behind that one is; 0: there is none.
  std::uint64_t next(std::uint64_t directory);

  /// A whole number of the directory there.
  std::optional<std::uint64_t> number(std::uint64_t directory, std::uint16_t tag);
  std::optional<double> fraction(std::uint64_t directory, std::uint16_t tag);
  /// Numbers of two bytes; none where the file ends early.
  std::vector<std::uint16_t> words(std::uint64_t directory, std::uint16_t tag);
  /// Where its values are; 0: it is not there.
  std::uint64_t place(std::uint64_t directory, std::uint16_t tag);
  /// Bytes or characters, without zeros at the end of a text.
  std::optional<std::string> bytes(std::uint64_t directory, std::uint16_t tag);

 private:
  struct Entry {
    std::uint16_t type = 0;
    std::uint64_t count = 0, place = 0;  ///< of the values
  };
  std::optional<Entry> find(std::uint64_t directory, std::uint16_t tag);
  /// Of that many bytes; 0 beyond the end.
  std::uint64_t value(std::uint64_t at, int size);

  std::istream& m_file;
  bool m_is_big_endian = false, m_is_wide = false;
  std::uint64_t m_first = 0;
};

}  // namespace lentray::core
