#include "core/image/byte_file.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace lentray::core {
namespace {

[[noreturn]] void fail() { throw std::runtime_error(std::strerror(errno)); }

}  // namespace

ByteFile::ByteFile(const std::filesystem::path& path) : m_buffer(std::size_t{1} << 18) {
  m_file = std::fopen(path.c_str(), "wbe");
  if (!m_file) fail();
  std::setvbuf(m_file, m_buffer.data(), _IOFBF, m_buffer.size());
}

ByteFile::~ByteFile() {
  if (m_file) std::fclose(m_file);
}

void ByteFile::write(const void* bytes, std::size_t size) {
  if (std::fwrite(bytes, 1, size, m_file) != size) fail();
}

void ByteFile::seek(std::uint64_t place) {
  if (::fseeko(m_file, static_cast<off_t>(place), SEEK_SET) != 0) fail();
}

void ByteFile::close() {
  std::FILE* file = m_file;
  m_file = nullptr;
  if (std::fclose(file) != 0) fail();
}

void put_little(std::vector<std::uint8_t>& to, std::uint64_t number, int size) {
  for (int i = 0; i < size; ++i, number >>= 8) to.push_back(static_cast<std::uint8_t>(number));
}

}  // namespace lentray::core
