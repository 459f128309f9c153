#include "core/image/openimageio/checked_file.h"

#include <exception>

namespace lentray::core {

/// False if the file, or an earlier work, failed.
template <class Work>
bool CheckedFile::done(Work work) const {
  if (!m_file) return false;
  try {
    work(*m_file);
    return true;
  } catch (const std::exception& error) {
    if (m_complaint.empty()) m_complaint = error.what();
    return false;
  }
}

CheckedFile::CheckedFile(const std::filesystem::path& path, SpareRoom* spare, CountBytes count)
    : IOProxy(path.string(), Write) {
  try {
    m_file.emplace(path, spare, count);
  } catch (const std::exception& error) {
    m_complaint = error.what();
  }
}

CheckedFile::~CheckedFile() { CheckedFile::close(); }

void CheckedFile::close() {
  m_mode = Closed;
  // What was given up already is not tried again.
  if (m_complaint.empty()) done([](ByteFile& file) { file.close(); });
  m_file.reset();
}

int64_t CheckedFile::tell() { return m_file ? static_cast<int64_t>(m_file->tell()) : -1; }

bool CheckedFile::seek(int64_t offset) {
  return offset >= 0 &&
         done([&](ByteFile& file) { file.seek(static_cast<std::uint64_t>(offset)); });
}

std::size_t CheckedFile::read(void* buffer, std::size_t size) {
  std::size_t count = 0;
  done([&](ByteFile& file) { count = file.read(buffer, size); });
  return count;
}

std::size_t CheckedFile::write(const void* buffer, std::size_t size) {
  return done([&](ByteFile& file) { file.write(buffer, size); }) ? size : 0;
}

std::size_t CheckedFile::pread(void* buffer, std::size_t size, int64_t offset) {
  const int64_t here = tell();
  const std::size_t count = seek(offset) ? read(buffer, size) : 0;
  seek(here);
  return count;
}

std::size_t CheckedFile::pwrite(const void* buffer, std::size_t size, int64_t offset) {
  const int64_t here = tell();
  const std::size_t count = seek(offset) ? write(buffer, size) : 0;
  seek(here);
  return count;
}

std::size_t CheckedFile::size() const {
  std::size_t bytes = 0;
  done([&](ByteFile& file) { bytes = file.size(); });
  return bytes;
}

void CheckedFile::flush() const {
  done([](ByteFile& file) { file.flush(); });
}

}  // namespace lentray::core
