// A file to write bytes to, for encoders. Errors: std::runtime_error with the system's reason, or that of
// core/image/written_bytes.h.
//
// Where the disk or the quota has no room left, and there is spare room, what does not fit is
// held in memory until it is known how much that is: spare room is given up only where all fits
// then. One thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/spare_room.h"
#include "core/image/written_bytes.h"

namespace lentray::core {

class ByteFile {
 public:
  /// Empties the file. `spare`: null: there is none. `count`: is asked before bytes are written.
  explicit ByteFile(const std::filesystem::path& path, SpareRoom* spare = nullptr,
                    CountBytes count = nullptr);
  ~ByteFile();
  ByteFile(const ByteFile&) = delete;
  ByteFile& operator=(const ByteFile&) = delete;

  void write(const void* bytes, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// What was written; returns how many bytes there are of it.
  std::size_t read(void* bytes, std::size_t size);
  void seek(std::uint64_t place);
  std::uint64_t tell() const { return m_start + m_buffer.size(); }
  std::uint64_t size();
  void flush();
  void close();

 private:
  /// What has no room on the disk. Later ones hold where two are of one place.
  struct Piece {
    std::uint64_t place = 0;
    std::string bytes;
    std::uint64_t end() const { return place + bytes.size(); }
  };

  void put(std::uint64_t place, const char* bytes, std::size_t size);
  std::size_t put_on_disk(std::uint64_t place, const char* bytes, std::size_t size) const;
  void hold(std::uint64_t place, const char* bytes, std::size_t size);
  std::uint64_t room_to_be_had() const;
  void settle();

  int m_file = -1;
  SpareRoom* m_spare;
  const CountBytes m_count;
  std::uint64_t m_start = 0;  ///< of the buffer, in the file
  std::vector<char> m_buffer;
  std::vector<Piece> m_pieces;
  std::uint64_t m_held = 0;  ///< bytes of all pieces
  int m_why = 0;             ///< the system's number for the lack of room
};

/// `size` bytes of a number, the least first.
void put_little(std::vector<std::uint8_t>& to, std::uint64_t number, int size);

}  // namespace lentray::core
