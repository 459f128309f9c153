// A file to write bytes to, for encoders of ours. Errors: std::runtime_error with the system's reason.
// One thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <vector>

namespace lentray::core {

class ByteFile {
 public:
  explicit ByteFile(const std::filesystem::path& path);
  ~ByteFile();
  ByteFile(const ByteFile&) = delete;
  ByteFile& operator=(const ByteFile&) = delete;

  void write(const void* bytes, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }
  void seek(std::uint64_t place);
  void close();

 private:
  std::vector<char> m_buffer;
  std::FILE* m_file = nullptr;
};

/// `size` bytes of a number, the least first.
void put_little(std::vector<std::uint8_t>& to, std::uint64_t number, int size);

}  // namespace lentray::core
