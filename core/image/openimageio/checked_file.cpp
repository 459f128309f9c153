#include "core/image/openimageio/checked_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstring>

namespace lentray::core {

CheckedFile::CheckedFile(const std::filesystem::path& path)
    : IOProxy(path.string(), Write), m_buffer(std::size_t{1} << 18) {
  m_file = std::fopen(path.c_str(), "w+be");
  note(m_file == nullptr);
  if (m_file) std::setvbuf(m_file, m_buffer.data(), _IOFBF, m_buffer.size());
}

CheckedFile::~CheckedFile() { CheckedFile::close(); }

void CheckedFile::note(bool failed) const {
  if (failed && m_complaint.empty()) m_complaint = std::strerror(errno);
}

void CheckedFile::close() {
  m_mode = Closed;
  if (!m_file) return;
  note(std::fclose(m_file) != 0);
  m_file = nullptr;
}

int64_t CheckedFile::tell() { return m_file ? ::ftello(m_file) : -1; }

bool CheckedFile::seek(int64_t offset) {
  const bool done = m_file && ::fseeko(m_file, offset, SEEK_SET) == 0;
  note(!done);
  return done;
}

std::size_t CheckedFile::read(void* buffer, std::size_t size) {
  return m_file ? std::fread(buffer, 1, size, m_file) : 0;
}

std::size_t CheckedFile::write(const void* buffer, std::size_t size) {
  const std::size_t done = m_file ? std::fwrite(buffer, 1, size, m_file) : 0;
  note(done != size);
  return done;
}

std::size_t CheckedFile::pread(void* buffer, std::size_t size, int64_t offset) {
  const int64_t here = tell();
  const std::size_t done = seek(offset) ? read(buffer, size) : 0;
  seek(here);
  return done;
}

std::size_t CheckedFile::pwrite(const void* buffer, std::size_t size, int64_t offset) {
  const int64_t here = tell();
  const std::size_t done = seek(offset) ? write(buffer, size) : 0;
  seek(here);
  return done;
}

std::size_t CheckedFile::size() const {
  struct stat there {};
  flush();
  return m_file && ::fstat(::fileno(m_file), &there) == 0 ? static_cast<std::size_t>(there.st_size)
                                                          : 0;
}

void CheckedFile::flush() const {
  if (m_file) note(std::fflush(m_file) != 0);
}

}  // namespace lentray::core
